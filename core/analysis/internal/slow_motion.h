// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"

#include <optional>
#include <vector>

namespace odo {

/// Motions so slow that at each moment they could be noise, and show over a longer time alone. motions: those
/// whose speed shows, in order. A pause between two in which the robot got on by more than half as far as
/// with their speed is part of the motion. Where it rests by its speed, but ends elsewhere than it began (4.5
/// σ) and came nearer in each quarter of the time, it moves, too: a position that only drifts to and fro does
/// not.
std::vector<MotionStretch> withSlowMotions(const std::vector<RunInstant> &instants,
                                           const std::vector<MotionStretch> &motions);

/// The distances travelled in a stretch whose speed is within six σ: there noise would make its integral too
/// long. From one position to the next that is ten σ away. nullopt: it is faster.
std::optional<std::vector<double>> slowDistances(const std::vector<RunInstant> &instants,
                                                 const MotionStretch &motion);

} // namespace odo
