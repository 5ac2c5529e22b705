// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/map/map_painting.h"

#include <QLineF>
#include <vector>

class QPainter;
class QPalette;

namespace odo {

/// The ways of these runs in their colours and dashes, the first one on top.
void drawWays(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
              const std::vector<std::size_t> &runs, const QPalette &palette);

/// Where a gate of the common path lies across it on the map.
QLineF pathGateLine(const MapPlan &plan, const ReferencePath &path, const PathGate &gate);
/// That line with its name.
void drawPathGate(QPainter &painter, const QLineF &line, const QString &name, bool isChosen,
                  const QPalette &palette);

} // namespace odo
