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

/// The shortest and the longest interval of a camera that takes its pictures unevenly, as phones do: at least one interval in twenty is
/// off a whole number of the usual ones by more than a tenth. Nothing where they are even, though some may be missing.
struct UnevenRate
{
    Nanoseconds shortest{0}, longest{0};
};
std::optional<UnevenRate> unevenRate(const std::vector<Nanoseconds> &frameTimes);

/// The same as one sentence of a warning; empty where they are even.
std::string unevenRateWords(const std::vector<Nanoseconds> &frameTimes);

} // namespace odo
