// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/floor_positions.h"

#include <vector>

namespace odo {

/// A view's sightings at other times (in order): cubic between four neighbours, linear where only two are
/// there; nothing outside, and nothing across more than 2.5 of the view's usual frame intervals. A sighting
/// within 50 µs of the wanted time is taken as it is. Covariance: the neighbours' own, weighted linearly. The
/// noise of interpolated points is correlated from one to the next, so stating the smaller variance of each
/// single one would let the smoother average away noise that stays. Where the view has fewer frames than are
/// asked for, it is widened by the ratio, for the same reason.
std::vector<Sighting> sightingsAt(const std::vector<Nanoseconds> &times,
                                  const std::vector<Sighting> &sightings);

} // namespace odo
