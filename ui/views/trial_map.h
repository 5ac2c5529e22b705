// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/map_painting.h"

class QPainter;
class QPalette;

namespace odo {

struct FloorPicture;

/// The parts of a trial's map in the order of painting, for the screen and for whatever else shows it: ground, trails
/// (trail_painting.h), marks, legend, robots. In logical pixels, with the painter's font; on a QImage on any thread.

/// The floor's picture (perhaps none), as strong as `opacity` says, a calm foot for the scale, the grid, the markers, and
/// the task's zones.
void drawMapFloor(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorPicture &floor,
                  double opacity, const QPalette &palette);
/// That, the task's path, and a haze where less than usual is known of a robot.
void drawMapGround(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const FloorPicture &floor,
                   const QPalette &palette);
/// Gates and spikes.
void drawMapMarks(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const QPalette &palette);
/// Each robot where it is at a time; none that is not known then.
void drawTrialRobots(QPainter &painter, const MapPlan &plan, const TrialScene &scene, Nanoseconds time,
                     const QPalette &palette);

} // namespace odo
