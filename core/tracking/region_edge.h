// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"
#include "core/tracking/compared_window.h"
#include "core/tracking/floor_shade.h"

#include <cstdint>
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
    /// Sums of pixels, each two of them in one word, the first in its lower half: modulo 2⁶⁴, as only their differences are used.
    struct Sums
    {
        std::uint64_t insideLuma = 0;   ///< number of pixels inside, and their luma
        std::uint64_t chroma = 0;       ///< and their chroma, offset to be positive
        std::uint64_t outsideLight = 0; ///< number of pixels outside, and their light against the background's, in fixed point
    };
    /// What they mean.
    struct Sides
    {
        float inside = 0, outside = 0; ///< pixels
        PixelColour colour;            ///< mean inside
        float light = 1;               ///< mean outside
    };
    static Sides sidesOf(const Sums &sums);
    static float coveredPart(const ComparedWindow &window, const Sides &sides, int x, int y, float otherwise);
    void sumUp(const ComparedWindow &window, const BitMask &shade, const PixelRect &part, const BitMask &core, const BitMask &near, int y);
    Sums *sumsRow(int y);
    Sums around(int x, int y, int reach);
    void findPoints(const PixelRect &box, const Eigen::Vector2d &origin);
    void addToChain(std::size_t first, double turn, const Eigen::Vector2d &point);

    int m_width = 0, m_height = 0;
    std::vector<Sums> m_sums; ///< of all pixels above and to the left of each corner, of the last rows of corners
    cv::Mat1f m_covered;      ///< part of each pixel
    std::vector<std::uint8_t> m_isCore, m_isNear, m_isShade; ///< of one row
    std::vector<Eigen::Vector2d> m_points;
    Chroma m_meanChroma = Chroma::Zero();
};

} // namespace odo
