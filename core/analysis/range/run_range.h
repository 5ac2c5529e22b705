// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/task.h"

#include <optional>
#include <vector>

namespace odo {

/// What of a run is outside of its range.
struct OutsideRange
{
    Profile before, after; ///< their samples, points and spikes alone
};

/// Leaves of a whole run what is within a range, both ends included: its samples, points and spikes, and what
/// follows from them alone. Metrics and passages stay as they are. Gives the rest. Pure.
OutsideRange cutToRange(Profile &profile, const TimeSpan &range);

/// Puts both together again; metrics and passages stay those of the part. Pure.
Profile wholeRun(Profile part, const OutsideRange &outside);

/// Measures metrics and passages of a profile; task: nullptr where it was measured by none. Pure.
void measureProfile(Profile &profile, const Task *task);

/// Gives a measured run another range, or none, and measures that. outside: what the range that it had left
/// out; then what the new one does. Lower bounds that don't follow from gaps stay. Pure.
void changeRange(Profile &profile, OutsideRange &outside, const std::optional<TimeSpan> &range,
                 const Task *task);

/// Whether the robot is known to have been anywhere.
bool hasValidPoint(const Profile &profile);

/// From the first sample of the first motion of a run to the last of its last (findMotions). A motion of
/// which fewer than three samples were used does not count: what was lost or flagged is no evidence. nullopt:
/// the robot does not move. Pure.
std::optional<TimeSpan> motionSpan(const Profile &profile);

/// The mean distance of the views' positions over the samples that are used, metres; 0 where there is none.
double meanViewDisagreement(const std::vector<Sample> &samples);

} // namespace odo
