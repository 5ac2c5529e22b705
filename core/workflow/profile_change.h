// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A figure before and after; nullopt where one of the two analyses has none.
struct MetricChange
{
    std::string name, unit;
    std::optional<double> before, after;
    std::optional<double> sigma; ///< of the later, or else of the earlier
};

/// What another analysis of the same observations changes for one robot.
struct ProfileChange
{
    std::vector<MetricChange> metrics; ///< in the order of the earlier, then those that are new
    std::size_t compared = 0;          ///< places that both have
    double largestShiftM = 0, rmsShiftM = 0;
    Nanoseconds largestAt{0};
    std::size_t spikesBefore = 0, spikesAfter = 0;
    std::string words; ///< one sentence for a person
};

/// Compares frame by frame, where both are valid. Pure; any thread.
ProfileChange changeBetween(const Profile &before, const Profile &after);

} // namespace odo
