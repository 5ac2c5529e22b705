// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/chart_painting.h"
#include "ui/views/comparison_curves.h"
#include "ui/views/map_painting.h"

#include <QLineF>

class QPainter;
class QPalette;

namespace odo {

/// Where curves against the distance lie in a rectangle: all of the way the runs have in common below, 0 among
/// the values.
ChartPlot comparedPlot(const QRectF &rect, const ComparisonScene *scene, Compared what,
                       const std::vector<DistanceCurve> &curves);

/// Axes and curves, each run in its colour and dash; grey where a difference is within its error, with a line
/// where neither is ahead.
void drawComparedCurves(QPainter &painter, const ChartPlot &plot, Compared what,
                        const std::vector<DistanceCurve> &curves, const QFont &font, const QPalette &palette);

/// The ways of these runs in their colours and dashes, the first one on top.
void drawWays(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
              const std::vector<std::size_t> &runs, const QPalette &palette);

/// Where a gate of the common path lies across it on the map.
QLineF pathGateLine(const MapPlan &plan, const ReferencePath &path, const PathGate &gate);
/// That line with its name.
void drawPathGate(QPainter &painter, const QLineF &line, const QString &name, bool isChosen,
                  const QPalette &palette);

} // namespace odo
