// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/round_markers.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

namespace odo {

/// An ellipse through the edge of a dark shape.
struct EllipseEdge
{
    EllipseOutline outline;
    double sigmaPx = 0;  ///< of one coordinate of the middle
    double misfitPx = 0; ///< RMS of the edge points across the edge
};

/// How far ahead of a position (behind: negative) an edge is along a direction of unit length: where the
/// brightness changes the most, as the middle of its slope's weight in a window of 1.75 px either side that
/// follows it. nullopt without a step of 12 grey values in the given direction within reachPx (at most 5).
std::optional<double> edgeAhead(const cv::Mat &luma, const Eigen::Vector2d &from,
                                const Eigen::Vector2d &direction, double reachPx, bool brighterAhead);

/// The conic through points by least squares on Sampson's distance (Sampson 1982, reweighted three times);
/// nullopt where it is no ellipse.
std::optional<EllipseOutline> ellipseThrough(const std::vector<Eigen::Vector2d> &points);

/// Fits an ellipse to the edge about a start. reachPx: how far from the start, across it, the edge may lie
/// and nothing else does, given as a share of the distance from the middle. brighterOutside: of the outer
/// edge of a dark shape; false for the edge of a hole in it. nullopt where a third of the edge is missing or
/// it leaves the image.
std::optional<EllipseEdge> fitEdge(const cv::Mat &luma, const EllipseOutline &start, double reachShare,
                                   bool brighterOutside);

/// A straight edge between a bright and a dark side, as far as it was seen. Pixels of the searched image.
struct StraightEdge
{
    Eigen::Vector2d middle;    ///< of its points
    Eigen::Vector2d toBright;  ///< unit normal
    std::vector<double> along; ///< positions of its points along direction(), from the middle, in order
    double sigmaPx = 0;        ///< of one point, across

    Eigen::Vector2d direction() const { return {-toBright.y(), toBright.x()}; }
    /// σ of the edge's position across it, at a position along it.
    double sigmaAt(double alongPx) const;
    /// There are points from..to along it, relative to the middle; one each 2 px counts as all.
    bool runs(double fromPx, double toPx) const;
};

/// The straight edges of a small 8-bit image, longest first, at most twelve: steepest positions grouped by
/// line and direction, each line refitted to edges measured across it (edgeAhead). Shorter ones than 8 px are
/// left out.
std::vector<StraightEdge> findStraightEdges(const cv::Mat &image);

/// Where two edges cross; nullopt where they run within 25° of one another.
std::optional<Eigen::Vector2d> crossingOf(const StraightEdge &one, const StraightEdge &other);

} // namespace odo
