// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"

#include <QPointF>
#include <QString>
#include <functional>

class QColor;
class QPainter;
class QPainterPath;

namespace odo {

/// From a recording's picture (pixel centres) to where it is painted.
using PictureMap = std::function<QPointF(const QPointF &pixel)>;

/// The outline of what a view took for a robot, where it is painted: the polygon that its support lines bound, or its ellipse where only that was
/// measured. Closed; empty where it was not found. outside: so much beyond its edge, where it is painted. Pure.
QPainterPath outlinePath(const Observation &observation, const PictureMap &map, double outside = 0);

/// A line just outside of that outline in a robot's colour, with a dark casing that shows it on any floor; dashed where the picture's border cuts the robot.
/// The robot's name stands beside it, also without the line. Gives the middle of its upper side.
QPointF paintOutline(QPainter &painter, const Observation &observation, const QString &name, const QColor &colour, const PictureMap &map,
                     bool withLine = true);

} // namespace odo
