// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/run_painting.h"

#include "core/analysis/motion_stretches.h"
#include "core/analysis/quantity_curve.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/models/trial_scene.h"
#include "ui/report/internal/report_painting.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

namespace odo {

namespace {

class RunEventsWords
{
    Q_DECLARE_TR_FUNCTIONS(RunEvents)
};

/// An event with how much it matters: of two the one of less weight goes first.
struct Weighed
{
    RunEvent event;
    int weight = 0;
};
constexpr int motionWeight = 40000, mostGapWeight = 39999, gateWeight = 20000, mostSpikeWeight = 10000;

std::optional<Eigen::Vector2d> positionAt(const Profile &profile, Nanoseconds time)
{
    const std::ptrdiff_t index = pointIndexAt(profile, time);
    if (index < 0)
        return std::nullopt;
    return profile.points[std::size_t(index)].position;
}

void addMotion(const Profile &profile, std::vector<Weighed> &events)
{
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    if (motions.empty())
        return;
    const auto add = [&](const RunInstant &at, double timeS, const QString &words) {
        events.push_back(
            {{RunEvent::Kind::Motion, 0, fromSeconds(timeS), fromSeconds(timeS), at.point->position, words},
             motionWeight});
    };
    add(instants[motions.front().first], motions.front().startS,
        motions.front().first == 0 ? RunEventsWords::tr("First seen, moving already")
                                   : RunEventsWords::tr("Starts to move"));
    add(instants[motions.back().last], motions.back().stopS,
        motions.back().last + 1 == instants.size() ? RunEventsWords::tr("Last seen, still moving")
                                                   : RunEventsWords::tr("Stops"));
}

void addTopSpeed(const Profile &profile, std::vector<Weighed> &events)
{
    // As max_speed of core/analysis/metrics.h: an uncertain point does not win by its uncertainty.
    const auto sureSpeed = [](const ProfilePoint &point) {
        return point.valid ? point.speedMps - 2 * point.sigmaSpeedMps : -1;
    };
    const auto top = std::ranges::max_element(profile.points, {}, sureSpeed);
    if (top == profile.points.end() || sureSpeed(*top) <= 0)
        return;
    const Nanoseconds time = profile.samples[std::size_t(top - profile.points.begin())].time;
    events.push_back({{RunEvent::Kind::TopSpeed, 0, time, time, top->position,
                       RunEventsWords::tr("Top speed, %1").arg(speedText(top->speedMps, top->sigmaSpeedMps))},
                      motionWeight});
}

void addGaps(const Profile &profile, std::vector<Weighed> &events)
{
    for (const TimeSpan &gap : profile.gaps) {
        const auto position = positionAt(profile, gap.begin);
        const double seconds = toSeconds(gap.end - gap.begin);
        if (position)
            events.push_back(
                {{RunEvent::Kind::Gap, 0, gap.begin, gap.end, *position,
                  RunEventsWords::tr("Not measured for %1").arg(secondsText(gap.end - gap.begin))},
                 int(std::min<double>(gateWeight + 1 + 10 * seconds, mostGapWeight))});
    }
}

void addGates(const Profile &profile, std::vector<Weighed> &events)
{
    for (const GatePassage &passage : profile.passages) {
        const auto position = positionAt(profile, passage.time);
        if (position)
            events.push_back({{RunEvent::Kind::Gate, 0, passage.time, passage.time, *position,
                               RunEventsWords::tr("Passes %1").arg(QString::fromStdString(passage.gate))},
                              gateWeight});
    }
}

void addSpikes(const Profile &profile, std::vector<Weighed> &events)
{
    constexpr std::int64_t apart = 5; // samples, that still are one event
    for (std::size_t first = 0; first < profile.spikes.size();) {
        std::size_t end = first + 1;
        while (end < profile.spikes.size() &&
               profile.spikes[end].sampleIndex - profile.spikes[end - 1].sampleIndex <= apart)
            ++end;
        const Spike &spike = profile.spikes[first];
        const auto count = int(end - first);
        const auto &sample = profile.samples[std::size_t(spike.sampleIndex)];
        const auto position = sample.position ? sample.position : positionAt(profile, spike.time);
        if (position) {
            QString words = RunEventsWords::tr("Spike: %1").arg(shownWords(spike.reason));
            if (count > 1)
                words += QStringLiteral(" ") + RunEventsWords::tr("(%n samples)", "", count);
            events.push_back(
                {{RunEvent::Kind::Spike, 0, spike.time, profile.spikes[end - 1].time, *position, words},
                 std::min(count, mostSpikeWeight)});
        }
        first = end;
    }
}

} // namespace

std::vector<RunEvent> runEvents(const Profile &profile, std::size_t most)
{
    std::vector<Weighed> found;
    addMotion(profile, found);
    addTopSpeed(profile, found);
    addGaps(profile, found);
    addGates(profile, found);
    addSpikes(profile, found);
    std::ranges::stable_sort(found, std::ranges::greater(), &Weighed::weight);
    found.resize(std::min(found.size(), most));
    std::ranges::stable_sort(found, {}, [](const Weighed &each) { return each.event.time; });
    std::vector<RunEvent> events;
    for (Weighed &each : found) {
        each.event.number = int(events.size()) + 1;
        events.push_back(std::move(each.event));
    }
    return events;
}

namespace {

class ReportChartWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportChart)
};

