// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// Sightings at the height that the views agree on at each time by itself.
struct FreeHeightSightings
{
    std::vector<std::vector<Sighting>> views; ///< as given, each shifted to the height of its time
    double medianHeightM = 0;
};

/// For a robot whose height changes (on a ramp): at each time with two views or more, the height at which
/// their rays come nearest (weighted least squares, as estimatePlane, but for one time), the point being what
/// both see. Where one view is alone, or the height jumps by more than 0.15 m against the median of the half
/// second around, the height is that of the nearest times before and after, as uncertain as it changes within
/// such a time in this run: a position that one view gives then counts for less than one that two give. Where
/// the rays miss each other throughout by more than is stated, each view's covariance grows along its ray.
/// views: each view's sightings at the same times, projected onto z = 0. nullopt: fewer than ten times with
/// two views.
std::optional<FreeHeightSightings> freeHeight(std::vector<std::vector<Sighting>> views);

/// How far the height at which the views' rays come nearest strays from one height, as a σ (1.4826 · median
/// of the absolute deviations); 0 with fewer than ten times. views: as for freeHeight.
double heightScatterM(const std::vector<std::vector<Sighting>> &views, double heightM);

} // namespace odo
