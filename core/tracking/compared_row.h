// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"
#include "core/tracking/light_gain.h"

#include <cstdint>
#include <vector>

namespace odo {

/// A row of pixels beside the background in the frame's light. Keeps its memory. One thread at a time.
class ComparedRow
{
public:
    /// Begins a row of a part of a whole frame of the background's format; y: of the picture. The chroma is to be written afterwards. Frame and background
    /// must outlive its use.
    void begin(const Frame &frame, const Background &background, const LightGain &gain, const PixelRect &part, int y);
    /// Chroma about neutral at the luma's resolution, with room for a few more than the part's columns.
    std::vector<float> u, v, uBehind, vBehind;

    /// Where luma or chroma differ by more than the place varies, and where by so much that even a few pixels are no noise: bytes of 0 or 1.
    void markDifferences(std::uint8_t *__restrict differs, std::uint8_t *__restrict plain) const;
    /// Where the floor would look so in a shadow: darker by a factor, the chroma alike. Bytes of columns first up to, not including, last.
    void markDarkened(int first, int last, std::uint8_t *__restrict darkened) const;

private:
    int m_width = 0;
    float m_black = 0, m_factor = 1;
    const std::uint8_t *m_now = nullptr, *m_behind = nullptr;
    std::vector<float> m_lumaNoise2, m_chromaSigma;
};

/// The variance of a background's luma at a pixel in another light: noise, and what moves with the slope of the picture.
float lumaNoise2At(const Background::Plane &luma, float factor, int x, int y);

} // namespace odo
