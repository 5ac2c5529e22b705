// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/blob_finder.h"

#include "core/tracking/internal/fetch_early.h"

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

void BlobFinder::find(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    if (step == 1 && !area.isEmpty()) {
        const PixelRect samples{area.left, area.top, area.right, area.bottom};
        fetchEarly(grid.u, samples);
        fetchEarly(grid.v, samples);
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

/// The runs of one row. One sample that noise took out does not break a run.
void BlobFinder::findRunsInRow(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area,
                               int y, int step)
{
    const std::uint8_t *u = grid.u.row(y), *v = grid.v.row(y);
    const int reach = 2 * step;
    // Blocks without the robot's colour are passed over, as long as that keeps to the lattice of the step.
    const int block = ChromaTable::blockSamples % step == 0 ? ChromaTable::blockSamples : area.width();
    for (int x = area.left; x < area.right;) {
        const int end = std::min(x + block, area.right);
        if (end - x == ChromaTable::blockSamples && !table.mayTakeBlock(u + x, v + x)) {
            x = end;
            continue;
        }
        while (x < end && table.weight(u[x], v[x]) < ChromaTable::threshold)
            x += step;
        if (x >= end)
            continue;
        Run run{y, x, x, 0, 0, 0, 0, 0};
        for (; x < area.right && x - run.last <= reach; x += step) {
            const std::uint8_t weight = table.weight(u[x], v[x]);
            if (weight < ChromaTable::threshold)
                continue;
            run.last = x;
            ++run.taken;
            run.weight += weight;
            run.sumU += u[x];
            run.sumV += v[x];
        }
        m_runs.push_back(run);
    }
}

void BlobFinder::findRuns(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    std::size_t aboveBegin = 0;
    for (int y = area.top; y < area.bottom; y += step) {
        const std::size_t rowBegin = m_runs.size();
        findRunsInRow(grid, table, area, y, step);
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
        const int pixels = (run.last - run.first) / step + 1;
        const double n = pixels;
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
