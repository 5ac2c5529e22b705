// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/quantity_curve.h"
#include "core/analysis/task.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// When the robot's reference point was within a zone, whatever the zone's rule is. SI.
struct ZoneVisits
{
    std::string zone;   ///< its name
    CurveValue insideS; ///< time within, σ as that of zone_time (measureZones)
    int entries = 0;    ///< from outside; a run that begins within has not entered yet
    bool beginsInside = false;
    /// From the first position of the run (or range) to the first entry; 0 ± 0 where it begins within,
    /// nullopt where it never is.
    std::optional<CurveValue> latencyS;
    std::vector<TimeSpan> visits; ///< since the first view's first frame
    bool isAtLeast = false;       ///< part of the run was not measured: it may have been there more often
};

/// Of each zone in turn. A visit is significant: somewhere in it the point is within the zone by more than
/// six σ of the track's own noise (and 0.5 mm), and it ends where the point is out by as much
/// (findZoneBreaches). A gap of the profile ends a visit. Pure.
std::vector<ZoneVisits> findZoneVisits(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                       const std::vector<ProfilePoint> &points);

} // namespace odo
