// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

/// An ellipse in the image, luma pixels.
struct EllipseOutline
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d semiAxes = Eigen::Vector2d::Zero(); ///< longer one first
    double angleRad = 0;                                ///< of the longer axis, from +u towards +v

    Eigen::Vector2d pointAt(double parameterRad) const;
    double area() const { return EIGEN_PI * semiAxes.x() * semiAxes.y(); }
};

/// A dark ring or a dark disc on a brighter ground.
struct RoundMarker
{
    enum class Kind { Ring, Dot } kind = Kind::Ring;
    /// The image of the circle's middle, for a ring: the middles of the ellipses of its two circles lie apart
    /// by the perspective, in proportion to their areas, and going on to area zero gives it. Of a dot the
    /// middle of its ellipse, which perspective moves by up to some 0.5 px: dotCentre() in dot_centre.h
    /// corrects it by a pose.
    Eigen::Vector2d centrePx = Eigen::Vector2d::Zero();
    double sigmaPx = 0;     ///< of one coordinate of centrePx, from how well the edge points fit
    EllipseOutline outline; ///< the outer edge
};

/// Finds rings and dots in the whole image, or in a part of it: dark shapes of two adaptive thresholds, then
/// an ellipse through edges at the steepest position of the brightness across them, refitted three times.
/// Shapes smaller than 5 px across are left out, as are those flatter than 1 : 8 and those that are no
/// ellipse; a ring whose hole is too small to measure counts as a dot. Largest first. Thread-safe.
std::vector<RoundMarker> findRoundMarkers(const Frame &frame, std::optional<PixelRect> part = {});

/// The image of a dot's middle: its outline projected onto the floor is a circle again, whose middle is where
/// it is. outline: of the dot in the image of view. nullopt where the outline reaches beyond the horizon.
/// Thread-safe.
std::optional<Eigen::Vector2d> dotCentre(const EllipseOutline &outline, const FloorView &view);

} // namespace odo
