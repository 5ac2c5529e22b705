// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"

#include <optional>
#include <string>

namespace odo {

/// What a lens leaves to be wrong on the floor of a typical testbed. Metres; the figures of expectedOnFloor are σ along
/// the direction in which a place is known the least.
struct FloorExpectation
{
    double middleM = 0;     ///< in the middle of the floor
    double worstM = 0;      ///< where it is largest
    std::string worstWhere; ///< "in the far left corner", "at the near edge", as the camera sees it
};

/// The testbed that lenses are judged by, since a figure in millimetres says more to a person than one in pixels: a camera
/// 2 m high, looking at a floor of 3 m × 2 m whose longer side lies along the picture's longer side, from as near as the
/// whole floor is in the picture (0.3 m from the near edge or more), and registered by four markers at the floor's corners.
/// The markers are taken as exact: what they add is the registration's part. nullopt where no such place exists
/// (a lens so long that it would stand 60 m away).
std::optional<FloorView> typicalTestbed(const CameraModel &camera);

/// The testbed in the words of a verdict: "a 3 m × 2 m floor seen from 2 m above".
std::string typicalTestbedWords();

/// The lens's covariance carried to the floor (poseByLens, FloorView), on a grid of 13 × 9 places.
/// nullopt where the lens has no covariance or no testbed fits it.
std::optional<FloorExpectation> expectedOnFloor(const Intrinsics &intrinsics);

/// How far two lenses of one camera put the same pixels apart on that floor, each registered by the same four pixels.
std::optional<FloorExpectation> apartOnFloor(const Intrinsics &one, const Intrinsics &other);

} // namespace odo
