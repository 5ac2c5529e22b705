// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/chroma_density.h"

#include <vector>

namespace odo {

/// A connected region of samples that the table takes as the robot's. All in chroma samples.
struct Blob
{
    double count = 0; ///< of visited samples; times step² it is the area
    double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0, sumYY = 0;
    double visited = 0;        ///< count without the samples that noise took out of a run
    double weight = 0;         ///< sum of the table's weights, each 0 to 255
    double sumU = 0, sumV = 0; ///< of the code values
    ChromaRect box;
    int label = 0;
    int step = 1;

    double area() const { return count * step * step; }
    Eigen::Vector2d centre() const { return {sumX / count, sumY / count}; }
    /// Second central moments, with those of each sample's own square.
    Eigen::Matrix2d covariance() const;
    double meanWeight() const { return weight / (255.0 * visited); }
    Chroma meanChroma() const { return {sumU / visited - 128.0, sumV / visited - 128.0}; }
};

/// Marks which samples of a rectangle belong to a region. The memory is kept from use to use.
struct RegionMask
{
    ChromaRect area;
    std::vector<std::uint8_t> bytes; ///< row by row, 1 inside, 0 outside

    void reset(const ChromaRect &newArea);
    std::uint8_t *row(int y)
    {
        return bytes.data() + static_cast<std::ptrdiff_t>(y - area.top) * area.width();
    }
    const std::uint8_t *row(int y) const
    {
        return bytes.data() + static_cast<std::ptrdiff_t>(y - area.top) * area.width();
    }
    bool at(int x, int y) const { return area.contains(x, y) && row(y)[x - area.left] != 0; }
};

/// Finds the connected regions (8 neighbours) of a robot's colour in a part of a frame, by runs and
/// union-find: a window with step 1, the whole frame with a coarser one. Keeps its memory: no allocation once
/// it is warm.
class BlobFinder
{
public:
    /// Visits each step-th sample of each step-th row of the area, which must lie in the planes.
    void find(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step);
    const std::vector<Blob> &blobs() const { return m_blobs; }
    /// Marks the samples of one blob of the last find() with step 1; the mask covers the blob's box grown by
    /// a margin, not clipped to the picture.
    void paint(const Blob &blob, int margin, RegionMask &mask) const;

private:
    struct Run
    {
        int y, first, last, label;     ///< samples first to last, both inside
        int taken, weight, sumU, sumV; ///< number of samples that passed, and their sums
    };
    int rootOf(int label);
    int joinWithRowAbove(const Run &run, std::size_t &above, std::size_t aboveEnd, int step);
    void findRunsInRow(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int y,
                       int step);
    void findRuns(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step);
    void gatherBlobs(int step);

    std::vector<Run> m_runs;
    std::vector<int> m_parents;
    std::vector<int> m_blobOfLabel;
    std::vector<Blob> m_blobs;
};

} // namespace odo
