// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/marker_layout.h"

#include <optional>
#include <string>
#include <utility>

namespace odo {

/// From old world axes to new ones: lengths times scale, then a turn about Z, then a shift. Handedness is
/// kept.
struct AxesTransform
{
    double scale = 1;
    double turnRad = 0; ///< counter-clockwise seen from above
    Eigen::Vector2d shiftM = Eigen::Vector2d::Zero();

    Eigen::Vector2d operator*(const Eigen::Vector2d &pointInOldWorld) const;
};

/// A change of the axes. All positions are those of the present layout, after lengthFactor.
struct AxesChange
{
    /// By what the layout's lengths are multiplied: lengthFactorFrom("inch") where inches were read as mm.
    double lengthFactor = 1;
    std::string originMarker = {};               ///< becomes (0, 0); or empty
    std::optional<Eigen::Vector2d> originM = {}; ///< a point that becomes (0, 0), instead of a marker
    double turnDegrees = 0;                      ///< the new +X lies at this angle in the old axes
    /// +X from the first marker to the second, instead.
    std::optional<std::pair<std::string, std::string>> xAlong = {};
    /// Reverses axes after all else. Both together are a half turn; one alone would mirror the floor and is
    /// refused.
    bool reverseX = false, reverseY = false;
};

/// The factor that turns lengths read as mm into what they were meant: "mm", "cm", "m", "inch". InvalidInput
/// for others.
Result<double> lengthFactorFrom(const std::string &unit);

/// Refuses, each with its sentence: a marker that is not in the layout, two origins, two directions, a pair
/// at one position, a length factor that is not positive, and the reversal of one axis alone.
Result<AxesTransform> axesTransformOf(const MarkerLayout &layout, const AxesChange &change);

MarkerLayout transformed(const MarkerLayout &layout, const AxesTransform &newFromOld);

/// The same camera over the same floor in the new axes: pose, covariance, errors on the floor. Pixels,
/// intrinsics and errors in the image stay. The verdict says that the axes were changed.
FloorRegistration transformed(const FloorRegistration &registration, const AxesTransform &newFromOld);

} // namespace odo
