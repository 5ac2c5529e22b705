// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace odo {

namespace {

/// The mask takes what is robot to some two fifths: the edge lies so much (of a sample) beyond its samples.
constexpr float beyondMask = 0.3f;

int turnOf(const Eigen::Vector2i &a, const Eigen::Vector2i &b, const Eigen::Vector2i &c)
{
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
}

/// Adds a corner to a chain that may turn one way only (Andrew 1979, for points already in order).
void extendChain(std::vector<Eigen::Vector2i> &chain, const Eigen::Vector2i &corner, int side)
{
    while (chain.size() >= 2 && side * turnOf(chain[chain.size() - 2], chain.back(), corner) <= 0)
        chain.pop_back();
    chain.push_back(corner);
}

} // namespace

void ScanLines::findHull(const RegionMask &mask)
{
    m_left.clear();
    m_corners.clear();
    const int width = mask.area.width();
    int filled = 0;
    for (int y = mask.area.top; y < mask.area.bottom; ++y) {
        const std::uint8_t *row = mask.row(y);
        const auto *first =
            static_cast<const std::uint8_t *>(std::memchr(row, 1, static_cast<std::size_t>(width)));
        if (!first)
            continue;
        int last = width - 1;
        while (!row[last])
            --last;
        filled += static_cast<int>(std::count(first, row + last + 1, std::uint8_t{1}));
        extendChain(m_corners, {mask.area.left + last, y}, 1);
        extendChain(m_left, {mask.area.left + static_cast<int>(first - row), y}, -1);
    }
    m_corners.insert(m_corners.end(), m_left.rbegin(), m_left.rend());
    // By Pick's theorem, whose points are the samples.
    int twice = 0, rim = 0;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const Eigen::Vector2i &a = m_corners[i], &b = m_corners[(i + 1) % m_corners.size()];
        twice += a.x() * b.y() - a.y() * b.x();
        rim += std::gcd(a.x() - b.x(), a.y() - b.y());
    }
    m_solidity = 2.0 * filled / (std::abs(twice) + rim + 2);
}

void ScanLines::fillSpans(const RegionMask &mask)
{
    m_spanX.assign(static_cast<std::size_t>(mask.area.height()), 0.0f);
    m_spanY.assign(static_cast<std::size_t>(mask.area.width()), 0.0f);
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const Eigen::Vector2i a = m_corners[i], b = m_corners[(i + 1) % m_corners.size()], d = b - a;
        if (d.y() != 0) {
            const float sign = d.y() > 0 ? 1.0f : -1.0f,
                        slope = static_cast<float>(d.x()) / static_cast<float>(d.y());
            for (int y = std::min(a.y(), b.y()); y < std::max(a.y(), b.y()); ++y)
                m_spanX[static_cast<std::size_t>(y - mask.area.top)] +=
                    sign * (static_cast<float>(a.x()) + static_cast<float>(y - a.y()) * slope);
        }
        if (d.x() != 0) {
            const float sign = d.x() < 0 ? 1.0f : -1.0f,
                        slope = static_cast<float>(d.y()) / static_cast<float>(d.x());
            for (int x = std::min(a.x(), b.x()); x < std::max(a.x(), b.x()); ++x)
                m_spanY[static_cast<std::size_t>(x - mask.area.left)] +=
                    sign * (static_cast<float>(a.y()) + static_cast<float>(x - a.x()) * slope);
        }
    }
}

float ScanLines::narrowestPx(const ChromaGrid &grid) const
{
    if (m_spanX.empty() || m_spanY.empty())
        return 0;
    return std::min(static_cast<float>(grid.scale.x()) * *std::max_element(m_spanX.begin(), m_spanX.end()),
                    static_cast<float>(grid.scale.y()) * *std::max_element(m_spanY.begin(), m_spanY.end()));
}

