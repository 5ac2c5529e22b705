// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/light_gain.h"

#include <cstdint>

namespace odo {

/// A row of pixels beside the background in the frame's light.
struct ComparedRow
{
    static constexpr int leastWidth = 16;

    int width = 0; ///< at least leastWidth
    LightGain gain;
    float darkestShadow = 0; ///< of the floor's light that a shadow leaves
    const std::uint8_t *now = nullptr, *behind = nullptr;      ///< luma as coded, the background's in its own light
    const std::int16_t *u = nullptr, *v = nullptr;             ///< chroma about neutral in units of 1 / ChromaEnlarger::unit
    const std::int16_t *uBehind = nullptr, *vBehind = nullptr; ///< of the background in the frame's light
    const std::int16_t *lumaInverse = nullptr, *chromaInverse = nullptr; ///< of the noise (core/tracking/background_noise.h)

    /// Where luma or chroma differ by more than the place varies, and where by so much that even a few pixels are no noise: bytes of 0 or 1.
    void markDifferences(std::uint8_t *__restrict differs, std::uint8_t *__restrict plain) const;
    /// Where the floor would look so in a shadow: darker by a factor, the chroma alike. Bytes of 0 or 1 of columns first up to,
    /// not including, last, and perhaps of others.
    void markDarkened(int first, int last, std::uint8_t *__restrict darkened) const;
};

} // namespace odo
