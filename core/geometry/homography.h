// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// One correspondence between two planes.
struct PointPair
{
    Eigen::Vector2d source;
    Eigen::Vector2d target;
    std::string label; ///< for messages; may be empty
};

/// A projective map between two planes; 3×3, scaled so that its Frobenius norm is 1 and the points it was
/// estimated from have a positive third coordinate (so the sign tells on which side of the horizon a point
/// lies).
class Homography
{
public:
    explicit Homography(const Eigen::Matrix3d &targetFromSource);

    /// Normalised DLT (Hartley and Zisserman 2004, algorithm 4.2) followed by Levenberg–Marquardt on the
    /// distance in the target plane. Needs four points, no three of any minimal four collinear. Refuses,
    /// naming the labels at fault: fewer than four points, doubled points, collinear layouts, and
    /// correspondences that fold the plane (bow tie).
    static Result<Homography> estimate(std::span<const PointPair> pairs);

    const Eigen::Matrix3d &matrix() const { return m_matrix; }
    /// nullopt at or beyond the horizon.
    std::optional<Eigen::Vector2d> map(const Eigen::Vector2d &source) const;
    Homography inverse() const;
    /// Chains: (targetFromMiddle * middleFromSource).
    Homography operator*(const Homography &middleFromSource) const;
    /// The map over any number of links in the order they are gone through: the first link's target is the
    /// second's source, and so on (from view m to view n over the views between). Refuses no links at all,
    /// and, by its number, a link that maps the plane onto a line (|det| < 1e-12 at unit norm) or is not
    /// finite.
    static Result<Homography> chain(std::span<const Homography> links);

private:
    Eigen::Matrix3d m_matrix;
};

} // namespace odo
