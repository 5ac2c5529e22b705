// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <array>
#include <limits>
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
/// estimated from have a positive third coordinate (so its sign gives the side of the horizon).
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

/// How far the best four of some points are from being collinear.
struct Spread
{
    double flatness =
        0; ///< smallest height of a triangle of any three of the best four, over the extent of all points
    std::array<int, 3> flattest{}; ///< the three points of that triangle
};

/// The largest distance between two of the points' extremes.
double extentOf(const std::vector<Eigen::Vector2d> &points);

/// Two points nearer to one another than 1e-4 of the extent, if there are any.
std::optional<std::array<int, 2>> coincidentPoints(const std::vector<Eigen::Vector2d> &points);

/// The four points whose flattest triangle is the least flat. Of more than 16 points, 16 are tried (extremes
/// in eight directions and an even sample). Needs four points. enough: a flatness at which the search ends,
/// for callers who only ask whether the points are that spread.
Spread widestQuadrilateral(const std::vector<Eigen::Vector2d> &points,
                           double enough = std::numeric_limits<double>::infinity());

} // namespace odo
