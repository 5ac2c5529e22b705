// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/tracking/internal/edge_finder.h"

#include <vector>

namespace odo {

/// Finds from the edges of a robot whether the chroma samples have another siting than the stream says: then
/// its edges are shifted from the luma's, everywhere in the same direction. A siting is wrong by half a
/// pixel, by a whole one (of a clip that a program has mirrored since), or not at all; less is shading.
/// Learns from the first hundred outlines.
class SitingCheck
{
public:
    /// This one's edges are already corrected by what all outlines so far show.
    void learn(const std::vector<ScanLine> &lines, std::vector<LineEdge> &edges);
    /// By how much the chroma planes must be shifted to lie on the luma plane: luma pixels.
    const Eigen::Vector2d &lagPx() const { return m_lag; }

private:
    /// Normal equations: lag = normal⁻¹ · right.
    Eigen::Matrix2d m_normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d m_right = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_lag = Eigen::Vector2d::Zero();
    int m_outlines = 0;
};

/// The outline of a convex region at sub-pixel precision, luma pixels.
struct Outline
{
    std::vector<Eigen::Vector2d> points; ///< in order, clockwise on the screen
    std::vector<std::uint8_t> found;     ///< 1 where an edge was found, 0 where the hull replaces it
    RegionMoments moments;
    Eigen::Matrix2d centreCovariance = Eigen::Matrix2d::Zero();
    double solidity = 1;  ///< share of its hull that the region fills
    double goodShare = 0; ///< of the scan lines that found a clear edge
};

/// Finds the outline of a convex region from the edges along scan lines, which run along the planes' own rows
/// and columns.
///
/// Lines whose edge strays from their neighbours' are put aside, and their part of the outline is taken from
/// the mask's hull, shifted as their neighbours were; likewise at corners too narrow for a line. The
/// covariance is that of the lines' scatter about their neighbours; codec noise, of which neighbours share a
/// part, counts by how much more lines two apart scatter than lines side by side. Keeps its memory: no
/// allocation once it is warm.
class OutlineFit
{
public:
    /// False when the region is small or too few lines found an edge: then the outline is meaningless.
    bool fit(const Frame &frame, const ChromaGrid &grid, const RegionMask &mask, const OutlineHint &hint,
             Outline &outline);

private:
    void putOutliersAside();
    void fillGaps();
    void gather(const ChromaGrid &grid, const std::vector<ScanLine> &lines, Outline &outline);
    double varianceOfEdges(const std::vector<ScanLine> &lines);
    static float scatter(const std::vector<float> &positions, const std::vector<std::int8_t> &sides, int step,
                         std::vector<float> &leftOver);

    ScanLines m_scanLines;
    EdgeFinder m_finder;
    SitingCheck m_siting;
    std::vector<LineEdge> m_edges;
    std::vector<float> m_outwards, m_inwards; ///< of the edges, about the ring
    std::vector<float> m_most, m_least;       ///< of the edges near each
    std::vector<float> m_positions;           ///< of the edges along their lines, about the ring
    std::vector<std::int8_t> m_sides;         ///< of the outline that the edges are on, −1 without an edge
    std::vector<float> m_leftOver;
};

} // namespace odo
