// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

namespace odo {

/// How far a profile lies from a known truth. Only where the profile is valid.
struct TruthAccuracy
{
    std::int64_t compared = 0;
    double positionRmsM = 0, velocityRmsMps = 0, accelerationRmsMps2 = 0; ///< of the vector differences
    double insideX95 = 0, insideY95 = 0, insideSpeed95 = 0; ///< parts of samples whose 95 % interval holds the truth
};

/// Samples and truth are matched by time (within 0.1 ms); both count from the first view's first frame.
TruthAccuracy compareWithTruth(const Profile &profile, const TruthSeries &truth);

} // namespace odo
