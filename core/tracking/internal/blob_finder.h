// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/bit_mask.h"
#include "core/tracking/internal/chroma_density.h"
#include "core/tracking/observation.h"

#include <memory>
#include <utility>
#include <vector>

namespace odo {

/// A connected region of samples that the table takes as the robot's. All in chroma samples.
struct Blob
{
    double count = 0; ///< of visited samples; times step² it is the area
    double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0, sumYY = 0;
    double visited = 0;        ///< count without the samples of a run that are missing because of noise
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
    /// Samples of the planes outside of which there are no regions; null: none.
    void searchOnly(std::shared_ptr<const BitMask> searched) { m_searched = std::move(searched); }
    /// Visits each step-th sample of each step-th row of the area, which must lie in the planes.
    void find(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step);
    const std::vector<Blob> &blobs() const { return m_blobs; }
    /// Marks the samples of one blob of the last find() with step 1; the mask covers the blob's box grown by
    /// a margin, not clipped to the frame.
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
    void findSearchedRunsInRow(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area,
                               int y, int step);
    void findRuns(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step);
    void gatherBlobs(int step);

    std::shared_ptr<const BitMask> m_searched;
    std::vector<Run> m_runs;
    std::vector<int> m_parents;
    std::vector<int> m_blobOfLabel;
    std::vector<Blob> m_blobs;
};

/// A region at sub-pixel precision, in chroma samples.
struct RegionShape
{
    double area = 0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity(); ///< second central moments of the area
    Eigen::Matrix2d centreCovariance =
        Eigen::Matrix2d::Zero();    ///< of the centre, from the noise of the samples
    Chroma colour = Chroma::Zero(); ///< mean of the samples that are wholly inside
    double noise = 0;               ///< standard deviation of a sample's chroma, along one axis
};

/// Weighs each sample along a region's edge by the part of it that the robot covers, and takes the moments.
///
/// The part is found from the edge itself: alpha = (c − b)·(f − b)/|f − b|², where f is the chroma of the
/// nearest samples that are wholly inside and b that of the nearest wholly outside, along the normal of the
/// region's ellipse. So neither a second, darker side of the robot nor a background of several colours biases
/// it (references from the whole region do: 0.1 px and more). Alpha is stretched from 0.1..0.9 to 0..1, which
/// removes noise on both sides of the edge; a stronger stretch costs sub-pixel precision where the edge is
/// sharp. Samples wholly inside count one. Keeps its memory: no allocation once it is warm.
class RegionMeasure
{
public:
    static constexpr int margin = 4; ///< that the mask must have around the blob
    /// Samples around the blob's box that are read: edge samples are up to 2 outside of it, and their
    /// reference up to 7 from there.
    static constexpr int reach = 10;

    /// Colour and noise only, with the moments of the mask's samples, which are right to a sample: half of
    /// the work, for a region whose outline is fitted otherwise. The mask must have been painted from the
    /// blob. `expected` is used if the region is too small to have a sample that is wholly inside.
    RegionShape examine(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                        const Chroma &expected);
    /// All of it.
    RegionShape measure(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                        const Chroma &expected);

    /// 2 for a sample of the last measured region that has only such around it, 1 for one near its edge, else
    /// 0.
    int classAt(int x, int y) const { return m_area.contains(x, y) ? rowOfClasses(y)[x] : 0; }

private:
    struct Sums;
    struct EdgeReference
    {
        float u = 0, v = 0; ///< code values
    };
    void classify(const RegionMask &mask);
    /// To be indexed by the sample's own x.
    const std::uint8_t *rowOfClasses(int y) const
    {
        return m_classes.data() + static_cast<std::ptrdiff_t>(y - m_area.top) * m_area.width() - m_area.left;
    }
    void readColour(const ChromaGrid &grid, const Blob &blob, const Chroma &expected,
                    RegionShape &shape) const;
    void addInside(const ChromaGrid &grid, const Blob &blob, Sums &sums) const;
    bool findReference(const ChromaGrid &grid, int x, int y, int stepX, int stepY, int wanted,
                       EdgeReference &reference) const;
    static bool isBackground(float du, float dv, const EdgeReference &in, const EdgeReference &out);
    void addEdge(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask, const RegionShape &shape,
                 Sums &sums) const;

    ChromaRect m_area;
    std::vector<std::uint8_t> m_classes;
};

/// The ellipse in luma pixels that has the second moments of the shape.
Ellipse ellipseOf(const RegionShape &shape, const ChromaGrid &grid);

} // namespace odo
