// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/outline_painting.h"

#include <QColor>
#include <QPointF>
#include <QString>
#include <functional>

class QPainter;

namespace odo {

/// What a mode adds to the picture of a view in a frame.
using PictureOverlay =
    std::function<void(QPainter &painter, std::size_t view, std::int64_t frame, const PictureMap &map)>;

/// The rectangle of the markers with a line every round distance, seen by the camera.
void paintFloorGrid(QPainter &painter, const TrialScene &scene, const FloorView &view, const PictureMap &map);
/// O→U and O→V as lines and the markers' labels.
void paintAxes(QPainter &painter, const TrialScene &scene, const FloorView &view, const PictureMap &map);
/// A way on the floor at a height; broken where a place is missing.
void paintWay(QPainter &painter, const std::vector<std::optional<Eigen::Vector2d>> &places, double heightM,
              const FloorView &view, const PictureMap &map, const QColor &colour);
/// A robot that was not there: its box on the floor, where it would be seen, dashed, with a name. A robot whose size is not known
/// is a box of 200 mm.
struct GhostRobot
{
    const RobotRecord *robot = nullptr;
    double heightM = 0; ///< 0: not known
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double headingRad = 0;
    QColor colour;
    QString name;
};
void paintGhost(QPainter &painter, const GhostRobot &ghost, const FloorView &view, const PictureMap &map);
/// A robot's smoothed track at the height that its positions were computed for.
void paintTrail(QPainter &painter, const TrialScene &scene, std::size_t robot, const FloorView &view,
                const PictureMap &map, const QColor &colour);
/// How robots are drawn in pictures.
struct RobotLook
{
    std::optional<QColor> colour = {}; ///< of trails and outlines; empty: of each robot its own (colourOnPicture)
    bool withOutlines = true;
};
/// What does not move in a picture: the floor's grid, the trails of all robots, and the axes. Nothing where the view is not
/// registered.
void paintFloor(QPainter &painter, const TrialScene &scene, std::size_t view, const PictureMap &map, const RobotLook &look = {});
/// The outline of what was taken for the robot in a frame of this view, its name, and the reason when it is a spike. Where it was not found
/// because it was hidden: its name and the reason at the place where it must be; otherwise nothing.
void paintRobot(QPainter &painter, const TrialScene &scene, std::size_t view, std::size_t robot,
                std::int64_t frame, const PictureMap &map, const RobotLook &look = {});

} // namespace odo
