// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/outline_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr int enoughOutlines = 100;
constexpr double sitingStep = 0.5, mostSitingLag = 1; ///< luma pixels

/// By how much a lag of the chroma plane moves the chroma's edge along a line.
Eigen::Vector2d alongLine(const ScanLine &line)
{
    const auto slope = static_cast<double>(line.slope);
    return {line.alongX ? 1 : -slope, line.alongX ? -slope : 1};
}

} // namespace

void SitingCheck::learn(const std::vector<ScanLine> &lines, std::vector<LineEdge> &edges)
{
    if (m_outlines >= enoughOutlines)
        return;
    ++m_outlines;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!edges[i].good || !edges[i].byLuma)
            continue;
        const Eigen::Vector2d row = alongLine(lines[i]);
        m_normal += row * row.transpose();
        m_right += row * (static_cast<double>(edges[i].lag) + row.dot(m_lag));
    }
    if (!(m_normal.determinant() > 1))
        return;
    const Eigen::Vector2d mean = m_normal.inverse() * m_right, before = m_lag;
    for (int axis = 0; axis < 2; ++axis)
        m_lag[axis] =
            std::clamp(sitingStep * std::round(mean[axis] / sitingStep), -mostSitingLag, mostSitingLag);
    if (m_lag == before)
        return;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto more = static_cast<float>(alongLine(lines[i]).dot(m_lag - before));
        if (!edges[i].byLuma)
            edges[i].outward -= more * static_cast<float>(lines[i].inward);
    }
}

namespace {

constexpr int mostLines = 160, leastLines = 16;
constexpr float leastWidth = 13; ///< luma pixels: of a smaller region the two sides disturb one another
constexpr float leastShareOfLines = 0.4f;       ///< of lines that found an edge
constexpr float stray = 2.5f;                   ///< of an edge from the median of its neighbours
constexpr int reach = 3;                        ///< lines on both sides that are a line's neighbours
constexpr int least = 6;                        ///< scatters needed for a variance
constexpr double unknownVariance = 0.15 * 0.15; ///< of an edge, if there are too few
constexpr double outlineModelVariance = 0.01 * 0.01;

/// A polygon through points of a smooth curve cuts off a little of it at each chord: moved outwards by a
/// twelfth of the second difference its corners enclose the curve's own area (to the fourth order of the
/// pitch).
void roundOut(std::vector<Eigen::Vector2d> &points)
{
    Eigen::Vector2d before = points.back();
    const Eigen::Vector2d first = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d here = points[i], after = i + 1 < points.size() ? points[i + 1] : first;
        points[i] = here - (before - 2 * here + after) / 12;
        before = here;
    }
}

/// A ring as a row that goes on by `beyond` at both ends, so that a window needs no wrapping.
template <class Value, class ValueOf>
void unroll(std::size_t count, int beyond, std::vector<Value> &row, ValueOf valueOf)
{
    const auto more = static_cast<std::size_t>(beyond);
    row.resize(count + 2 * more);
    for (std::size_t i = 0; i < count; ++i)
        row[i + more] = valueOf(i);
    std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(count), more, row.begin());
    std::copy_n(row.begin() + beyond, more, row.begin() + static_cast<std::ptrdiff_t>(count + more));
}

/// Of each value about an unrolled ring the most within reach.
void mostNear(const std::vector<float> &row, std::vector<float> &most)
{
    const std::size_t count = row.size() - 2 * reach;
    most.resize(count);
    const float *values = row.data();
    for (std::size_t i = 0; i < count; ++i) {
        float best = values[i];
        for (int k = 1; k <= 2 * reach; ++k)
            best = best > values[i + static_cast<std::size_t>(k)] ? best
                                                                  : values[i + static_cast<std::size_t>(k)];
        most[i] = best;
    }
}

/// Of values that are not below 0, to a part in a thousand: by halving the range, since to look at all of
/// them a few times costs less than to put them in order.
float medianOf(const std::vector<float> &values)
{
    const auto below = [&values](float limit) {
        int count = 0;
        for (const float value : values)
            count += value < limit;
        return count;
    };
    const int half = static_cast<int>(values.size() / 2);
    constexpr float farthest = 1e6f;
    float low = 0, high = 1;
    while (high < farthest && below(high) <= half)
        high *= 4;
    for (int i = 0; i < 10; ++i) {
        const float middle = 0.5f * (low + high);
        (below(middle) <= half ? low : high) = middle;
    }
    return 0.5f * (low + high);
}

} // namespace

void OutlineFit::putOutliersAside()
{
    constexpr float none = -std::numeric_limits<float>::max();
    const int n = static_cast<int>(m_edges.size());
    unroll(m_edges.size(), reach, m_outwards,
           [this](std::size_t i) { return m_edges[i].good ? m_edges[i].outward : none; });
    unroll(m_edges.size(), reach, m_inwards,
           [this](std::size_t i) { return m_edges[i].good ? -m_edges[i].outward : none; });
    mostNear(m_outwards, m_most);
    mostNear(m_inwards, m_least);
    for (int i = 0; i < n; ++i) {
        const auto own = static_cast<std::size_t>(i);
        // No edge strays from the median of such as lie closer together, whatever it is.
        if (!m_edges[own].good || m_most[own] + m_least[own] < stray)
            continue;
        std::array<float, 2 * reach + 1> around{};
        int count = 0;
        for (int k = 0; k <= 2 * reach; ++k) {
            const float outward = m_outwards[own + static_cast<std::size_t>(k)];
            if (outward != none)
                around[static_cast<std::size_t>(count++)] = outward;
        }
        const auto middle = around.begin() + count / 2;
        std::nth_element(around.begin(), middle, around.begin() + count);
        m_edges[own].good = std::abs(m_edges[own].outward - *middle) < stray;
    }
}

