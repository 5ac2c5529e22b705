// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace odo {

/// A shape of an image that may be a marker.
struct MarkerShapeSeen
{
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double areaPx = 0; ///< 0: not known
    /// From offsets in pixels to a plane in which the shape is round; the identity where that is not known.
    Eigen::Matrix2d round = Eigen::Matrix2d::Identity();
};

/// Which shape is which marker of a layout.
struct GrownAssignment
{
    static constexpr int nothing = -1;

    std::vector<int> shapes; ///< of each marker, or nothing
    std::size_t matched = 0;
    /// RMS distance of each matched marker from where its neighbours predict it, over the distance to the
    /// nearest of them: below 0.02 for markers measured to some millimetres, above 0.1 by chance.
    double misfit = 0;
};

/// Finds which of many shapes that are all alike is which marker of a layout, by the positions of neighbours:
/// a marker and two neighbours are given a shape and two of its neighbours, and from there each next marker
/// is predicted by a projective map through those around it, so that a lens that bends the image by tens of
/// pixels does not matter. Markers may be hidden, and shapes may be none. Kept are assignments with eight
/// markers or more that are seen from above, each once; most markers first. Few markers may fit by chance.
/// known: the shape of each marker whose shape is known, or nothing. Best for 12 to
/// 400 markers. Thread-safe.
std::vector<GrownAssignment> growAssignments(const std::vector<Eigen::Vector2d> &markers,
                                             const std::vector<MarkerShapeSeen> &shapes,
                                             const std::vector<int> &known,
                                             const Eigen::Vector2d &imageSizePx);

} // namespace odo
