// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/map_painting.h"

#include <QString>

namespace odo {

struct TrialScene;

/// The fastest valid speed of all robots of a scene: the end of the colour scale. 0 where none was tracked.
double topSpeedMps(const TrialScene &scene);

/// A smoothed track, coloured by speed from 0 to the top, with a rim so that both ends of the scale stand out
/// from any floor. Gaps stay open.
void drawSpeedTrail(QPainter &painter, const MapPlan &plan, const Profile &profile, double topMps,
                    const QPalette &palette);
/// A haze under the trail where less than usual is known of a robot.
void drawMapDoubts(QPainter &painter, const MapPlan &plan, const TrialScene &scene, const QPalette &palette);
/// A triangle where each spike was measured, or else where the curve is then.
void drawMapSpikes(QPainter &painter, const MapPlan &plan, const Profile &profile, const QPalette &palette);

/// The colour scale at the foot, with what its ends mean.
void drawScaleLegend(QPainter &painter, const MapPlan &plan, const QString &words, const QPalette &palette);
/// The same for speeds, in the unit that is shown; nothing where the top is 0.
void drawSpeedLegend(QPainter &painter, const MapPlan &plan, double topMps, const QPalette &palette);

} // namespace odo
