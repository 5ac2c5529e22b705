// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_map.h"

#include "ui/report/report_chart.h"
#include "ui/report/report_painting.h"
#include "ui/views/comparison_painting.h"
#include "ui/views/task_overlay.h"
#include "ui/views/theme.h"
#include "ui/views/trail_painting.h"

#include <QPainter>
#include <algorithm>
#include <functional>

namespace odo {

namespace {

/// Ground, grid and markers in a frame, and whatever comes on them.
void drawFramed(QPainter &painter, const QRectF &rect, const Eigen::AlignedBox2d &bounds,
                const std::optional<MarkerLayout> &layout, const std::function<void(const MapPlan &)> &drawRest)
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

void drawOtherWay(QPainter &painter, const MapPlan &plan, const Profile &profile)
{
    QPolygonF run;
    const auto draw = [&] {
        painter.drawPolyline(run);
        run.clear();
    };
    painter.setPen(QPen(ThemeColours::of(reportPalette()).point, 1.2));
    for (const ProfilePoint &point : profile.points) {
        if (point.valid)
            run << plan.fromWorld(point.position);
        else
            draw();
    }
    draw();
}

/// Beside its place, where it covers no other number as far as there is room.
void drawNumbers(QPainter &painter, const MapPlan &plan, const std::vector<RunEvent> &events)
{
    constexpr double away = 11;
    static const QPointF sides[] = {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1.6}, {1.6, 0}, {-1.6, 0}, {0, 1.6}};
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

/// Gates or zones with names as they may stand on paper.
template <class Named>
std::vector<Named> literal(std::vector<Named> all)
{
    for (Named &each : all)
        each.name = literalName(each.name).toStdString();
    return all;
}

} // namespace

void drawRunMap(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t robot,
                const std::vector<RunEvent> &events)
{
    const QPalette &palette = reportPalette();
    drawFramed(painter, rect, scene.floorBounds(), scene.layout, [&](const MapPlan &plan) {
        const auto toPage = [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); };
        if (scene.task) {
            drawZones(painter, literal(scene.task->zones), toPage, palette);
            drawReferencePath(painter, scene.task->path, toPage, palette);
        }
        for (std::size_t other = 0; other < scene.robots.size(); ++other)
            if (other != robot && scene.robots[other].analysis)
                drawOtherWay(painter, plan, scene.robots[other].analysis->profile);
        const double top = topSpeedMps(scene);
        if (scene.robots.size() > robot && scene.robots[robot].analysis)
            drawSpeedTrail(painter, plan, scene.robots[robot].analysis->profile, top, palette);
        if (scene.task)
            drawGates(painter, literal(scene.task->gates), toPage, palette);
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
    drawFramed(painter, rect, scene.floorBounds(), first.layout, [&](const MapPlan &plan) {
        const ReferencePath &path = scene.compared.comparison.path;
        if (first.task)
            drawZones(
                painter, literal(first.task->zones), [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
        if (scene.compared.comparison.isTasksPath)
            drawReferencePath(
                painter, path, [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); }, palette);
        drawWays(painter, plan, scene, runs, palette);
        for (const PathGate &gate : scene.compared.gates)
            drawPathGate(painter, pathGateLine(plan, path, gate), literalName(gate.name), false, palette);
    });
}

} // namespace odo
