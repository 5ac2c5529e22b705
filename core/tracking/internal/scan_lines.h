// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/blob_finder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odo {

/// A line of samples across the outline, along a row or a column of the chroma plane and the luma rows or
/// columns that it stands for. Lengths in luma pixels.
struct ScanLine
{
    bool alongX = false;
    int line = 0;     ///< chroma row (along x) or chroma column
    int inward = 1;   ///< sign of the direction to the inside
    float start = 0;  ///< position along the line where the hull crosses it
    float slope = 0;  ///< of the hull: change of the position for one luma pixel across the lines
    float margin = 0; ///< length of the hull along the line
};

/// Draws scan lines all round the convex hull of a mask, in order, clockwise on the screen: along rows where
/// the outline is steep, along columns where it is flat, so that none meets it at less than 45°. Keeps its
/// memory: no allocation once it is warm.
class ScanLines
{
public:
    /// About `most` lines, evenly spaced.
    const std::vector<ScanLine> &layAround(const RegionMask &mask, const ChromaGrid &grid, int most);
    /// The smaller of the hull's greatest lengths along rows and along columns, luma pixels.
    float narrowestPx(const ChromaGrid &grid) const;
    /// Share of the hull that the mask fills: near 1 for a convex region.
    double solidity() const { return m_solidity; }
    int stride() const { return m_stride; } ///< lines from one to the next

private:
    void findHull(const RegionMask &mask);
    void fillSpans(const RegionMask &mask);

    std::vector<Eigen::Vector2i> m_left, m_corners; ///< samples
    std::vector<float> m_spanX, m_spanY;            ///< length of the hull on each row and column, samples
    std::vector<ScanLine> m_lines;
    int m_stride = 1;
    double m_solidity = 1;
};

/// Four values, of four scan lines, in one register of the processor. Finding an edge is a long chain of
/// steps, each of which waits for the one before; four lines at once wait together.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 same(float value)
{
    return Float4{value, value, value, value};
}
inline Float4 atLeast(Float4 values, Float4 least)
{
    return values > least ? values : least;
}
inline Float4 atMost(Float4 values, Float4 most)
{
    return values < most ? values : most;
}
inline Float4 magnitudeOf(Float4 values)
{
    return reinterpret_cast<Float4>(reinterpret_cast<Int4>(values) & 0x7fffffff);
}

/// The samples of a plane along four scan lines, as running sums: the mean over any stretch of them costs
/// nothing. Positions are luma pixels along the line.
class EdgeProfiles // NOLINT(cppcoreguidelines-pro-type-member-init): each edge makes one, and sets what it
                   // reads
{
public:
    static constexpr int lines = 4, mostSamples = 24;

    /// The samples of one of the lines: at most mostSamples, as valueOf(0), valueOf(1), ... gives them, times
    /// `unit`. The first is centred at `first`; the next ones follow at `spacing`.
    template <class ValueOf>
    void set(int line, float first, float spacing, float unit, int count, ValueOf valueOf)
    {
        m_begin[line] = first - 0.5f * spacing;
        m_perSpacing[line] = 1 / spacing;
        m_last[line] = static_cast<float>(count) - 0.001f;
        m_unit[line] = spacing * unit;
        std::uint64_t *samples = m_samples[static_cast<std::size_t>(line)].data();
        std::int32_t sum = 0;
        for (int i = 0; i < count; ++i) {
            const std::int32_t value = valueOf(i);
            samples[i] = static_cast<std::uint32_t>(sum) |
                         static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)) << 32;
            sum += value;
        }
    }
    /// A line of which nothing can be seen: all alike.
    void setEmpty(int line)
    {
        m_begin[line] = m_perSpacing[line] = m_last[line] = m_unit[line] = 0;
        m_samples[static_cast<std::size_t>(line)][0] = 0;
    }

    Float4 mean(Float4 from, Float4 to) const;

    /// Sum from the start of each line up to a position on it.
    Float4 upTo(Float4 positions) const
    {
        const Float4 at = atMost(atLeast((positions - m_begin) * m_perSpacing, Float4{}), m_last);
        const Int4 i = __builtin_convertvector(at, Int4);
        const auto two = reinterpret_cast<Int4>(Long2{sampleAt(0, i[0]), sampleAt(1, i[1])}),
                   more = reinterpret_cast<Int4>(Long2{sampleAt(2, i[2]), sampleAt(3, i[3])});
        const Float4 sums = __builtin_convertvector(__builtin_shufflevector(two, more, 0, 2, 4, 6), Float4),
                     values = __builtin_convertvector(__builtin_shufflevector(two, more, 1, 3, 5, 7), Float4);
        return m_unit * (sums + (at - __builtin_convertvector(i, Float4)) * values);
    }

private:
    using Long2 = std::uint64_t __attribute__((vector_size(16)));
    std::uint64_t sampleAt(std::size_t line, int i) const
    {
        return m_samples[line][static_cast<std::size_t>(i)];
    }

    /// Of each sample the sum of those before it (low half) and its own value, read at once. Only those that
    /// were set.
    std::array<std::array<std::uint64_t, mostSamples>, lines> m_samples;
    Float4 m_begin{}, m_perSpacing{};
    Float4 m_last{}; ///< the end, but for a trifle, in samples from the begin
    Float4 m_unit{}; ///< of the sums
};

/// How to search the edges of four lines about their expected positions.
struct EdgeSearch
{
    Float4 inward = same(1);    ///< +1: the inside is at larger positions; −1: at smaller ones
    Float4 halfWidth = same(1); ///< of the stretch about the edge that must be made up of inside and outside
    float reference = 1;        ///< length of the stretches beside it that show what inside and outside are
    bool leadOn =
        false; ///< the outside changes towards the edge, as a shadow does: led on along a straight line
};

/// Moves `positions` to where the edges must be for the samples about them to be the sum of both sides: exact
/// for a step of any symmetric blur once repeated until it stays. Returns the contrasts, inside less outside;
/// where one is below the least its position stays.
Float4 moveToEdges(const EdgeProfiles &profiles, const EdgeSearch &search, float leastContrast,
                   Float4 &positions);

} // namespace odo
