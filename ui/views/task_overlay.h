// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/task.h"

#include <QPointF>
#include <functional>

class QPainter;
class QPalette;

namespace odo {

/// From a point of the floor, metres, to the screen.
using FloorToScreen = std::function<QPointF(const Eigen::Vector2d &)>;

/// The course that is to be followed, dashed so that it is not taken for one that was driven.
void drawReferencePath(QPainter &painter, const ReferencePath &path, const FloorToScreen &toScreen,
                       const QPalette &palette);
/// Each zone as an outline with its name: one to keep out of is hatched, of one to stay in the edge has teeth on its outer side.
void drawZones(QPainter &painter, const std::vector<Zone> &zones, const FloorToScreen &toScreen, const QPalette &palette);
/// Each gate as a line between two posts with its name, and an arrow the way it is passed; start and finish are
/// heavier than splits.
void drawGates(QPainter &painter, const std::vector<Gate> &gates, const FloorToScreen &toScreen,
               const QPalette &palette);

} // namespace odo
