// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"
#include "core/tracking/internal/bit_mask.h"
#include "core/tracking/internal/difference_windows.h"
#include "core/video/frame.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace odo {

/// Scales the results for the chroma samples of a part of a frame to the luma's resolution, row by row and
/// bilinearly: each sample at its siting; the outermost samples are repeated beyond the frame. One thread at
/// a time.
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
    static int paddedColumns(int columns) { return columns + atOnce - 1; }

    /// Makes a plane of the part's samples. valuesOf(row, first, last, into): writes those of a row of the
    /// plane from column first to before last.
    template <class ValuesOf>
    void takeSamples(int planeWidth, int planeHeight, const ValuesOf &valuesOf, cv::Mat1s &into) const
    {
        into.create(m_samples.height(), m_samples.width() + 2 * atOnce);
        const int first = std::max(0, m_samples.x0), last = std::min(planeWidth, m_samples.x1);
        for (int y = 0; y < into.rows; ++y) {
            std::int16_t *row = into[y];
            valuesOf(std::clamp(m_samples.y0 + y, 0, planeHeight - 1), first, last,
                     row + (first - m_samples.x0));
            std::fill(row, row + (first - m_samples.x0), row[first - m_samples.x0]);
            std::fill(row + (last - m_samples.x0), row + into.cols, row[last - 1 - m_samples.x0]);
        }
    }
    /// Values at luma pixels of a row of the part, whose first is row 0, from column first, a multiple of
    /// columnUnit, to before last and a few more.
    void enlargeRow(const cv::Mat1s &samples, int y, int first, int last, std::int16_t *into);

private:
    static constexpr int atOnce = 16;

    FrameFormat m_format;
    PixelRect m_part, m_samples;
    /// of each luma column of a chroma sample: the sample to its left, against that one
    std::array<int, columnUnit> m_first{};
    /// and how far beyond it the column lies, in parts of a sample
    std::array<int, columnUnit> m_beyond{};
    std::vector<std::int16_t> m_blended; ///< of one row
};

/// A row of pixels beside the background in the frame's light.
struct ComparedRow
{
    static constexpr int leastWidth = 16;

    int width = 0; ///< at least leastWidth
    LightGain gain;
    Background::Shadow shadow;
    /// luma as coded, the background's in its own light
    const std::uint8_t *now = nullptr, *behind = nullptr;
    /// chroma about neutral in units of 1 / ChromaEnlarger::unit
    const std::int16_t *u = nullptr, *v = nullptr;
    const std::int16_t *uBehind = nullptr, *vBehind = nullptr; ///< of the background in the frame's light
    /// of the noise (core/tracking/internal/difference_windows.h)
    const std::int16_t *lumaInverse = nullptr, *chromaInverse = nullptr;

    /// Where luma or chroma differ by more than the background varies, and where by so much that even a few
    /// pixels are no noise: bytes of 0 or 1.
    void markDifferences(std::uint8_t *__restrict differs, std::uint8_t *__restrict plain) const;
    /// Where the floor would look so in a shadow: darker by a factor, the chroma alike but for a tint. Bytes
    /// of 0 or 1 of columns first up to, not including, last, and perhaps of others.
    void markDarkened(int first, int last, std::uint8_t *__restrict darkened) const;
};

/// Luma above black and chroma about neutral, code values.
struct PixelColour
{
    float luma = 0, u = 0, v = 0;
};

/// A frame and the background in the frame's light, around the foreground in a part of the frame. Keeps its
/// memory. One thread at a time.
class ComparedWindow
{
public:
    /// background: must outlive this.
    explicit ComparedWindow(const Background &background);

    /// Pixels of the frame outside of which nothing is foreground.
    void searchOnly(BitMask searched) { m_searched = std::move(searched); }

    /// Compares a part of a whole frame of the background's format. The frame must outlive the use of what
    /// was found.
    void compare(const Frame &frame, const LightGain &gain, const DifferenceWindow &part);

    /// The window around the foreground; empty if there is none. Everything else is in its pixels, and known
    /// only near the foreground.
    const PixelRect &rect() const { return m_rect; }
    int width() const { return m_rect.width(); }
    int height() const { return m_rect.height(); }
    /// Where luma or chroma differ by more than the background varies.
    const BitMask &differs() const { return m_differs; }
    /// Where they do by so much that even a few pixels are no noise.
    const BitMask &plain() const { return m_plain; }
    /// The part of the foreground that may be floor in shadow.
    const BitMask &darkened() const { return m_darkened; }

    PixelColour seen(int x, int y) const
    {
        return {float(m_frame->y.row(m_rect.y0 + y)[m_rect.x0 + x] - m_gain.black), m_u(y, x) / chromaUnit,
                m_v(y, x) / chromaUnit};
    }
    PixelColour behind(int x, int y) const
    {
        return {m_gain.factor * float(m_background.y.row(m_rect.y0 + y)[m_rect.x0 + x] - m_gain.black),
                m_uBehind(y, x) / chromaUnit, m_vBehind(y, x) / chromaUnit};
    }
    /// Variances of the background: at a pixel, and of a row's pixels from column first to before last.
    float lumaNoise2(int x, int y) const
    {
        return noise2At(m_background.y, m_gain.factor, m_rect.x0 + x, m_rect.y0 + y);
    }
    void readLumaNoise2(int y, int first, int last, float *into) const
    {
        noise2InRow(m_background.y, m_gain.factor, m_rect.y0 + y, m_rect.x0 + first, m_rect.x0 + last, into);
    }
    void readChromaNoise2(int y, int first, int last, float *__restrict into) const;
    /// Asks for what they are made of to be brought near the processor, before they are read.
    void fetchNoise(int y, int first, int last) const;

    /// A row of luma as coded, and of chroma as seen in units of 1 / chromaUnit.
    const std::uint8_t *lumaRow(int y) const { return m_frame->y.row(m_rect.y0 + y) + m_rect.x0; }
    const std::int16_t *uRow(int y) const { return m_u[y]; }
    const std::int16_t *vRow(int y) const { return m_v[y]; }
    /// The same of the background, the chroma in the frame's light.
    const std::uint8_t *lumaBehindRow(int y) const { return m_background.y.row(m_rect.y0 + y) + m_rect.x0; }
    const std::int16_t *uBehindRow(int y) const { return m_uBehind[y]; }
    const std::int16_t *vBehindRow(int y) const { return m_vBehind[y]; }
    const LightGain &gain() const { return m_gain; }
    const Background::Shadow &shadow() const { return m_background.shadow; }
    static constexpr float chromaUnit = ChromaEnlarger::unit;

private:
    void compareRows(const DifferenceWindow &part);
    void compareRow(const DifferenceWindow &part, int y, ChromaEnlarger &enlarger);
    void readChromaInverse(int x0, int width, int chromaY);
    void positionAround(const PixelRect &found, const PixelRect &part);

    const Background &m_background;
    BackgroundNoise m_noise;
    const Frame *m_frame = nullptr;
    LightGain m_gain;
    std::optional<BitMask> m_searched;
    PixelRect m_rect;
    BitMask m_differs, m_plain, m_darkened;
    cv::Mat1s m_u, m_v, m_uBehind, m_vBehind;                 ///< parts of those below
    cv::Mat1s m_uPart, m_vPart, m_uBehindPart, m_vBehindPart; ///< of the whole part
    cv::Mat1s m_uSamples, m_vSamples, m_uBehindSamples, m_vBehindSamples;
    std::vector<std::int16_t> m_chromaInverse; ///< of one row's pixels
    std::vector<std::uint8_t> m_marks, m_plainMarks, m_darkMarks;
};

} // namespace odo
