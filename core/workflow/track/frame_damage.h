// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/tracking/observation.h"

#include <cstdint>
#include <vector>

namespace odo {

/// Frames of a recording that could not be decoded soundly. A tracked view has an observation for each frame
/// but these.
struct FrameDamage
{
    std::int64_t frames = 0;
    TimeSpan span; ///< from the first to the last of them, on the recording's clock
};

/// frameTimes: of all frames of the recording. Of a view that was never tracked nothing is known.
FrameDamage damageOf(const std::vector<Observation> &observations,
                     const std::vector<Nanoseconds> &frameTimes);

/// Puts an observation that found nothing in the place of each damaged frame, so the time that was not
/// measured counts as such at the ends of a recording, too.
void insertDamaged(std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes);
/// Takes them out again: what is stored holds only frames that were looked at.
void removeDamaged(std::vector<Observation> &observations);

} // namespace odo
