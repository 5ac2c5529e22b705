// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// What a zone asks of a robot's centre.
enum class ZoneRule { StayInside, StayOutside };

/// A part of the floor within which a robot must stay, or out of which it must keep: a polygon by its corners, in order all the way
/// round, either way. World frame, metres. Its edge belongs to it. Each zone of a task is judged by itself.
struct Zone
{
    std::string name;
    ZoneRule rule = ZoneRule::StayInside;
    std::vector<Eigen::Vector2d> corners;
};

/// Whether a place can be one of a floor: finite, and within a kilometre of the world's axes.
bool isOnFloor(const Eigen::Vector2d &point);

/// "stay_inside", "stay_outside"; NotFound, with the words there are, for another.
Result<ZoneRule> parseZoneRule(std::string_view word);
std::string_view zoneRuleWord(ZoneRule rule);

/// A rectangle along the axes, by two opposite corners.
Zone rectangularZone(const std::string &name, ZoneRule rule, const Eigen::Vector2d &one, const Eigen::Vector2d &opposite);

/// Whether a zone can be judged, InvalidInput where not: less than 3 corners or more than 100, corners that are not on a floor of 1 km
/// or less than a millimetre from the next, an outline that crosses or touches itself.
Result<void> checkZone(const Zone &zone);
/// What the last zone adds to those before it: its name; and that there are 30 at most.
Result<void> checkZoneAmong(const std::vector<Zone> &zones);

} // namespace odo