/// Where no edge was found the outline follows the hull, shifted as the nearest edges are.
void OutlineFit::fillGaps()
{
    const std::size_t n = m_edges.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (m_edges[i].good)
            continue;
        std::size_t before = 1, after = 1;
        while (!m_edges[(i + n - before) % n].good)
            ++before;
        while (!m_edges[(i + after) % n].good)
            ++after;
        const float part = static_cast<float>(before) / static_cast<float>(before + after);
        m_edges[i].outward =
            (1 - part) * m_edges[(i + n - before) % n].outward + part * m_edges[(i + after) % n].outward;
    }
}

/// Median of the residuals of the positions from a cubic through their neighbours, which are so many steps
/// away, so that neither slope nor curvature counts. Below 0 when there are too few.
float OutlineFit::scatter(const std::vector<float> &positions, const std::vector<std::int8_t> &sides,
                          int step, std::vector<float> &leftOver)
{
    constexpr std::size_t beyond = 4;
    const std::size_t n = positions.size() - 2 * beyond, one = static_cast<std::size_t>(step), two = 2 * one;
    leftOver.resize(n);
    std::size_t count = 0;
    for (std::size_t i = beyond; i < n + beyond; ++i) {
        const float left = positions[i] - (positions[i - one] + positions[i + one]) * (4.0f / 6) +
                           (positions[i - two] + positions[i + two]) * (1.0f / 6);
        const std::int8_t side = sides[i];
        const bool alike = side >= 0 && sides[i - one] == side && sides[i + one] == side &&
                           sides[i - two] == side && sides[i + two] == side;
        leftOver[count] = std::abs(left);
        count += alike;
    }
    leftOver.resize(count);
    return count < least ? -1 : medianOf(leftOver);
}

/// Variance of one line's edge, for lines assumed independent.
double OutlineFit::varianceOfEdges(const std::vector<ScanLine> &lines)
{
    constexpr int beyond = 4;
    unroll(lines.size(), beyond, m_positions, [&](std::size_t i) {
        return lines[i].start - static_cast<float>(lines[i].inward) * m_edges[i].outward;
    });
    unroll(lines.size(), beyond, m_sides, [&](std::size_t i) {
        const int side = 2 * lines[i].alongX + (lines[i].inward > 0);
        return static_cast<std::int8_t>(m_edges[i].good ? side : -1);
    });
    const float near = scatter(m_positions, m_sides, 1, m_leftOver),
                far = scatter(m_positions, m_sides, 2, m_leftOver);
    if (near < 0 || far < 0)
        return unknownVariance;
    // A median is 0.6745 standard deviations; the weights' squares sum to 70/36.
    constexpr double toVariance = 36.0 / (0.6745 * 0.6745 * 70);
    const double nearSquared = std::pow(near, 2), farSquared = std::pow(far, 2);
    return toVariance * nearSquared * std::clamp(farSquared / std::max(nearSquared, 1e-6), 1.0, 4.0);
}

void OutlineFit::gather(const ChromaGrid &grid, const std::vector<ScanLine> &lines, Outline &outline)
{
    outline.points.resize(lines.size());
    outline.found.resize(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const ScanLine &line = lines[i];
        const double perLine = line.alongX ? grid.scale.y() : grid.scale.x();
        const double across = line.line * perLine + 0.5 * (perLine - 1);
        const auto along =
            static_cast<double>(line.start - static_cast<float>(line.inward) * m_edges[i].outward);
        outline.points[i] = {line.alongX ? along : across, line.alongX ? across : along};
        outline.found[i] = m_edges[i].good;
    }
    roundOut(outline.points);
    outline.moments = polygonMoments(outline.points);
    // An edge that moves by δ sweeps the area δ · pitch, which draws the centre towards it.
    outline.centreCovariance.setZero();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double pitch = lines[i].alongX ? grid.scale.y() : grid.scale.x();
        const Eigen::Vector2d draw = (outline.points[i] - outline.moments.centrePx) * pitch;
        outline.centreCovariance += draw * draw.transpose();
    }
    const double swept = m_scanLines.stride() / outline.moments.areaPx2;
    outline.centreCovariance *= varianceOfEdges(lines) * swept * swept;
    outline.centreCovariance.diagonal().array() += outlineModelVariance;
}

bool OutlineFit::fit(const Frame &frame, const ChromaGrid &grid, const RegionMask &mask,
                     const OutlineHint &hint, Outline &outline)
{
    const std::vector<ScanLine> &lines = m_scanLines.layAround(mask, grid, mostLines);
    outline.goodShare = 0;
    outline.solidity = m_scanLines.solidity();
    if (m_scanLines.narrowestPx(grid) < leastWidth)
        return false;
    if (static_cast<int>(lines.size()) < leastLines)
        return false;
    m_finder.begin(frame, grid, hint, m_siting.lagPx());
    m_edges.resize(lines.size());
    for (std::size_t i = 0; i < lines.size(); i += EdgeProfiles::lines)
        m_finder.find(&lines[i],
                      static_cast<int>(std::min<std::size_t>(lines.size() - i, EdgeProfiles::lines)),
                      &m_edges[i]);
    putOutliersAside();
    m_siting.learn(lines, m_edges);
    const auto good =
        std::count_if(m_edges.begin(), m_edges.end(), [](const LineEdge &edge) { return edge.good; });
    outline.goodShare = static_cast<double>(good) / static_cast<double>(lines.size());
    if (good < leastLines || outline.goodShare < static_cast<double>(leastShareOfLines))
        return false;
    m_finder.learnSharpness();
    fillGaps();
    gather(grid, lines, outline);
    return outline.moments.areaPx2 > 0;
}

} // namespace odo
