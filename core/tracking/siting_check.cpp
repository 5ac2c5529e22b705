// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/siting_check.h"

#include <Eigen/LU>
#include <cmath>

namespace odo {

namespace {

constexpr int enoughOutlines = 100;
constexpr double leastLag = 0.25, wrongSiting = 0.5; ///< luma pixels

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
        m_lag[axis] = std::abs(mean[axis]) > leastLag ? std::copysign(wrongSiting, mean[axis]) : 0.0;
    if (m_lag == before)
        return;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto more = static_cast<float>(alongLine(lines[i]).dot(m_lag - before));
        if (!edges[i].byLuma)
            edges[i].outward -= more * static_cast<float>(lines[i].inward);
    }
}

} // namespace odo
