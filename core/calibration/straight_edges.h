// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

namespace odo {

/// A straight edge between a bright and a dark side, as far as it was seen. Pixels of the picture it was looked for in.
struct StraightEdge
{
    Eigen::Vector2d middle;      ///< of its points
    Eigen::Vector2d toBright;    ///< unit normal
    std::vector<double> along;   ///< places of its points along direction(), from the middle, in order
    double sigmaPx = 0;          ///< of one point, across

    Eigen::Vector2d direction() const { return {-toBright.y(), toBright.x()}; }
    /// σ of the edge's place across it, at a place along it.
    double sigmaAt(double alongPx) const;
    /// There are points from..to along it, relative to the middle; one each 2 px counts as all.
    bool runs(double fromPx, double toPx) const;
};

/// The straight edges of a small 8-bit picture, longest first, at most twelve: steepest places grouped by line and
/// direction, each line refitted to edges measured across it (edgeAhead). Shorter ones than 8 px are left out.
std::vector<StraightEdge> findStraightEdges(const cv::Mat &picture);

/// Where two edges cross; nullopt where they run within 25° of one another.
std::optional<Eigen::Vector2d> crossingOf(const StraightEdge &one, const StraightEdge &other);

} // namespace odo
