// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/background_noise.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

// of the luma's slope: what coding and a lens that breathes move, pixels
constexpr float textureJitter = 0.08F;

/// Of a row of luma and those above and below it.
struct NoiseRows
{
    const std::uint8_t *here, *above, *below, *sigma;

    NoiseRows(const Background::Plane &luma, int y)
        : here(luma.row(y)), above(luma.row(std::max(0, y - 1))),
          below(luma.row(std::min(luma.height - 1, y + 1))), sigma(luma.sigmaRow(y))
    {
    }
    float at(int x, int left, int right, float jitter2) const
    {
        const int slopeX = here[right] - here[left], slopeY = below[x] - above[x];
        return squared(float(sigma[x]) * Background::sigmaUnit) +
               jitter2 * (squared(float(slopeX)) + squared(float(slopeY)));
    }
};

std::int16_t inverseOf(float sigma)
{
    return std::int16_t(float(BackgroundNoise::unit) / sigma);
}

} // namespace

float lumaNoise2At(const Background::Plane &luma, float factor, int x, int y)
{
    return NoiseRows(luma, y).at(x, std::max(0, x - 1), std::min(luma.width - 1, x + 1),
                                 squared(textureJitter * factor));
}

BackgroundNoise::BackgroundNoise(const Background &background)
    : m_lumaWidth(background.y.width), m_chromaWidth(background.u.width), m_luma(background.y.values.size()),
      m_chroma(background.u.values.size())
{
    static_assert(Background::leastSigma >= 1); // so that all inverses fit
    for (int y = 0; y < background.y.height; ++y) {
        const NoiseRows rows(background.y, y);
        std::int16_t *__restrict into = m_luma.data() + std::ptrdiff_t(y) * m_lumaWidth;
        for (int x = 1; x < m_lumaWidth - 1; ++x)
            into[x] = inverseOf(std::sqrt(rows.at(x, x - 1, x + 1, squared(textureJitter))));
        for (const int x : {0, m_lumaWidth - 1})
            into[x] = inverseOf(std::sqrt(lumaNoise2At(background.y, 1, x, y)));
    }
    for (std::size_t i = 0; i < m_chroma.size(); ++i)
        m_chroma[i] = inverseOf(float(std::max(background.u.sigmas[i], background.v.sigmas[i])) *
                                Background::sigmaUnit);
}

} // namespace odo
