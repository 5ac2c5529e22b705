// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/trial_curves.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

namespace odo {

namespace {

class TrialCurvesWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialCurves)
};

/// The lines of what is outside of the range.
std::vector<ChartCurve> outsideCurves(const TrialScene &scene, Quantity quantity)
{
    std::vector<ChartCurve> outside;
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
        const auto &analysis = scene.robots[robot].analysis;
        if (!analysis || !analysis->range)
            continue;
        for (const Profile *part : {&analysis->outside.before, &analysis->outside.after}) {
            if (part->samples.empty())
                continue;
            ProfileCurves curves = profileCurves(*part, quantity, sampleTimes(*part), int(robot));
            curves.line.ink = ChartInk::Muted;
            curves.line.hasBand = false;
            outside.push_back(std::move(curves.line));
        }
    }
    return outside;
}

} // namespace

TrialCurves::TrialCurves(TrialScenePtr scene, Quantity quantity, const SamplePositions &positions,
                         bool withOutside)
    : m_scene(std::move(scene)), m_quantity(quantity)
{
    if (!m_scene)
        return;
    m_positions = paletteIndices(*m_scene);
    std::vector<ProfileCurves> robots;
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        if (const auto &analysis = m_scene->robots[robot].analysis)
            robots.push_back(profileCurves(analysis->profile, m_quantity, positions.at(robot), int(robot),
                                           m_positions[robot], otherProfiles(*m_scene, robot)));
    auto content = std::make_shared<ChartContent>();
    content->emptyWords = TrialCurvesWords::tr("No curve yet: track the trial");
    for (const auto part :
         {&ProfileCurves::measured, &ProfileCurves::bridged, &ProfileCurves::line, &ProfileCurves::spikes})
        for (ProfileCurves &curves : robots)
            content->curves.push_back(std::move(curves.*part));
    content->range = valueRange(content->curves, m_quantity);
    const std::vector<ChartCurve> outside =
        withOutside ? outsideCurves(*m_scene, m_quantity) : std::vector<ChartCurve>();
    content->curves.insert(content->curves.begin(), outside.begin(), outside.end());
    m_lines.resize(m_scene->robots.size());
    for (const ChartCurve &curve : std::span(content->curves).subspan(outside.size()))
        if (curve.kind == ChartCurve::Kind::Line)
            m_lines[static_cast<std::size_t>(curve.group)].push_back(&curve);
    m_content = std::move(content);
}

