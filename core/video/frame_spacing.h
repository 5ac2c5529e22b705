// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// How far apart the pictures of a video are.
struct FrameSpacing
{
    Nanoseconds usual{0};    ///< the mean of all intervals within 10 % of their median; 0 of fewer than two pictures
    bool isVariable = false; ///< some are not within that
};
FrameSpacing spacingOf(const std::vector<Nanoseconds> &frameTimes);

/// That a camera takes its pictures unevenly, as phones do, as one sentence of an error: at least one interval in twenty is off a whole
/// number of the usual ones by more than a tenth. Empty where they are even, though some may be missing.
std::string unevenRateWords(const std::vector<Nanoseconds> &frameTimes);

} // namespace odo
