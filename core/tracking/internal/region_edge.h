// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"
#include "core/tracking/internal/compared_window.h"
#include "core/tracking/internal/floor_shade.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace odo {

/// Pixels on a region's edge, one value of each kind for each, so that many are computed at once. Luma and
/// chroma as in PixelColour.
struct EdgePixels
{
    /// Of the pixels around: the number of those inside with their luma and chroma, the latter in units of 1
    /// / ComparedWindow::chromaUnit, and the number of those outside with their light against the
    /// background's, in units of 1 / lightUnit, and by how much their chroma is off it.
    using Sums = std::array<std::int32_t, 8>;
    enum Sum {
        insideCount,
        insideLuma,
        insideU,
        insideV,
        outsideCount,
        outsideLight,
        outsideTintU,
        outsideTintV
    };
    static constexpr int lightUnit = 4096;

    std::size_t count = 0;           ///< in use of the values below
    std::vector<Eigen::Vector2i> at; ///< where they are, for whoever fills in the values
    std::vector<Sums> around;
    std::vector<float> luma, u, v;                   ///< as seen
    std::vector<float> lumaBehind, uBehind, vBehind; ///< of the floor in full light
    std::vector<float> lumaNoise2, chromaNoise2;
    std::vector<std::array<float, 2>> found;

    void makeRoom(std::size_t pixels);
    /// Finds what part of each pixel the region covers, which may be less than nothing and more than all, and
    /// by how much the contrast between inside and outside is clear of noise: not at all where it is negative
    /// or, as nothing is inside, no number.
    void findCovered();
};

/// Finds a region's edge to parts of a pixel: what is seen of a pixel on the edge is a blend of what lies
/// inside and of the floor behind, lit or in shadow. Keeps its memory. One thread at a time.
class RegionEdge
{
public:
    /// So far around a region is looked, pixels.
    static constexpr int marginPx = 8;

    /// region: pixels of a part of the window that reaches marginPx around it, where the window does. cut:
    /// what touches it there and is no part of it.
    void measure(const ComparedWindow &window, const FloorShade &shade, const PixelRect &part,
                 const BitMask &region, const BitMask &cut);

    /// Where the part of a pixel that the region covers crosses one half along the rows and the columns, from
    /// both ends of each, without those that lie inside: the corners of the region's hull are among these
    /// points. Luma pixels of the frame.
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
    /// Of a pixel of floor in shadow what EdgePixels::Sums take of it.
    struct Shaded
    {
        std::int32_t light = 0, tintU = 0, tintV = 0;
    };
    std::vector<Shaded> &shadedRow(int y);
    void readShaded(const Surroundings &all, const BitMask &shaded, int y);
    template <class Change>
    void sumUp(const Surroundings &all, const Summed &summed, int y, int reach, const Change &change);
    void addEdgeRow(const Surroundings &all, const BitMask &edge, int reach, int y);
    void readEdgeRow(const Surroundings &all, const BitMask &edge, int y, std::size_t first);
    void cover(const BitMask &region);
    float coveredAt(int x, int y) const;
    double backFrom(int x, int y, int xBefore, int yBefore) const;
    void findPoints(const Eigen::Vector2d &origin);

    /// of the rows around one, with as many more at both ends as is read
    std::vector<EdgePixels::Sums> m_columns;
    /// of the rows that are summed up; only the pixels in shadow are written
    std::vector<std::vector<Shaded>> m_shadedRows;
    EdgePixels m_edge;
    std::vector<float> m_lumaNoise2, m_chromaNoise2; ///< of a row from its first edge pixel on
    BitMask m_mostly, m_isBlend;  ///< pixels that are covered by half or more, and those partly covered
    std::vector<float> m_covered; ///< part of the latter, row by row
    std::vector<Eigen::Vector2d> m_points;
    Chroma m_meanChroma = Chroma::Zero();
};

} // namespace odo
