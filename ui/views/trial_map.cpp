// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/trial_map.h"

#include "ui/models/profile_place.h"
#include "ui/views/floor_picture.h"
#include "ui/views/robot_colours.h"
#include "ui/views/task_overlay.h"
#include "ui/views/theme.h"
#include "ui/views/trail_painting.h"

#include <QPainter>

namespace odo {

void drawMapFloor(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorPicture &floor,
                  double opacity, const QPalette &palette)
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!floor.image.isNull()) {
        painter.setOpacity(opacity);
        painter.drawImage(QRectF(plan.fromWorld({floor.extent.min().x(), floor.extent.max().y()}),
                                 plan.fromWorld({floor.extent.max().x(), floor.extent.min().y()})),
                          floor.image);
        painter.setOpacity(1);
    }
    drawMapFoot(painter, plan, palette);
    drawMapGrid(painter, plan, palette, !floor.image.isNull());
    if (scene.layout)
        drawMapMarkers(painter, plan, *scene.layout, palette);
    if (scene.task)
        drawZones(
            painter, scene.task->zones, [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); },
            palette);
}

void drawMapGround(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorPicture &floor,
                   const QPalette &palette)
{
    constexpr double muted = 0.55; // the trail comes first
    drawMapFloor(painter, plan, scene, floor, muted, palette);
    if (scene.task)
        drawReferencePath(
            painter, scene.task->path, [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); },
            palette);
    drawMapDoubts(painter, plan, scene, palette);
}

void drawMapMarks(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const QPalette &palette)
{
    if (scene.task)
        drawGates(
            painter, scene.task->gates, [&plan](const Eigen::Vector2d &point) { return plan.fromWorld(point); },
            palette);
    for (const SceneRobot &robot : scene.robots) {
        if (robot.analysis)
            drawMapSpikes(painter, plan, robot.analysis->profile, palette);
    }
}

void drawTrialRobots(QPainter &painter, const MapPlan &plan, const TrialScene &scene, Nanoseconds time,
                     const QPalette &palette)
{
    const bool alone = scene.robots.size() == 1;
    const std::vector<int> places = colourPlaces(scene);
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
        const SceneRobot &shown = scene.robots[robot];
        const std::ptrdiff_t index = shown.analysis ? pointIndexAt(shown.analysis->profile, time) : -1;
        if (index < 0)
            continue;
        const Profile &profile = shown.analysis->profile;
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
        MapRobot sign{&shown.robot,
                      point.position,
                      point.sigmaXM,
                      point.sigmaYM,
                      drivenHeadingAt(profile, index),
                      alone ? drawnColour(shown.robot.drawingColour, ThemeColours::of(palette).spike, palette)
                            : seriesColour(places[robot], palette),
                      {},
                      scene.referenceM(robot)};
        if (!alone)
            sign.label = QString::fromStdString(shown.robot.name);
        drawMapRobot(painter, plan, sign, palette);
    }
}

} // namespace odo