const std::vector<ScanLine> &ScanLines::layAround(const RegionMask &mask, const ChromaGrid &grid, int most)
{
    findHull(mask);
    fillSpans(mask);
    m_lines.clear();
    const auto sx = static_cast<float>(grid.scale.x()), sy = static_cast<float>(grid.scale.y());
    const auto edge = [this](std::size_t i) -> Eigen::Vector2i {
        return m_corners[(i + 1) % m_corners.size()] - m_corners[i];
    };
    const auto isSteep = [sx, sy](const Eigen::Vector2i &d) {
        return static_cast<float>(std::abs(d.y())) * sy >= static_cast<float>(std::abs(d.x())) * sx;
    };
    int all = 0;
    for (std::size_t i = 0; i < m_corners.size(); ++i)
        all += isSteep(edge(i)) ? std::abs(edge(i).y()) : std::abs(edge(i).x());
    m_stride = std::max(1, (all + most - 1) / most);
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const Eigen::Vector2i &a = m_corners[i], d = edge(i);
        ScanLine scan;
        scan.alongX = isSteep(d);
        const int count = std::abs(scan.alongX ? d.y() : d.x());
        if (count == 0)
            continue;
        const int forward = (scan.alongX ? d.y() : d.x()) > 0 ? 1 : -1;
        scan.inward = scan.alongX ? -forward : forward;
        const float s = scan.alongX ? sx : sy,
                    perLine = scan.alongX ? static_cast<float>(d.x()) / static_cast<float>(d.y())
                                          : static_cast<float>(d.y()) / static_cast<float>(d.x());
        scan.slope = perLine * s / (scan.alongX ? sy : sx);
        const auto offset = static_cast<float>(scan.alongX ? grid.offset.x() : grid.offset.y());
        for (int k = 0; k <= count; ++k) {
            scan.line = (scan.alongX ? a.y() : a.x()) + forward * k;
            if (m_stride > 1 && scan.line % m_stride != 0)
                continue;
            if (!m_lines.empty() && m_lines.back().line == scan.line &&
                m_lines.back().alongX == scan.alongX && m_lines.back().inward == scan.inward)
                continue;
            const float at =
                static_cast<float>(scan.alongX ? a.x() : a.y()) + perLine * static_cast<float>(forward * k);
            scan.start = at * s + offset - beyondMask * s * static_cast<float>(scan.inward);
            scan.margin = s * (scan.alongX ? m_spanX[static_cast<std::size_t>(scan.line - mask.area.top)]
                                           : m_spanY[static_cast<std::size_t>(scan.line - mask.area.left)]);
            m_lines.push_back(scan);
        }
    }
    return m_lines;
}

// Not inline: between two frames the decoder drives this code out of the processor's cache, and one copy of
// it is sooner back than one for each use.

Float4 EdgeProfiles::mean(Float4 from, Float4 to) const
{
    return (upTo(to) - upTo(from)) / (to - from);
}

Float4 moveToEdges(const EdgeProfiles &profiles, const EdgeSearch &search, float leastContrast,
                   Float4 &positions)
{
    const Float4 h = search.halfWidth, d = search.inward, perR = d / search.reference;
    const Float4 toEnd = d * h, toOuter = d * (h + search.reference);
    // Sums up to the ends of the stretches, from the inside outwards.
    const Float4 inner = profiles.upTo(positions + toOuter), innerEnd = profiles.upTo(positions + toEnd),
                 outerEnd = profiles.upTo(positions - toEnd), outer = profiles.upTo(positions - toOuter);
    const Float4 in = perR * (inner - innerEnd);
    Float4 out = perR * (outerEnd - outer);
    if (search.leadOn) {
        const Float4 farther = perR * (outer - profiles.upTo(positions - toOuter - d * search.reference));
        out += (out - farther) * (0.5f + 0.5f * h / search.reference);
    }
    const Float4 contrasts = in - out;
    const Float4 across = d * (innerEnd - outerEnd) / (2 * h);
    const Float4 inside = atMost(atLeast((across - out) / contrasts, Float4{}), same(1));
    positions = magnitudeOf(contrasts) < leastContrast ? positions : positions + toEnd * (1 - 2 * inside);
    return contrasts;
}

} // namespace odo