QString titleOf(Quantity quantity)
{
    return quantity == Quantity::Speed
               ? ReportChartWords::tr("Speed, %1").arg(curveUnit(quantity))
               : ReportChartWords::tr("Acceleration along the path, %1").arg(curveUnit(quantity));
}

/// Slanted lines over the time of the spikes: they survive a copier.
void drawHatch(QPainter &painter, const ChartPlot &plot, double from, double to)
{
    constexpr double least = 5, apart = 4;
    const double middle = (plot.at(from, 0).x() + plot.at(to, 0).x()) / 2;
    const double half = std::max(least, plot.at(to, 0).x() - plot.at(from, 0).x()) / 2;
    const QRectF box =
        QRectF(middle - half, plot.rect.top(), 2 * half, plot.rect.height()).intersected(plot.rect);
    painter.save();
    painter.setClipRect(box);
    painter.setPen(QPen(ThemeColours::of(reportPalette()).spike, 0.6));
    for (double y = box.top() - box.width(); y < box.bottom() + box.width(); y += apart)
        painter.drawLine(QPointF(box.left(), y + box.width()), QPointF(box.right(), y));
    painter.restore();
}

void drawEvents(QPainter &painter, const ChartPlot &plot, const std::vector<RunEvent> &events)
{
    double last = -std::numeric_limits<double>::infinity();
    for (const RunEvent &event : events) {
        const double x = plot.at(toSeconds(event.time), 0).x();
        if (event.kind != RunEvent::Kind::Spike) {
            painter.setPen(QPen(ThemeColours::of(reportPalette()).muted, 0.8, Qt::DotLine));
            painter.drawLine(QPointF(x, plot.rect.top()), QPointF(x, plot.rect.bottom()));
        }
        // Numbers that are close together go side by side.
        last = std::max(x, last + 2 * eventNumberRadius + 1);
        drawEventNumber(painter, QPointF(last, plot.rect.top() - eventNumberRadius - 1), event);
    }
}

} // namespace

void drawEventNumber(QPainter &painter, const QPointF &centre, const RunEvent &event)
{
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const bool isSpike = event.kind == RunEvent::Kind::Spike;
    const QRectF box(centre.x() - eventNumberRadius, centre.y() - eventNumberRadius, 2 * eventNumberRadius,
                     2 * eventNumberRadius);
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(isSpike ? colours.spike : colours.text);
    if (isSpike)
        painter.drawRect(box);
    else
        painter.drawEllipse(box);
    painter.setFont(reportFont(smallSize - 1, QFont::DemiBold));
    painter.setPen(colours.card);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, QString::number(event.number));
}

void drawRunChart(QPainter &painter, const QRectF &rect, const Profile &profile, Quantity quantity,
                  const std::vector<RunEvent> &events)
{
    const QPalette &palette = reportPalette();
    const ThemeColours colours = ThemeColours::of(palette);
    const QRectF area = drawPartTitle(
        painter, rect, titleOf(quantity),
        profile.gaps.empty()
            ? ReportChartWords::tr("smoothed, with its ±95 % band; dots: as measured")
            : ReportChartWords::tr("smoothed, with its ±95 % band; dots: as measured; shaded: not measured"));
    constexpr double numberWidth = 6; // for the events above
    const std::vector<double> times = sampleTimes(profile);
    ProfileCurves curves = profileCurves(profile, quantity, times);
    std::erase_if(curves.line.runs, [](const CurveRun &run) { return !run.isLine(); });
    if (curves.line.runs.empty()) {
        drawLine(painter, area, ReportChartWords::tr("No curve: the robot was not detected"),
                 reportFont(bodySize), colours.muted, Qt::AlignCenter);
        return;
    }
    auto content = std::make_shared<ChartContent>();
    content->curves = {std::move(curves.measured), std::move(curves.bridged), std::move(curves.line),
                       std::move(curves.spikes)};
    content->range = valueRange(content->curves, quantity);
    ChartDrawing drawing;
    drawing.content = std::move(content);
    drawing.low = times.front();
    drawing.high = std::max(times.back(), times.front() + 1e-3);
    for (const TimeSpan &gap : profile.gaps)
        drawing.stretches.push_back({toSeconds(gap.begin), toSeconds(gap.end)});
    const ChartPlot plot =
        drawChart(painter, area.adjusted(0, numberWidth, 0, 0), drawing, palette, reportFont(smallSize));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const RunEvent &event : events)
        if (event.kind == RunEvent::Kind::Spike)
            drawHatch(painter, plot, toSeconds(event.time), toSeconds(event.until));
    drawEvents(painter, plot, events);
    painter.restore();
}

