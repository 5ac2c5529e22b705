// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/compared_window.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odo {

/// Tells which of the pixels that differ may be floor in shadow: darker by a factor, with the floor's chroma darkened alike. A flat surface of the floor's
/// own hue looks the same; where the floor behind has texture and the surface has none, it is no shadow. Keeps its memory. One thread at a time.
class FloorShade
{
public:
    void find(const ComparedWindow &window);

    /// Pixels of the window that may be floor in shadow.
    const BitMask &shade() const { return m_shade; }
    /// Those that only the mean hue of the pixels around tells from a shadow: where such a surface ends is known to some pixels.
    const BitMask &byHue() const { return m_byHue; }

private:
    /// Of the pixels that may be in shadow: their number, the logarithms of luma and its squares as seen and behind, and by how much the chroma is
    /// off that of the floor in shadow, all in fixed point so that they can be added and taken away without loss.
    using Sums = std::array<std::int32_t, 8>;

    void takeRow(const ComparedWindow &window, int y);
    void judgeRow(const ComparedWindow &window, int y);
    void judge(const ComparedWindow &window, const Sums &sums, int x, int y);
    std::vector<Sums> &slot(int y);
    void exchangeRows(const std::vector<Sums> &added, const std::vector<Sums> &removed);

    BitMask m_shade, m_byHue;
    PixelRect m_box;                       ///< of what may be in shadow
    std::vector<std::vector<Sums>> m_rows; ///< of a patch's height and one above it, each with half a patch at both ends
    std::vector<Sums> m_columns;           ///< what they add up to
};

} // namespace odo
