// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/compared_window.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odo {

/// Finds which foreground pixels may be floor in shadow: darker by a factor, with the floor's chroma
/// darkened alike. A flat surface of the floor's own hue looks the same; where the floor behind has texture
/// and the surface has none, it is no shadow. Keeps its memory. One thread at a time.
class FloorShade
{
public:
    void find(const ComparedWindow &window);

    /// Pixels of the window that may be floor in shadow.
    const BitMask &shade() const { return m_shade; }
    /// Those that only the mean hue of the pixels around distinguishes from a shadow: where such a surface
    /// ends is known to some pixels.
    const BitMask &byHue() const { return m_byHue; }

private:
    /// Of pixels that may be in shadow: the log sums of luma as seen and behind, and by how much the chroma
    /// is off that of the floor in shadow. Whole numbers, so that pixels can be added and removed without
    /// loss.
    struct Sums
    {
        std::uint64_t seen = 0, behind = 0;
        std::int64_t offU = 0, offV = 0;

        void add(const Sums &other);
        void remove(const Sums &other);
    };

    void readGain(const LightGain &gain);
    std::vector<Sums> &rowAt(int y);
    void removeRow(const ComparedWindow &window, int y);
    void takeRow(const ComparedWindow &window, int y);
    void judgeRow(const ComparedWindow &window, int y);
    void judge(const ComparedWindow &window, const Sums &sums, int x, int y);

    BitMask m_shade, m_byHue;
    /// reciprocals of the background's luma in the frame's light, fixed point, by its luma above black
    std::array<std::int32_t, 256> m_perLuma{};
    /// of a patch's height; only the pixels that may be in shadow are written
    std::vector<std::vector<Sums>> m_rows;
    /// what the rows add up to, with half a patch more at both ends
    std::vector<Sums> m_columns;
};

} // namespace odo
