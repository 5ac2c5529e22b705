// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/trial_curves.h"

#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/views/curve_painting.h"
#include "ui/views/robot_colours.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace odo {
namespace {

class TrialCurvesWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialCurves)
};

} // namespace

TrialCurves::TrialCurves(TrialScenePtr scene, Quantity quantity, const SamplePlaces &places)
    : m_scene(std::move(scene)), m_quantity(quantity)
{
    std::vector<const CurveRun *> runs;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        m_curves.push_back(analysis ? curvesOf(analysis->profile, places.at(robot)) : RobotCurves());
    }
    for (const RobotCurves &curves : m_curves)
        for (const CurveRun &run : curves.runs)
            if (run.isLine())
                runs.push_back(&run);
    m_range = valueRange(runs, m_quantity);
    if (m_scene)
        m_places = colourPlaces(*m_scene);
}

TrialCurves::RobotCurves TrialCurves::curvesOf(const Profile &profile, const std::vector<double> &places) const
{
    RobotCurves curves;
    curves.runs = curveRuns(curveValues(profile, m_quantity), places);
    curves.measured = measuredPoints(profile, m_quantity, places);
    curves.spikes = spikePoints(profile, m_quantity, places);
    return curves;
}

std::optional<CurveValue> TrialCurves::valueAt(std::size_t robot, Nanoseconds time) const
{
    const auto &analysis = m_scene->robots[robot].analysis;
    if (!analysis)
        return std::nullopt;
    const std::vector<Sample> &samples = analysis->profile.samples;
    const auto after =
        std::upper_bound(samples.begin(), samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    if (after == samples.begin())
        return std::nullopt;
    const auto index = static_cast<std::size_t>(after - samples.begin()) - 1;
    for (const CurveRun &run : m_curves[robot].runs)
        if (index >= run.firstSample && index - run.firstSample < run.points.size())
            return run.points[index - run.firstSample].curveValue();
    return std::nullopt;
}

void TrialCurves::draw(QPainter &painter, const ChartPlot &plot, const QPalette &palette) const
{
    bool isEmpty = true;
    for (const RobotCurves &curves : m_curves)
        drawCurvePoints(painter, plot, curves.measured, ThemeColours::of(palette).point);
    for (std::size_t robot = 0; robot < m_curves.size(); ++robot)
        for (const CurveRun &run : m_curves[robot].runs) {
            if (!run.isLine())
                continue;
            drawCurveRun(painter, plot, run, {seriesColour(m_places[robot], palette), seriesDash(int(robot))});
            isEmpty = false;
        }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const RobotCurves &curves : m_curves)
        drawChartSpikes(painter, plot, curves.spikes, palette);
    if (m_scene && isEmpty) {
        painter.setPen(ThemeColours::of(palette).muted);
        painter.drawText(plot.rect, Qt::AlignCenter, TrialCurvesWords::tr("No curve yet: track the trial"));
    }
}

QList<ShownValue> TrialCurves::drawValues(QPainter &painter, const ChartPlot &plot, Nanoseconds time,
                             const std::function<double(std::size_t robot)> &placeOf, const QPalette &palette) const
{
    QList<ShownValue> shown;
    const QString unit = curveUnit(m_quantity);
    double top = plot.rect.top();
    for (std::size_t robot = 0; robot < m_curves.size(); ++robot) {
        const auto value = valueAt(robot, time);
        const double place = placeOf(robot);
        if (!value || place < plot.low || place > plot.high)
            continue;
        const QString figure = figureText(value->value, value->sigma, unit).text();
        const QString text =
            m_curves.size() > 1 ? joinedWords(QString::fromStdString(m_scene->robots[robot].robot.name), figure) : figure;
        const QRectF bubble = drawChartBubble(painter, plot, {place, value->value}, top, text,
                                              seriesColour(m_places[robot], palette), palette);
        shown.append({robot, bubble, figure});
        top = bubble.bottom() + bubbleGap;
    }
    return shown;
}

} // namespace odo
