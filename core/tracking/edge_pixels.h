// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace odo {

/// Pixels on a region's edge, one value of each kind for each, so that many are computed at once. Luma and chroma as in PixelColour.
struct EdgePixels
{
    /// Of the pixels around: the number of those inside with their luma and chroma, the latter in units of 1 / ComparedWindow::chromaUnit, and the
    /// number of those outside with their light against the background's, in units of 1 / lightUnit.
    using Sums = std::array<std::int32_t, 8>;
    enum Sum { insideCount, insideLuma, insideU, insideV, outsideCount, outsideLight };
    static constexpr int lightUnit = 4096;

    std::size_t count = 0;         ///< in use of the values below
    std::vector<std::size_t> at;   ///< where they are, for whoever fills in the values
    std::vector<Sums> around;
    std::vector<float> luma, u, v; ///< as seen
    std::vector<float> lumaBehind, uBehind, vBehind; ///< of the floor in full light
    std::vector<float> lumaNoise2, chromaNoise2;
    std::vector<std::array<float, 2>> found;

    void makeRoom(std::size_t pixels);
    /// Finds what part of each pixel the region covers, which may be less than nothing and more than all, and by how much the contrast between inside and
    /// outside is clear of noise: not at all where it is negative or, as nothing is inside, no number.
    void findCovered();
};

} // namespace odo
