// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>
#include <vector>

namespace odo {

/// Brings what is known of the chroma samples of a part of a picture to the luma's resolution, row by row and bilinearly: each sample where its siting
/// has it; beyond the picture's outermost samples lie their copies. One thread at a time.
class ChromaEnlarger
{
public:
    /// part: of luma pixels, from a multiple of columnUnit on.
    ChromaEnlarger(const FrameFormat &format, const PixelRect &part);

    /// So many luma columns belong to whole chroma samples in every format.
    static constexpr int columnUnit = 4;
    /// Values are in units of 1 / unit code values: as fine as halved chroma is between its samples.
    static constexpr int unit = 16;
    /// The samples that the part needs; up to one beyond the plane on each side.
    const PixelRect &samples() const { return m_samples; }
    /// So many values are written at most for so many columns, as several are made at once.
    static int room(int columns) { return columns + atOnce - 1; }

    /// Makes a plane of the part's samples. valuesOf(row, first, last, into): writes those of a row of the plane from column first to before last.
    template <class ValuesOf>
    void takeSamples(int planeWidth, int planeHeight, const ValuesOf &valuesOf, cv::Mat1s &into) const
    {
        into.create(m_samples.height(), m_samples.width() + 2 * atOnce);
        const int first = std::max(0, m_samples.x0), last = std::min(planeWidth, m_samples.x1);
        for (int y = 0; y < into.rows; ++y) {
            std::int16_t *row = into[y];
            valuesOf(std::clamp(m_samples.y0 + y, 0, planeHeight - 1), first, last, row + (first - m_samples.x0));
            std::fill(row, row + (first - m_samples.x0), row[first - m_samples.x0]);
            std::fill(row + (last - m_samples.x0), row + into.cols, row[last - 1 - m_samples.x0]);
        }
    }
    /// Values at luma pixels of a row of the part, whose first is row 0, from column first, a multiple of columnUnit, to before last and a few more.
    void enlargeRow(const cv::Mat1s &samples, int y, int first, int last, std::int16_t *into);

private:
    static constexpr int atOnce = 16;

    FrameFormat m_format;
    PixelRect m_part, m_samples;
    std::array<int, columnUnit> m_first{};     ///< of each luma column of a chroma sample: the sample to its left, against that one
    std::array<int, columnUnit> m_beyond{};    ///< and how far beyond it the column lies, in parts of a sample
    std::vector<std::int16_t> m_blended;       ///< of one row
};

} // namespace odo
