// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QPointF>
#include <functional>

class QPainter;

namespace odo {

/// From a recording's picture (pixel centres) to where it is painted.
using PictureMap = std::function<QPointF(const QPointF &pixel)>;

/// The rectangle of the markers with a line every round distance, seen by the camera.
void paintFloorGrid(QPainter &painter, const TrialScene &scene, const FloorView &view, const PictureMap &map);
/// O→U and O→V as lines and the markers' labels.
void paintAxes(QPainter &painter, const TrialScene &scene, const FloorView &view, const PictureMap &map);
/// A way on the floor at a height; broken where a place is missing.
void paintWay(QPainter &painter, const std::vector<std::optional<Eigen::Vector2d>> &places, double heightM,
              const FloorView &view, const PictureMap &map);
/// What the tracker found, with the robot's name beside it; gives the middle of its upper side.
QPointF paintEllipse(QPainter &painter, const Ellipse &ellipse, const QString &name, const PictureMap &map);
/// A robot's smoothed track at the height that its positions were computed for.
void paintTrail(QPainter &painter, const TrialScene &scene, std::size_t robot, const FloorView &view,
                const PictureMap &map);
/// The ellipse that the tracker found in a frame of this view, the robot's name, and the reason when it is a
/// spike.
void paintRobot(QPainter &painter, const TrialScene &scene, std::size_t view, std::size_t robot,
                std::int64_t frame, const PictureMap &map);

} // namespace odo
