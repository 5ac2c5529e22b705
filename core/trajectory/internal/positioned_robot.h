// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// What all views saw, projected at the robot's height.
struct PositionedRobot
{
    std::vector<std::vector<Sighting>> views;
    double planeM = 0, planeSigmaM = 0; ///< of the plane used
    double heightM = 0;                 ///< of the robot's top
    bool estimated = false;
    std::optional<double> clearanceM;                          ///< of a solid
    std::vector<std::optional<MeasuredHeading>> headings = {}; ///< of a solid, one a frame; or none at all
    bool isPlainAndRight = false; ///< of a solid: a box or a cylinder that explains the outlines
    bool strays = false;          ///< a mark, from its plane: the views then agree by their bearings
};

/// When a view's frames were taken, on the first view's clock.
std::vector<Nanoseconds> timesOf(const ViewTrack &view);

/// Each view's floor positions of a robot at these times: of the solid that its outlines show, or of what is
/// seen of it on one plane, or, where its height varies, at the height of each time. Pure. Errors: a
/// reference point other than the footprint's centre with outlines that show no heading; a height that
/// varies, seldom seen by two views at once.
Result<PositionedRobot> positionRobot(const std::vector<ViewTrack> &views,
                                      const std::vector<Nanoseconds> &times, const RobotShape &shape);

/// By a box or a cylinder only, which views that contradict each other can bend less than a form that is
/// learned from them. nullopt: neither explains the outlines, or they show too little to learn another form.
std::optional<PositionedRobot> positionPlainSolid(const std::vector<ViewTrack> &views,
                                                  const std::vector<Nanoseconds> &times,
                                                  const RobotShape &shape);

} // namespace odo