void drawFramedMap(QPainter &painter, const QRectF &rect, const Eigen::AlignedBox2d &bounds,
                   const std::optional<MarkerLayout> &layout,
                   const std::function<void(const MapPlan &)> &drawRest)
{
    const QPalette &palette = reportPalette();
    const ThemeColours colours = ThemeColours::of(palette);
    painter.save();
    painter.setClipRect(rect);
    painter.translate(rect.topLeft());
    painter.setFont(reportFont(smallSize));
    const MapPlan plan{bounds, rect.size()};
    painter.fillRect(QRectF(QPointF(0, 0), rect.size()), colours.mapGround);
    drawMapFoot(painter, plan, palette);
    drawMapGrid(painter, plan, palette, false);
    if (layout)
        drawMapMarkers(painter, plan, *layout, palette);
    drawRest(plan);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.border, 0.8));
    painter.drawRect(rect);
}

namespace {

void drawOtherWay(QPainter &painter, const MapPlan &plan, const Profile &profile)
{
    for (const ProfilePiece &piece : piecesOf(profile)) {
        QPolygonF run;
        for (std::size_t i = piece.first; i <= piece.last; ++i)
            run << plan.fromWorld(profile.points[i].position);
        painter.setPen(QPen(ThemeColours::of(reportPalette()).point, 1.2,
                            piece.isBridged ? Qt::DotLine : Qt::SolidLine));
        painter.drawPolyline(run);
    }
}

/// Beside its position, without covering another number if possible.
void drawNumbers(QPainter &painter, const MapPlan &plan, const std::vector<RunEvent> &events)
{
    constexpr double away = 11;
    static const QPointF sides[] = {{1, -1},   {-1, -1}, {1, 1},    {-1, 1},
                                    {0, -1.6}, {1.6, 0}, {-1.6, 0}, {0, 1.6}};
    std::vector<QPointF> taken;
    for (const RunEvent &event : events) {
        const QPointF at = plan.fromWorld(event.position);
        const auto isFree = [&](const QPointF &centre) {
            return std::ranges::none_of(taken, [&](const QPointF &other) {
                return QLineF(centre, other).length() < 2 * eventNumberRadius + 1;
            });
        };
        QPointF centre = at + away * sides[0];
        for (double reach = away; !isFree(centre) && reach < 5 * away; reach += away)
            for (const QPointF &side : sides)
                if (!isFree(centre))
                    centre = at + reach * side;
        taken.push_back(centre);
        painter.setPen(QPen(ThemeColours::of(reportPalette()).text, 0.7));
        painter.drawLine(at, centre);
        drawEventNumber(painter, centre, event);
    }
}

} // namespace

void drawRunMap(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t robot,
                const std::vector<RunEvent> &events)
{
    const QPalette &palette = reportPalette();
    drawFramedMap(painter, rect, scene.floorBounds(), scene.layout, [&](const MapPlan &plan) {
        const auto toPage = [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); };
        if (scene.task) {
            drawZones(painter, literalNames(scene.task->zones), toPage, palette);
            drawReferencePath(painter, scene.task->path, toPage, palette);
        }
        for (std::size_t other = 0; other < scene.robots.size(); ++other)
            if (other != robot && scene.robots[other].analysis)
                drawOtherWay(painter, plan, scene.robots[other].analysis->profile);
        const double top = topSpeedMps(scene);
        if (scene.robots.size() > robot && scene.robots[robot].analysis)
            drawSpeedTrail(painter, plan, scene.robots[robot].analysis->profile, top, palette);
        if (scene.task)
            drawGates(painter, literalNames(scene.task->gates), toPage, palette);
        if (scene.robots.size() > robot && scene.robots[robot].analysis)
            drawMapSpikes(painter, plan, scene.robots[robot].analysis->profile, palette);
        drawSpeedLegend(painter, plan, top, palette);
        drawNumbers(painter, plan, events);
    });
}

void drawComparedMap(QPainter &painter, const QRectF &rect, const ComparisonScene &scene,
                     const std::vector<std::size_t> &runs)
{
    const QPalette &palette = reportPalette();
    const TrialScene &first = *scene.scenes.front();
    drawFramedMap(painter, rect, scene.floorBounds(), first.layout, [&](const MapPlan &plan) {
        const ReferencePath &path = scene.compared.comparison.path;
        if (first.task)
            drawZones(
                painter, literalNames(first.task->zones),
                [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
        if (scene.compared.comparison.isTasksPath)
            drawReferencePath(
                painter, path, [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); },
                palette);
        drawPaths(painter, plan, scene, runs, palette);
        for (const PathGate &gate : scene.compared.gates)
            drawPathGate(painter, pathGateLine(plan, path, gate), literalName(gate.name), false, palette);
    });
}

} // namespace odo
