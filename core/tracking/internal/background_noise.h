// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"

#include <cstdint>
#include <vector>

namespace odo {

/// The noise of a background as pixels are compared with it, by its inverse: unit / sigma, sigma in code
/// values. For luma with what coding and a lens that breathes move of the picture's slopes. Of the
/// background's own light. Pure.
class BackgroundNoise
{
public:
    explicit BackgroundNoise(const Background &background);

    static constexpr int unit = 16384;
    const std::int16_t *lumaRow(int y) const { return m_luma.data() + std::ptrdiff_t(y) * m_lumaWidth; }
    /// Of the noisier of both planes, for each chroma sample.
    const std::int16_t *chromaRow(int y) const { return m_chroma.data() + std::ptrdiff_t(y) * m_chromaWidth; }

private:
    int m_lumaWidth, m_chromaWidth;
    std::vector<std::int16_t> m_luma, m_chroma;
};

/// The variance of a background's luma at a pixel, with what its slopes make, in another light.
float lumaNoise2At(const Background::Plane &luma, float factor, int x, int y);

/// When a pixel differs from its background: by at least one of these steps, and by more than this sum of
/// squares in units of the noise.
inline constexpr float differsInSigmas2 = 20;
inline constexpr float leastLumaStep = 6, leastChromaStep = 3.5F; ///< code values

inline float squared(float value)
{
    return value * value;
}

} // namespace odo
