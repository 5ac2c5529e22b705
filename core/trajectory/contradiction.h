// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/floor_positions.h"
#include "core/trajectory/fused_track.h"

#include <vector>

namespace odo {

/// Finds where views put a robot at different places for longer than a false sighting lasts, by more than their covariances allow for: a camera was moved
/// after it was registered, the views are out of step, a height that was told is wrong. What is found is added to the calibrations' part of the covariances of
/// the views that no other one bears out, until the views agree: their covariance times half the median over two seconds of χ²(2) (Birge 1932: the ratio by which errors
/// that were stated too small are widened). Views that lie apart by more than farApartM see different things, and are left as they are.
/// views: sightings of each view at the same times, on the plane used. Tells of each time whether it was so. Pure.
std::vector<bool> widenByContradiction(std::vector<std::vector<Sighting>> &views);

/// Sets ViewsDisagree where it was so.
void flagContradictions(FusedTrack &track, const std::vector<bool> &isContradicted);
/// An Error where hardly a sample is used because the views contradict one another.
Result<void> checkAgreement(const std::vector<Sample> &samples);

inline constexpr double farApartM = 0.2; ///< beyond it no camera was moved: the views see different things

} // namespace odo
