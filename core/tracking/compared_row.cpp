// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/compared_row.h"

#include "core/tracking/background_noise.h"
#include "core/tracking/chroma_enlarger.h"
#include "core/tracking/difference_test.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr float plainSteps = 6;                    // of the least step: half of black on grey
constexpr float lightest = 0.99F;                  // of the floor in shadow against the floor in light
constexpr float darkestFloor = 12;                 // code values above black: on a darker one a shadow is not seen

// Fixed-point numbers of 16 bits, of which compilers do eight at once. Luma is in units of 1 / lumaUnit, shares of the noise of 1 / shareUnit.
using Fixed = std::int16_t;
constexpr int lumaUnit = 8, chromaUnit = ChromaEnlarger::unit, shareUnit = 32;
constexpr Fixed mostLumaStep = 255 * lumaUnit, mostChromaStep = 255 * chromaUnit;
constexpr Fixed mostShare = 144; // beyond what differs by itself; three squares of it fit in 16 bits
static_assert(mostShare * mostShare > shareUnit * shareUnit * differsInSigmas2 && 3 * mostShare * mostShare < (1 << 16));

// By value, other than std::min and std::max: so compilers know them.
Fixed lesser(Fixed a, Fixed b)
{
    return a < b ? a : b;
}

Fixed greater(Fixed a, Fixed b)
{
    return a > b ? a : b;
}

Fixed size(Fixed value)
{
    return greater(value, Fixed(-value));
}

/// The upper half of a product.
Fixed upper(Fixed a, Fixed b)
{
    return Fixed((int(a) * int(b)) >> 16);
}

std::uint16_t square(Fixed value)
{
    return std::uint16_t(std::uint16_t(value) * std::uint16_t(value));
}

constexpr int halfUnit = 1 << 15, quarterUnit = 1 << 14; // by which `upper` takes a half and a quarter

/// Steps in units of the noise.
Fixed lumaShare(Fixed step, Fixed inverse)
{
    constexpr int enlarged = 16;
    static_assert(lumaUnit * enlarged * BackgroundNoise::unit == shareUnit << 16);
    return upper(Fixed(step * enlarged), inverse);
}

Fixed chromaShare(Fixed step, Fixed inverse)
{
    constexpr int enlarged = 8;
    static_assert(chromaUnit * enlarged * BackgroundNoise::unit == shareUnit << 16);
    return upper(Fixed(step * enlarged), inverse);
}

/// Luma above black, as seen and of the background in the frame's light.
class LumaPair
{
public:
    explicit LumaPair(const ComparedRow &row)
        : m_now(row.now), m_behind(row.behind), m_black(Fixed(row.gain.black)), m_factor(Fixed(std::lround(row.gain.factor * factorUnit)))
    {
    }
    bool isBright(int x) const { return m_now[x] >= LightGain::mostLuma; }
    Fixed seen(int x) const { return Fixed(Fixed(m_now[x] - m_black) * lumaUnit); }
    Fixed floor(int x) const { return upper(Fixed(Fixed(m_behind[x] - m_black) * (lumaUnit * (1 << 16) / factorUnit)), m_factor); }

private:
    static constexpr int factorUnit = 4096;
    const std::uint8_t *m_now, *m_behind;
    Fixed m_black, m_factor;
};

struct ChromaPair
{
    const Fixed *seen, *behind;

    Fixed step(int x) const { return lesser(size(Fixed(seen[x] - behind[x])), mostChromaStep); }
};

/// Does something for so many columns and perhaps a few beside them, in blocks, the last of which overlaps the one before: so no columns remain that are
/// done singly.
template <class Function>
void forBlocks(int first, int last, int width, const Function &function)
{
    constexpr int block = ComparedRow::leastWidth;
    for (int begin = first; begin < last; begin += block)
        for (int i = 0; i < block; ++i)
            function(std::min(begin, width - block) + i);
}

} // namespace

void ComparedRow::markDifferences(std::uint8_t *__restrict differs, std::uint8_t *__restrict plain) const
{
    constexpr auto least = std::uint16_t(differsInSigmas2 * shareUnit * shareUnit);
    constexpr auto lumaStep = Fixed(leastLumaStep * lumaUnit), chromaStep = Fixed(leastChromaStep * chromaUnit);
    constexpr auto plainLuma = Fixed(plainSteps * lumaStep), plainChroma = Fixed(plainSteps * chromaStep);
    const auto perNoise = Fixed(std::lround(32767 / std::max(1.0F, gain.factor))); // the noise grows with the light
    const LumaPair lumas(*this);
    const ChromaPair us{u, uBehind}, vs{v, vBehind};
    const Fixed *perLuma = lumaInverse, *perChroma = chromaInverse;
    forBlocks(0, width, width, [=](int x) {
        const Fixed lighter = Fixed(lumas.seen(x) - lumas.floor(x)), step = lumas.isBright(x) ? greater(lighter, 0) : lighter; // it may be as light as expected
        const Fixed stepY = lesser(size(step), mostLumaStep), stepU = us.step(x), stepV = vs.step(x), chroma = greater(stepU, stepV);
        const Fixed shareY = lesser(upper(Fixed(lumaShare(stepY, perLuma[x]) * 2), perNoise), mostShare);
        const Fixed shareU = lesser(chromaShare(stepU, perChroma[x]), mostShare), shareV = lesser(chromaShare(stepV, perChroma[x]), mostShare);
        const bool isBeyondNoise = std::uint16_t(square(shareY) + square(shareU) + square(shareV)) > least;
        differs[x] = isBeyondNoise & ((stepY > lumaStep) | (chroma > chromaStep));
        plain[x] = isBeyondNoise & ((stepY > plainLuma) | (chroma > plainChroma));
    });
}

void ComparedRow::markDarkened(int first, int last, std::uint8_t *__restrict darkened) const
{
    constexpr auto leastFloor = Fixed(darkestFloor * lumaUnit), mostLight = Fixed(lightest * halfUnit);
    constexpr auto tolerance = Fixed(1.5F * chromaUnit), ofHue = Fixed(0.1F * 2 * halfUnit), mostNoise = Fixed(3 * shareUnit);
    const auto leastShare = Fixed(std::lround(darkestShadow * halfUnit));
    const LumaPair lumas(*this);
    const ChromaPair us{u, uBehind}, vs{v, vBehind};
    const Fixed *perChroma = chromaInverse;
    forBlocks(first, last, width, [=](int x) {
        const Fixed luma = lumas.seen(x), floor = lumas.floor(x), twice = Fixed(2 * floor);
        const bool isBetween = (floor > leastFloor) & (luma > upper(twice, leastShare)) & (luma < upper(twice, mostLight));
        const auto ratio = Fixed(int(quarterUnit * float(lesser(luma, floor)) / float(greater(floor, 1))));
        const auto isAlike = [=](const ChromaPair &pair) {
            const Fixed expected = upper(Fixed(4 * pair.behind[x]), ratio), off = lesser(size(Fixed(pair.seen[x] - expected)), mostChromaStep);
            const Fixed beyond = Fixed(off - tolerance - upper(size(pair.behind[x]), ofHue));
            return chromaShare(beyond, perChroma[x]) < mostNoise;
        };
        darkened[x] = isBetween & isAlike(us) & isAlike(vs);
    });
}

} // namespace odo
