// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/models/trial_scene.h"
#include "ui/views/map/map_painting.h"

#include <QLineF>
#include <QString>
#include <vector>

class QPainter;
class QPalette;

namespace odo {

struct TrialScene;

/// The fastest valid speed of all robots of a scene: the end of the colour scale. 0 where none was tracked.
double topSpeedMps(const TrialScene &scene);

/// A smoothed track, coloured by speed from 0 to the top, with a rim so both ends of the scale contrast with
/// any floor. Bridged pieces are dotted; gaps stay open.
void drawSpeedTrail(QPainter &painter, const MapPlan &plan, const Profile &profile, double topMps,
                    const QPalette &palette);
/// A haze under the trail where less than usual is known of a robot; at both ends of a gap.
void drawMapUncertainIntervals(QPainter &painter, const MapPlan &plan, const TrialScene &scene,
                               const QPalette &palette);
/// A triangle where each spike was measured, or else where the curve is then.
void drawMapSpikes(QPainter &painter, const MapPlan &plan, const Profile &profile, const QPalette &palette);

/// The colour scale at the foot, with what its ends mean.
void drawScaleLegend(QPainter &painter, const MapPlan &plan, const QString &words, const QPalette &palette);
/// The same for speeds, in the unit that is shown; nothing where the top is 0.
void drawSpeedLegend(QPainter &painter, const MapPlan &plan, double topMps, const QPalette &palette);

struct FloorImage;

/// The parts of a trial's map in the order of painting, for the screen and for whatever else shows it:
/// ground, trails (trail_painting.h), marks, legend, robots. In logical pixels, with the painter's font; on a
/// QImage on any thread.

/// The floor's image (perhaps none), as strong as `opacity` says, a calm foot for the scale, the grid, the
/// markers, and the task's zones.
void drawMapFloor(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorImage &floor,
                  double opacity, const QPalette &palette);
/// That, the task's path, and a haze where less than usual is known of a robot.
void drawMapGround(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorImage &floor,
                   const QPalette &palette);
/// Gates and spikes.
void drawMapMarks(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const QPalette &palette);
/// Each robot where it is at a time; none that is not known then.
void drawTrialRobots(QPainter &painter, const MapPlan &plan, const TrialScene &scene, Nanoseconds time,
                     const QPalette &palette);

/// The paths of these runs in their colours and dashes, the first one on top. Gaps stay open.
void drawPaths(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
               const std::vector<std::size_t> &runs, const QPalette &palette);

/// Where a gate of the common path lies across it on the map.
QLineF pathGateLine(const MapPlan &plan, const ReferencePath &path, const PathGate &gate);
/// That line with its name.
void drawPathGate(QPainter &painter, const QLineF &line, const QString &name, bool isChosen,
                  const QPalette &palette);

} // namespace odo
