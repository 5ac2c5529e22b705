// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/compared_row.h"

#include "core/tracking/chroma_enlarger.h"
#include "core/tracking/difference_test.h"
#include "core/tracking/fetch_early.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr float plainSteps = 6;                    // of the least step: half of black on grey
constexpr float textureJitter = 0.08F;             // of the luma's slope: what coding and a lens that breathes move, pixels
constexpr float darkest = 0.40F, lightest = 0.99F; // of the floor in shadow against the floor in light
constexpr float darkestFloor = 12;                 // code values above black: on a darker one a shadow is not seen
constexpr int windowRowsAhead = 6;                 // that are fetched before they are read

/// Of a row of luma and those above and below it.
struct NoiseRows
{
    const std::uint8_t *here, *above, *below, *sigma;

    NoiseRows(const Background::Plane &luma, int y)
        : here(luma.row(y)), above(luma.row(std::max(0, y - 1))), below(luma.row(std::min(luma.height - 1, y + 1))), sigma(luma.sigmaRow(y))
    {
    }
    float at(int x, int left, int right, float jitter2) const
    {
        const int slopeX = here[right] - here[left], slopeY = below[x] - above[x];
        return squared(float(sigma[x]) * Background::sigmaUnit) + jitter2 * (squared(float(slopeX)) + squared(float(slopeY)));
    }
};

void readLumaNoise(const Background::Plane &luma, float factor, const PixelRect &part, int y, float *__restrict into)
{
    const NoiseRows rows(luma, y);
    const float jitter2 = squared(textureJitter * factor);
    const int x0 = part.x0, last = part.x1 - 1;
    for (int x = x0 + 1; x < last; ++x)
        into[x - x0] = rows.at(x, x - 1, x + 1, jitter2);
    into[0] = lumaNoise2At(luma, factor, x0, y);
    into[last - x0] = lumaNoise2At(luma, factor, last, y);
}

/// Of the sample that each pixel lies in.
void readChromaSigma(const Background &background, const PixelRect &part, int y, float *__restrict into)
{
    const int sx = background.format.chromaShiftX, cy = y >> background.format.chromaShiftY;
    const std::uint8_t *u = background.u.sigmaRow(cy) + (part.x0 >> sx), *v = background.v.sigmaRow(cy) + (part.x0 >> sx);
    const int perSample = 1 << sx, samples = (part.width() + perSample - 1) >> sx;
    const auto sigmaOf = [&](int k) { return float(std::max(u[k], v[k])) * Background::sigmaUnit; };
    if (perSample == 2) { // nearly always
        for (int k = 0; k < samples; ++k)
            into[2 * k] = into[2 * k + 1] = sigmaOf(k);
    } else {
        for (int k = 0; k < samples; ++k)
            std::fill_n(into + std::ptrdiff_t(k) * perSample, perSample, sigmaOf(k));
    }
}

} // namespace

float lumaNoise2At(const Background::Plane &luma, float factor, int x, int y)
{
    return NoiseRows(luma, y).at(x, std::max(0, x - 1), std::min(luma.width - 1, x + 1), squared(textureJitter * factor));
}

void ComparedRow::begin(const Frame &frame, const Background &background, const LightGain &gain, const PixelRect &part, int y)
{
    m_width = part.width();
    m_black = float(gain.black);
    m_factor = gain.factor;
    m_now = frame.y.row(y) + part.x0;
    m_behind = background.y.row(y) + part.x0;
    for (std::vector<float> *row : {&u, &v, &uBehind, &vBehind, &m_lumaNoise2, &m_chromaSigma})
        row->resize(std::size_t(ChromaEnlarger::rounded(part.width())));
    readLumaNoise(background.y, gain.factor, part, y, m_lumaNoise2.data());
    readChromaSigma(background, part, y, m_chromaSigma.data());
    if (y + windowRowsAhead < part.y1) {
        fetchEarly(frame.y.row(y + windowRowsAhead) + part.x0, m_width);
        fetchEarly(background.y.row(y + windowRowsAhead) + part.x0, m_width);
        fetchEarly(background.y.sigmaRow(y + windowRowsAhead) + part.x0, m_width);
    }
}

// In these loops stand differences above or below 0 instead of conditions, so that compilers do several pixels at once.

void ComparedRow::markDifferences(std::uint8_t *__restrict differs, std::uint8_t *__restrict plain) const
{
    const std::uint8_t *now = m_now, *behind = m_behind;
    const float *us = u.data(), *vs = v.data(), *usBehind = uBehind.data(), *vsBehind = vBehind.data();
    const float *lumaNoise2 = m_lumaNoise2.data(), *chromaSigma = m_chromaSigma.data();
    const float black = m_black, factor = m_factor;
    for (int x = 0; x < m_width; ++x) {
        const float luma = now[x], darker = (luma - black) - factor * (float(behind[x]) - black);
        const float leastDarker = std::min(0.0F, 255 * (luma - float(LightGain::mostLuma))); // none from there on: it may be as light as expected
        const float dy = std::max(darker, leastDarker);
        const float du = us[x] - usBehind[x], dv = vs[x] - vsBehind[x], ln = lumaNoise2[x], cn = squared(chromaSigma[x]);
        const float beyondNoise = dy * dy * cn + (du * du + dv * dv) * ln - differsInSigmas2 * ln * cn;
        const float steps = std::max(std::abs(dy) * (1 / leastLumaStep), std::max(std::abs(du), std::abs(dv)) * (1 / leastChromaStep));
        differs[x] = std::min(beyondNoise, steps - 1) > 0 ? 1 : 0;
        plain[x] = std::min(beyondNoise, steps - plainSteps) > 0 ? 1 : 0;
    }
}

void ComparedRow::markDarkened(int first, int last, std::uint8_t *__restrict darkened) const
{
    const std::uint8_t *now = m_now, *behind = m_behind;
    const float *us = u.data(), *vs = v.data(), *usBehind = uBehind.data(), *vsBehind = vBehind.data(), *chromaSigma = m_chromaSigma.data();
    const float black = m_black, factor = m_factor;
    for (int x = first; x < last; ++x) {
        const float luma = float(now[x]) - black, floor = factor * (float(behind[x]) - black), tolerance = 3 * chromaSigma[x] + 1.5F;
        const float beyondLuma = std::max(darkestFloor - floor, std::max(darkest * floor - luma, luma - lightest * floor));
        const float beyondU = std::abs(us[x] * floor - luma * usBehind[x]) - (tolerance + 0.1F * std::abs(usBehind[x])) * floor;
        const float beyondV = std::abs(vs[x] * floor - luma * vsBehind[x]) - (tolerance + 0.1F * std::abs(vsBehind[x])) * floor;
        darkened[x - first] = std::max(beyondLuma, std::max(beyondU, beyondV)) < 0 ? 1 : 0;
    }
}

} // namespace odo
