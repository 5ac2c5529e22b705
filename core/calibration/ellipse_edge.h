// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/round_markers.h"

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

/// How far ahead of a place (behind: negative) an edge lies along a direction of unit length: where the brightness
/// changes the most, as the middle of its slope's weight in a window of 1.75 px either side that follows it. nullopt where
/// within reachPx (at most 5) there is no step of 12 grey values in the wanted direction.
std::optional<double> edgeAhead(const cv::Mat &luma, const Eigen::Vector2d &from, const Eigen::Vector2d &direction,
                                double reachPx, bool brighterAhead);

/// The conic through points by least squares on Sampson's distance (Sampson 1982, reweighted three times); nullopt
/// where it is no ellipse.
std::optional<EllipseOutline> ellipseThrough(const std::vector<Eigen::Vector2d> &points);

/// Fits an ellipse to the edge about a start. reachPx: how far from the start, across it, the edge may lie and nothing
/// else does, given as a share of the distance from the middle. brighterOutside: of the outer edge of a dark shape;
/// false for the edge of a hole in it. nullopt where a third of the edge is missing or it leaves the picture.
std::optional<EllipseEdge> fitEdge(const cv::Mat &luma, const EllipseOutline &start, double reachShare,
                                   bool brighterOutside);

} // namespace odo
