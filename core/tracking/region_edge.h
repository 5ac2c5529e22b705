// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"
#include "core/tracking/compared_window.h"
#include "core/tracking/edge_pixels.h"
#include "core/tracking/floor_shade.h"

#include <vector>

namespace odo {

/// Finds a region's edge to parts of a pixel: what is seen of a pixel on the edge is a blend of what lies inside and of the floor behind, lit or in shadow.
/// Keeps its memory. One thread at a time.
class RegionEdge
{
public:
    /// So far around a region is looked, pixels.
    static constexpr int marginPx = 8;

    /// region: pixels of a part of the window that reaches marginPx around it, where the window does. cut: what touches it there and is no part of it.
    void measure(const ComparedWindow &window, const FloorShade &shade, const PixelRect &part, const BitMask &region, const BitMask &cut);

    /// Where the part of a pixel that the region covers crosses one half along the rows and the columns, from both ends of each, without those that lie
    /// inside: the corners of the region's hull are among these points. Luma pixels of the picture.
    const std::vector<Eigen::Vector2d> &points() const { return m_points; }
    /// Mean of the region without its edge; zero where it is all edge.
    const Chroma &meanChroma() const { return m_meanChroma; }

private:
    /// What the edge lies in: sets of a part of the window.
    struct Surroundings
    {
        const ComparedWindow &window;
        PixelRect part;
        BitMask core, near, shaded; ///< inside without the edge; inside with the edge; floor in shadow
    };
    /// Pixels near the edge that are summed up.
    struct Summed
    {
        BitMask inside, lit, shaded; ///< of those outside: on the floor in light and in shadow
    };
    void addEdge(const Surroundings &all, const BitMask &edge, int reach);
    template <class Change>
    void sumUp(const Surroundings &all, const Summed &summed, int y, int reach, const Change &change);
    void addEdgeRow(const Surroundings &all, const BitMask &edge, int reach, int y);
    void cover(const BitMask &region);
    void findPoints(const BitMask &near, const Eigen::Vector2d &origin);

    std::vector<EdgePixels::Sums> m_columns; ///< of the rows around one, with as many more at both ends as is looked at
    EdgePixels m_edge;
    cv::Mat1f m_covered; ///< part of each pixel
    std::vector<Eigen::Vector2d> m_points;
    Chroma m_meanChroma = Chroma::Zero();
};

} // namespace odo
