// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/blob_finder.h"

#include <algorithm>

namespace odo {

Eigen::Matrix2d Blob::covariance() const
{
    const Eigen::Vector2d mean = centre();
    const double own = step * step / 12.0;
    Eigen::Matrix2d cov;
    cov(0, 0) = sumXX / count - mean.x() * mean.x() + own;
    cov(1, 1) = sumYY / count - mean.y() * mean.y() + own;
    cov(0, 1) = cov(1, 0) = sumXY / count - mean.x() * mean.y();
    return cov;
}

void RegionMask::reset(const ChromaRect &newArea)
{
    area = newArea;
    bytes.assign(static_cast<std::size_t>(area.width()) * area.height(), 0);
}

namespace {

/// Asks for a part of a plane to be brought near the processor. A decoder leaves most of a picture in far
/// memory, and a window's rows are too short for the processor to foresee: waiting for one after the other
/// costs as much as all the work on them.
void fetchEarly(const PlaneView &plane, const ChromaRect &area)
{
    constexpr int cacheLine = 64;
    for (int y = area.top; y < area.bottom; ++y) {
        const std::uint8_t *row = plane.row(y);
        for (int x = area.left; x < area.right; x += cacheLine)
            __builtin_prefetch(row + x);
        __builtin_prefetch(row + area.right - 1);
    }
}

} // namespace

void BlobFinder::find(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    if (step == 1 && !area.isEmpty()) {
        fetchEarly(grid.u, area);
        fetchEarly(grid.v, area);
    }
    m_runs.clear();
    m_parents.clear();
    m_blobs.clear();
    findRuns(grid, table, area, step);
    gatherBlobs(step);
}

int BlobFinder::rootOf(int label)
{
    while (m_parents[label] != label) {
        m_parents[label] = m_parents[m_parents[label]];
        label = m_parents[label];
    }
    return label;
}

int BlobFinder::joinWithRowAbove(const Run &run, std::size_t &above, std::size_t aboveEnd, int step)
{
    while (above < aboveEnd && m_runs[above].last < run.first - step)
        ++above;
    int label = -1;
    for (std::size_t i = above; i < aboveEnd && m_runs[i].first <= run.last + step; ++i) {
        const int root = rootOf(m_runs[i].label);
        if (label >= 0)
            m_parents[std::max(label, root)] = std::min(label, root);
        label = label < 0 ? root : std::min(label, root);
    }
    if (label < 0) {
        label = static_cast<int>(m_parents.size());
        m_parents.push_back(label);
    }
    return label;
}

void BlobFinder::findRuns(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    // One sample that noise took out does not break a run.
    const int reach = 2 * step;
    std::size_t aboveBegin = 0;
    for (int y = area.top; y < area.bottom; y += step) {
        const std::uint8_t *u = grid.u.row(y);
        const std::uint8_t *v = grid.v.row(y);
        const std::size_t rowBegin = m_runs.size();
        for (int x = area.left; x < area.right; x += step) {
            const std::uint8_t weight = table.weight(u[x], v[x]);
            if (weight < ChromaTable::threshold)
                continue;
            if (m_runs.size() > rowBegin && x - m_runs.back().last <= reach) {
                Run &run = m_runs.back();
                run.last = x;
                ++run.taken;
                run.weight += weight;
                run.sumU += u[x];
                run.sumV += v[x];
            } else {
                m_runs.push_back({y, x, x, 0, 1, weight, u[x], v[x]});
            }
        }
        const std::size_t rowEnd = m_runs.size();
        std::size_t above = aboveBegin;
        for (std::size_t i = rowBegin; i < rowEnd; ++i)
            m_runs[i].label = joinWithRowAbove(m_runs[i], above, rowBegin, step);
        aboveBegin = rowBegin;
    }
}

void BlobFinder::gatherBlobs(int step)
{
    m_blobOfLabel.assign(m_parents.size(), -1);
    for (const Run &run : m_runs) {
        const int root = rootOf(run.label);
        if (m_blobOfLabel[root] < 0) {
            m_blobOfLabel[root] = static_cast<int>(m_blobs.size());
            Blob blob;
            blob.label = root;
            blob.step = step;
            blob.box = {run.first, run.y, run.last + 1, run.y + 1};
            m_blobs.push_back(blob);
        }
        Blob &blob = m_blobs[m_blobOfLabel[root]];
        const double n = (run.last - run.first) / step + 1;
        const double mid = 0.5 * (run.first + run.last);
        blob.count += n;
        blob.sumX += n * mid;
        blob.sumY += n * run.y;
        blob.sumXX += n * mid * mid + step * step * n * (n * n - 1) / 12.0;
        blob.sumXY += n * mid * run.y;
        blob.sumYY += n * run.y * static_cast<double>(run.y);
        blob.visited += run.taken;
        blob.weight += run.weight;
        blob.sumU += run.sumU;
        blob.sumV += run.sumV;
        blob.box = {std::min(blob.box.left, run.first), blob.box.top, std::max(blob.box.right, run.last + 1),
                    run.y + 1};
    }
}

void BlobFinder::paint(const Blob &blob, int margin, RegionMask &mask) const
{
    mask.reset(blob.box.grownBy(margin));
    for (const Run &run : m_runs) {
        int label = run.label;
        while (m_parents[label] != label)
            label = m_parents[label];
        if (label == blob.label)
            std::fill_n(mask.row(run.y) + (run.first - mask.area.left), run.last - run.first + 1,
                        std::uint8_t{1});
    }
}

} // namespace odo
