// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/floor_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

constexpr double marginM = 0.2;
constexpr int cellsAcross = 160, leastCellPx = 4, sampleEach = 2;
constexpr float leastDifference = 3, deviations = 6, madToSigma = 1.4826F;
constexpr float darkest = 8; // below it the ratio of two frames says nothing of the light
constexpr std::size_t leastChanged = 3, leastCells = 20;
constexpr Nanoseconds longestStep = std::chrono::seconds(1); // beyond it nobody looked meanwhile

float medianOf(std::vector<float> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// By which factor the light of all cells has changed.
float gainBetween(const std::vector<float> &now, const std::vector<float> &before)
{
    std::vector<float> ratios;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (before[i] > darkest)
            ratios.push_back(now[i] / before[i]);
    }
    return ratios.empty() ? 1 : medianOf(std::move(ratios));
}

} // namespace

FloorArea watchedArea(const MarkerLayout &layout)
{
    FloorArea area;
    for (const Marker &marker : layout.markers)
        area.extend(marker.pointInWorld);
    if (area.isEmpty())
        return area;
    const Eigen::Vector2d margin(marginM, marginM);
    return {area.min() - margin, area.max() + margin};
}

FloorMotion::FloorMotion(FloorView view, FloorArea area) : m_view(std::move(view))
{
    const Intrinsics &intrinsics = m_view.camera().intrinsics();
    m_cellPx = std::max(leastCellPx, intrinsics.widthPx / cellsAcross);
    m_columns = intrinsics.widthPx / m_cellPx;
    m_rows = intrinsics.heightPx / m_cellPx;
    const double middle = (m_cellPx - 1) / 2.0; // pixel (0, 0) is the centre of the first one
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < m_columns; ++column) {
            const int x0 = column * m_cellPx, y0 = row * m_cellPx;
            const auto point = m_view.floorFromPixel({x0 + middle, y0 + middle}, 0);
            if (point && area.contains(*point))
                m_cells.push_back({x0, y0, row * m_columns + column});
        }
    }
}

std::vector<float> FloorMotion::meansOf(const PlaneView &luma) const
{
    std::vector<float> means;
    means.reserve(m_cells.size());
    const int across = (m_cellPx + sampleEach - 1) / sampleEach;
    for (const Cell &cell : m_cells) {
        int sum = 0;
        for (int y = cell.y0; y < cell.y0 + m_cellPx; y += sampleEach) {
            const std::uint8_t *row = luma.row(y) + cell.x0;
            for (int x = 0; x < m_cellPx; x += sampleEach)
                sum += row[x];
        }
        means.push_back(static_cast<float>(sum) / static_cast<float>(across * across));
    }
    return means;
}

/// Of the changed cells, those beside another one; in the grid of all cells.
std::size_t FloorMotion::changedWithNeighbours(const std::vector<std::uint8_t> &changed) const
{
    std::size_t count = 0;
    for (const Cell &cell : m_cells) {
        if (!changed[static_cast<std::size_t>(cell.index)])
            continue;
        const int column = cell.index % m_columns, row = cell.index / m_columns;
        int neighbours = -1; // itself
        for (int y = std::max(0, row - 1); y <= std::min(m_rows - 1, row + 1); ++y) {
            for (int x = std::max(0, column - 1); x <= std::min(m_columns - 1, column + 1); ++x)
                neighbours += changed[static_cast<std::size_t>(y * m_columns + x)];
        }
        count += neighbours > 0 ? 1 : 0;
    }
    return count;
}

std::optional<bool> FloorMotion::differs(const std::vector<float> &now,
                                         const std::vector<float> &before) const
{
    const float gain = gainBetween(now, before);
    std::vector<float> differences;
    differences.reserve(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
        differences.push_back(std::abs(now[i] - gain * before[i]));
    const float least = std::max(leastDifference, deviations * madToSigma * medianOf(differences));
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    std::size_t all = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (differences[i] <= least)
            continue;
        changed[static_cast<std::size_t>(m_cells[i].index)] = 1;
        ++all;
    }
    if (2 * all > now.size())
        return std::nullopt;
    return all >= leastChanged && changedWithNeighbours(changed) >= leastChanged;
}

std::optional<MotionSight> FloorMotion::add(const Frame &frame, Nanoseconds taken)
{
    const Intrinsics &intrinsics = m_view.camera().intrinsics();
    if (frame.format.width != intrinsics.widthPx || frame.format.height != intrinsics.heightPx ||
        m_cells.size() < leastCells)
        return std::nullopt;
    const auto whole = wholeFrame(frame);
    if (!whole)
        return std::nullopt;
    m_past.push_back({taken, meansOf(whole->y)});
    while (m_past.size() > 1 && m_past[1].taken <= taken - lag)
        m_past.pop_front();
    if (m_past.front().taken > taken - lag || m_past.front().taken < taken - longestStep)
        return std::nullopt;
    const auto now = differs(m_past.back().means, m_past.front().means);
    if (!now)
        return std::nullopt;
    const bool before = std::exchange(m_differed, *now);
    return MotionSight{taken, *now && before};
}

} // namespace odo
