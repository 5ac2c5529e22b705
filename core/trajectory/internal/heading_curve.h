// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <vector>

namespace odo {

/// The curve of a body's heading from the headings of its samples (smoothTurning). Headings of samples that
/// are not used do not count. Pure.

/// Sets ProfilePoint::body of the valid points, between measured headings that are not farther apart than
/// longestGap. σ: the smoother's, and what neighbouring frames share; that changes as the body turns, by
/// which it goes into the turn rate too. samples and points have equal length.
void smoothHeadings(const std::vector<Sample> &samples, Nanoseconds longestGap,
                    std::vector<ProfilePoint> &points);

/// σ of headings as they scatter from sample to sample, whatever is stated. 0: there are too few of them.
double headingScatterRad(const std::vector<Sample> &samples, Nanoseconds longestGap);

} // namespace odo
