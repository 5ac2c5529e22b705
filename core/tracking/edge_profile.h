// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

/// The samples of a plane along a scan line, as running sums: the mean over any stretch of it costs nothing.
/// Places are luma pixels along the line.
class EdgeProfile
{
public:
    static constexpr int mostSamples = 24;

    /// The first sample is centred at `first`; the next ones follow at `spacing`.
    EdgeProfile(float first, float spacing)
        : m_begin(first - 0.5f * spacing), m_spacing(spacing), m_perSpacing(1 / spacing)
    {
        m_sums[0] = 0;
    }

    void add(float value)
    {
        m_sums[m_count + 1] = m_sums[m_count] + value;
        ++m_count;
    }
    float mean(float from, float to) const { return (upTo(to) - upTo(from)) / (to - from); }
    bool covers(float from, float to) const
    {
        return from >= m_begin && to <= m_begin + m_spacing * static_cast<float>(m_count);
    }

    /// Sum from the begin of the profile up to a place.
    float upTo(float place) const
    {
        const float at =
            std::clamp((place - m_begin) * m_perSpacing, 0.0f, static_cast<float>(m_count) - 0.001f);
        const int i = static_cast<int>(at);
        return m_spacing * (m_sums[i] + (at - static_cast<float>(i)) * (m_sums[i + 1] - m_sums[i]));
    }

private:
    std::array<float, mostSamples + 1> m_sums; ///< only the first count + 1 are set
    float m_begin, m_spacing, m_perSpacing;
    int m_count = 0;
};

/// How an edge is looked for about the place where it is expected.
struct EdgeSearch
{
    float inward = 1;    ///< +1: the inside is at larger places; −1: at smaller ones
    float halfWidth = 1; ///< of the stretch about the edge that must be made up of inside and outside
    float reference = 1; ///< length of the stretches beside it that show what inside and outside are
    bool leadOn =
        false; ///< the outside changes towards the edge, as a shadow does: led on along a straight line
};

/// Moves `place` to where the edge must be for the samples about it to be the sum of both sides: exact for a
/// step of any symmetric blur once repeated until it stays. Returns the contrast, inside less outside; when
/// it is below the least the place stays.
inline float moveToEdge(const EdgeProfile &profile, const EdgeSearch &search, float leastContrast,
                        float &place)
{
    const float h = search.halfWidth, r = search.reference, d = search.inward, perR = d / r;
    // Sums up to the ends of the stretches, from the inside outwards.
    const float inner = profile.upTo(place + d * (h + r)), innerEnd = profile.upTo(place + d * h),
                outerEnd = profile.upTo(place - d * h), outer = profile.upTo(place - d * (h + r));
    const float in = perR * (inner - innerEnd);
    float out = perR * (outerEnd - outer);
    if (search.leadOn) {
        const float farther = perR * (outer - profile.upTo(place - d * (h + 2 * r)));
        out += (out - farther) * (0.5f + 0.5f * h * d * perR);
    }
    const float contrast = in - out;
    if (std::abs(contrast) < leastContrast)
        return contrast;
    const float across = d * (innerEnd - outerEnd) / (2 * h);
    const float inside = std::clamp((across - out) / contrast, 0.0f, 1.0f);
    place += d * h * (1 - 2 * inside);
    return contrast;
}

} // namespace odo
