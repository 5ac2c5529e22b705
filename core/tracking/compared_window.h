// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background_noise.h"
#include "core/tracking/bit_mask.h"
#include "core/tracking/chroma_enlarger.h"
#include "core/tracking/compared_row.h"
#include "core/tracking/difference_windows.h"

#include <opencv2/core.hpp>

namespace odo {

/// Luma above black and chroma about neutral, code values.
struct PixelColour
{
    float luma = 0, u = 0, v = 0;
};

/// A frame beside the background in the frame's light, around what differs in a part of the picture. Keeps its memory. One thread at a time.
class ComparedWindow
{
public:
    /// background: must outlive this.
    explicit ComparedWindow(const Background &background);

    /// Compares a part of a whole frame of the background's format. The frame must outlive the use of what was found.
    void compare(const Frame &frame, const LightGain &gain, const DifferenceWindow &part);

    /// The window, around what differs; empty where nothing does. All else is in its pixels, and known only near what differs.
    const PixelRect &rect() const { return m_rect; }
    int width() const { return m_rect.width(); }
    int height() const { return m_rect.height(); }
    /// Where luma or chroma differ by more than the place varies.
    const BitMask &differs() const { return m_differs; }
    /// Where they do by so much that even a few pixels are no noise.
    const BitMask &plain() const { return m_plain; }
    /// Where the floor would look so in a shadow, of what differs.
    const BitMask &darkened() const { return m_darkened; }

    PixelColour seen(int x, int y) const { return {float(m_frame->y.row(m_rect.y0 + y)[m_rect.x0 + x] - m_gain.black), m_u(y, x) / chromaUnit, m_v(y, x) / chromaUnit}; }
    PixelColour behind(int x, int y) const
    {
        return {m_gain.factor * float(m_background.y.row(m_rect.y0 + y)[m_rect.x0 + x] - m_gain.black), m_uBehind(y, x) / chromaUnit, m_vBehind(y, x) / chromaUnit};
    }
    /// Variances of the background.
    float lumaNoise2(int x, int y) const { return lumaNoise2At(m_background.y, m_gain.factor, m_rect.x0 + x, m_rect.y0 + y); }
    float chromaNoise2(int x, int y) const;

    /// A row of luma as coded, and of chroma as seen in units of 1 / chromaUnit.
    const std::uint8_t *lumaRow(int y) const { return m_frame->y.row(m_rect.y0 + y) + m_rect.x0; }
    const std::int16_t *uRow(int y) const { return m_u[y]; }
    const std::int16_t *vRow(int y) const { return m_v[y]; }
    /// The same of the background, the chroma in the frame's light.
    const std::uint8_t *lumaBehindRow(int y) const { return m_background.y.row(m_rect.y0 + y) + m_rect.x0; }
    const std::int16_t *uBehindRow(int y) const { return m_uBehind[y]; }
    const std::int16_t *vBehindRow(int y) const { return m_vBehind[y]; }
    const LightGain &gain() const { return m_gain; }
    static constexpr float chromaUnit = ChromaEnlarger::unit;

private:
    void compareRows(const DifferenceWindow &part);
    void compareRow(const DifferenceWindow &part, int y, ChromaEnlarger &enlarger);
    void readChromaInverse(int x0, int width, int y);
    void placeAround(const PixelRect &found, const PixelRect &part);

    const Background &m_background;
    BackgroundNoise m_noise;
    const Frame *m_frame = nullptr;
    LightGain m_gain;
    PixelRect m_rect;
    BitMask m_differs, m_plain, m_darkened;
    cv::Mat1s m_u, m_v, m_uBehind, m_vBehind;                 ///< parts of those below
    cv::Mat1s m_uPart, m_vPart, m_uBehindPart, m_vBehindPart; ///< of the whole part
    cv::Mat1s m_uSamples, m_vSamples, m_uBehindSamples, m_vBehindSamples;
    std::vector<std::int16_t> m_chromaInverse;                    ///< of one row's pixels
    std::vector<std::uint8_t> m_marks, m_plainMarks, m_darkMarks;
};

} // namespace odo
