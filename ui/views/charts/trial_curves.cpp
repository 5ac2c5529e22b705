// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/trial_curves.h"

#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/views/charts/profile_curve.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <utility>

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

TrialCurves::RobotCurves TrialCurves::curvesOf(const Profile &profile,
                                               const std::vector<double> &places) const
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
            drawCurveRun(painter, plot, run,
                         {seriesColour(m_places[robot], palette), seriesDash(int(robot))});
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
                                          const std::function<double(std::size_t robot)> &placeOf,
                                          const QPalette &palette) const
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
            m_curves.size() > 1
                ? joinedWords(QString::fromStdString(m_scene->robots[robot].robot.name), figure)
                : figure;
        const QRectF bubble = drawChartBubble(painter, plot, {place, value->value}, top, text,
                                              seriesColour(m_places[robot], palette), palette);
        shown.append({robot, bubble, figure});
        top = bubble.bottom() + bubbleGap;
    }
    return shown;
}

namespace {

std::size_t sampleCount(const TrialScene &scene)
{
    std::size_t count = 0;
    for (const SceneRobot &robot : scene.robots)
        count += robot.analysis ? robot.analysis->profile.samples.size() : 0;
    return count;
}

} // namespace

CurveMaker::CurveMaker(QObject *parent) : QObject(parent)
{
    connect(&m_task, &BackgroundTask::finished, this, &CurveMaker::finish);
}

void CurveMaker::make(TrialScenePtr scene, Quantity quantity, std::shared_ptr<const SamplePlaces> places)
{
    m_wanted.reset();
    m_curves = {};
    if (scene && sampleCount(*scene) > mostAtOnce) {
        m_wanted = std::make_shared<Request>(Request{std::move(scene), quantity, std::move(places), {}});
        begin();
        return;
    }
    m_curves = TrialCurves(std::move(scene), quantity, *places);
}

void CurveMaker::begin()
{
    if (!m_wanted || m_task.isRunning()) // else it begins when that has ended
        return;
    m_running = m_wanted;
    m_task.start([request = m_running](const JobControl &) -> Result<void> {
        request->curves = TrialCurves(request->scene, request->quantity, *request->places);
        return {};
    });
}

void CurveMaker::finish()
{
    const auto done = std::exchange(m_running, nullptr);
    if (!m_wanted || m_wanted != done)
        return begin(); // it was overtaken
    m_wanted.reset();
    m_curves = std::move(done->curves);
    Q_EMIT made();
}

} // namespace odo
