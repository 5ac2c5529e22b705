// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"
#include "core/tracking/internal/bit_mask.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odo {

/// Where to look closer, luma pixels.
struct DifferenceWindow
{
    /// Columns from the window's left edge, begin up to, not including, end.
    struct Band
    {
        int begin = 0, end = 0;         ///< to be read
        int safeBegin = 0, safeEnd = 0; ///< where pixels count; what is within safePx of them is read, too
    };
    static constexpr int safePx = 4;

    PixelRect rect;
    std::vector<Band> bands; ///< of DifferenceLattice::step rows each, from the top
};

/// Windows around the foreground on a lattice (core/tracking/internal/difference_windows.h), which do not
/// overlap; in groups of those that are near one another, as a robot and its shadow may be. Single samples
/// are noise and get none. Pure.
std::vector<std::vector<DifferenceWindow>> windowsAround(const BitMask &differences, const PixelRect &image);

/// A frame beside its background on a lattice of every fourth pixel, which shows at little cost where to look
/// closer. Keeps copies of the lattice's samples. One thread at a time.
class DifferenceLattice
{
public:
    /// luma pixels between samples, the first of which is half as far from the frame's edge
    static constexpr int step = 4;

    DifferenceLattice() = default;
    explicit DifferenceLattice(const Background &background);

    /// Compares a whole frame of the background's format; background: that which it was made of.
    void compare(const Frame &frame, const Background &background);
    /// How much lighter the frame is than the background.
    const LightGain &gain() const { return m_gain; }
    /// Where luma or chroma differ by more than the background varies.
    const BitMask &differences() const { return m_differences; }

private:
    /// One sample of each plane for every point of the lattice, row by row.
    struct Samples
    {
        std::vector<std::uint8_t> y, u, v;
    };
    template <class RowOf>
    void takePlane(const RowOf &rowOf, int shiftX, int shiftY, std::vector<std::uint8_t> &into) const;
    void adaptToLight();
    void compareRow(int j);
    bool differs(std::size_t inImage, std::size_t inRow) const;

    FrameFormat m_format;
    int m_columns = 0, m_rows = 0;
    Samples m_behind, m_sigmas;
    std::vector<std::uint8_t> m_luma;            ///< of the frame
    std::vector<std::uint8_t> m_u, m_v, m_steps; ///< of one row
    std::vector<std::uint8_t> m_litBehind;       ///< luma of the background in the frame's light
    std::array<std::uint8_t, 256> m_litTable{};  ///< by which it was made
    LightGain m_gain;
    BitMask m_differences;
};

/// The noise of a background as pixels are compared with it, by its inverse: unit / sigma, sigma in code
/// values, including what coding and a breathing lens move at the image's slopes. In the background's own
/// light. Pure.
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

/// The variances of one plane of a background in another light, with what its slopes make, at the samples of
/// a row from column first to before last.
void noise2InRow(const Background::Plane &plane, float factor, int y, int first, int last,
                 float *__restrict into);

/// That of one sample.
inline float noise2At(const Background::Plane &plane, float factor, int x, int y)
{
    float noise2 = 0;
    noise2InRow(plane, factor, y, x, x + 1, &noise2);
    return noise2;
}

/// When a pixel differs from its background: by at least one of these steps, and by more than this sum of
/// squares in units of the noise.
inline constexpr float differsInSigmas2 = 20;
inline constexpr float leastLumaStep = 6, leastChromaStep = 3.5F; ///< code values

inline float squared(float value)
{
    return value * value;
}

} // namespace odo