std::optional<CurveValue> TrialCurves::valueAt(std::size_t robot, Nanoseconds time) const
{
    const auto &range = m_scene->trial.range;
    if (m_lines[robot].empty() || (range && !range->contains(time)))
        return std::nullopt;
    const std::vector<Sample> &samples = m_scene->robots[robot].analysis->profile.samples;
    const auto after =
        std::upper_bound(samples.begin(), samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    if (after == samples.begin())
        return std::nullopt;
    const auto index = static_cast<std::size_t>(after - samples.begin()) - 1;
    for (const ChartCurve *line : m_lines[robot])
        for (const CurveRun &run : line->runs)
            if (index >= run.firstSample && index - run.firstSample < run.points.size())
                return run.points[index - run.firstSample].curveValue();
    return std::nullopt;
}

QList<ShownValue> TrialCurves::drawValues(QPainter &painter, const ChartPlot &plot, Nanoseconds time,
                                          const std::function<double(std::size_t robot)> &positionOf,
                                          const QPalette &palette) const
{
    QList<ShownValue> shown;
    const QString unit = curveUnit(m_quantity);
    double top = plot.rect.top();
    for (std::size_t robot = 0; robot < m_lines.size(); ++robot) {
        const auto value = valueAt(robot, time);
        const double position = positionOf(robot);
        if (!value || !(position >= plot.low && position <= plot.high))
            continue;
        const QString number = numberText(value->value, value->sigma, unit).text();
        const QString text =
            m_lines.size() > 1
                ? joinedWords(QString::fromStdString(m_scene->robots[robot].robot.name), number)
                : number;
        const QRectF bubble = drawChartBubble(painter, plot, {position, value->value}, top, text,
                                              seriesColour(m_positions[robot], palette), palette);
        shown.append({robot, bubble, number});
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

void CurveMaker::make(TrialScenePtr scene, Quantity quantity,
                      std::shared_ptr<const SamplePositions> positions, bool withOutside)
{
    m_wanted.reset();
    m_curves = {};
    if (scene && sampleCount(*scene) > mostAtOnce) {
        m_wanted = std::make_shared<Request>(
            Request{std::move(scene), quantity, std::move(positions), withOutside, {}});
        begin();
        return;
    }
    m_curves = TrialCurves(std::move(scene), quantity, *positions, withOutside);
}

void CurveMaker::begin()
{
    if (!m_wanted || m_task.isRunning()) // else it begins when that has ended
        return;
    m_running = m_wanted;
    m_task.start([request = m_running](const JobControl &) -> Result<void> {
        request->curves =
            TrialCurves(request->scene, request->quantity, *request->positions, request->withOutside);
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

namespace {

ShownUnit unitOf(Quantity quantity)
{
    constexpr double degrees = 180 / std::numbers::pi;
    switch (quantity) {
    case Quantity::Speed:
    case Quantity::VelocityX:
    case Quantity::VelocityY:
        return shownUnits().speed;
    case Quantity::Acceleration:
    case Quantity::LateralAcceleration:
        return shownUnits().acceleration;
    case Quantity::Jerk: {
        ShownUnit unit = shownUnits().acceleration;
        unit.name.replace(QStringLiteral("²"), QStringLiteral("³"));
        return unit;
    }
    case Quantity::Distance:
    case Quantity::Displacement:
    case Quantity::Separation:
        return shownUnits().distance;
    case Quantity::Heading:
        return {QStringLiteral("°"), degrees};
    case Quantity::TurnRate:
        return {QStringLiteral("°/s"), degrees};
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return shownUnits().length;
}

} // namespace

std::vector<const Profile *> otherProfiles(const TrialScene &scene, std::size_t robot)
{
    std::vector<const Profile *> others;
    for (std::size_t other = 0; other < scene.robots.size(); ++other)
        if (other != robot && scene.robots[other].analysis)
            others.push_back(&scene.robots[other].analysis->profile);
    return others;
}

std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity,
                                                   OtherProfiles others)
{
    auto values = quantityValues(profile, quantity, others);
    const double factor = curveFactor(quantity);
    for (auto &value : values)
        if (value)
            value = CurveValue{factor * value->value, factor * value->sigma};
    return values;
}

QString curveUnit(Quantity quantity)
{
    return unitOf(quantity).name;
}

double curveFactor(Quantity quantity)
{
    return unitOf(quantity).perSi;
}

std::vector<double> sampleTimes(const Profile &profile)
{
    std::vector<double> times;
    times.reserve(profile.samples.size());
    for (const Sample &sample : profile.samples)
        times.push_back(toSeconds(sample.time));
    return times;
}

ValueRange valueRange(const std::vector<ChartCurve> &curves, Quantity quantity)
{
    std::vector<const CurveRun *> runs;
    for (const ChartCurve &curve : curves)
        for (const CurveRun &run : curve.runs)
            if (curve.kind == ChartCurve::Kind::Line && run.isLine())
                runs.push_back(&run);
    const bool isAtPosition = quantity == Quantity::PositionX || quantity == Quantity::PositionY;
    double low = isAtPosition && !runs.empty() ? runs.front()->points.front().value : 0, high = low;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, double(point.value));
            high = std::max(high, double(point.value));
        }
    const double room = 0.25 * std::max(1e-3, high - low);
    // A speed or a distance is not negative, whatever its σ.
    const bool isLength = quantity == Quantity::Speed || quantity == Quantity::Distance ||
                          quantity == Quantity::Displacement || quantity == Quantity::Separation;
    const double least = isLength ? std::max(0.0, low - room) : low - room, most = high + room;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, std::max(point.low(), least));
            high = std::max(high, std::min(point.high(), most));
        }
    return {low, high - low < 1e-6 ? low + 1 : high};
}

CurveRun measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &positions)
{
    CurveRun measured;
    const auto values = measuredValues(profile, quantity);
    measured.points.reserve(static_cast<std::size_t>(std::ranges::count_if(
        values, [](const std::optional<CurveValue> &value) { return value.has_value(); })));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            measured.points.emplace_back(positions[i],
                                         CurveValue{curveFactor(quantity) * values[i]->value, 0});
    return measured;
}

CurveRun spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &positions)
{
    CurveRun spikes;
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (quantity != Quantity::Speed || index >= profile.points.size())
            continue;
        const auto measured = measuredSpeed(profile, index);
        if (measured || profile.points[index].valid)
            spikes.points.emplace_back(positions[index],
                                       CurveValue{curveFactor(Quantity::Speed) *
                                                      (measured ? *measured : profile.points[index].speedMps),
                                                  0});
    }
    return spikes;
}

ProfileCurves profileCurves(const Profile &profile, Quantity quantity, const std::vector<double> &positions,
                            int group, int position, OtherProfiles others)
{
    ProfileCurves curves;
    for (ChartCurve *curve : {&curves.measured, &curves.bridged, &curves.line, &curves.spikes}) {
        curve->group = group;
        curve->position = position;
    }
    curves.measured.kind = ChartCurve::Kind::Points;
    curves.measured.ink = ChartInk::Point;
    curves.measured.widthPx = 1;
    curves.measured.runs = {measuredPoints(profile, quantity, positions)};
    const auto values = curveValues(profile, quantity, others);
    const std::vector<ProfilePiece> pieces = piecesOf(profile);
    curves.line.dash = seriesDash(group);
    curves.line.hasBand = curves.bridged.hasBand = true;
    curves.line.runs = curveRuns(values, positions, pieces);
    curves.bridged.dash = Qt::DotLine;
    curves.bridged.runs = curveRuns(values, positions, pieces, true);
    curves.spikes.kind = ChartCurve::Kind::Spikes;
    curves.spikes.ink = ChartInk::Spike;
    curves.spikes.runs = {spikePoints(profile, quantity, positions)};
    return curves;
}

} // namespace odo
