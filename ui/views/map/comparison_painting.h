// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/charts/chart_painting.h"
#include "ui/views/charts/profile_curve.h"
#include "ui/views/map/map_painting.h"

#include <QLineF>
#include <QList>
#include <vector>

class QPainter;
class QPalette;

namespace odo {

/// A curve of one run over the distance, in its stretches without gaps; x: metres along the common path.
struct DistanceCurve
{
    struct Stretch
    {
        CurveRun curve;     ///< with its 95 % band
        bool faint = false; ///< within the error
    };
    std::size_t run = 0;
    std::vector<Stretch> stretches;
};

/// What is shown against the distance.
enum class Compared { Speed, TimeDifference };
/// "m/s" or as shown_units.h has it; "s".
QString comparedUnit(Compared what);

/// The speed of every run where it first came to each station, in the unit that is shown.
std::vector<DistanceCurve> speedCurves(const ComparisonScene &scene);
/// How much later each run but the first is, seconds; faint where that is within its error.
std::vector<DistanceCurve> differenceCurves(const ComparisonScene &scene);

std::vector<DistanceCurve> comparedCurves(const ComparisonScene &scene, Compared what);

/// The same at one place; nullopt where a run was not there.
std::optional<CurveValue> speedAt(const ComparisonScene &scene, std::size_t run, double distanceM);
std::optional<CurveValue> differenceAt(const ComparisonScene &scene, std::size_t run, double distanceM);

/// Where curves against the distance lie in a rectangle: all of the way the runs have in common below, 0
/// among the values.
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
