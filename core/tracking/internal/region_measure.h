// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/observation.h"

namespace odo {

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
/// takes out noise on both sides of the edge; a stronger stretch costs sub-pixel precision where the edge is
/// sharp. Samples wholly inside count one. Keeps its memory: no allocation once it is warm.
class RegionMeasure
{
public:
    static constexpr int margin = 4; ///< that the mask must have around the blob
    /// Samples around the blob's box that are looked at: edge samples lie up to 2 outside of it, and their
    /// reference up to 7 from there.
    static constexpr int reach = 10;

    /// Colour and noise only, with the moments of the mask's samples, which are right to a sample: half of
    /// the work, for a region whose outline is fitted otherwise. The mask must have been painted from the
    /// blob. `expected` stands in where the region is too small to have a sample that is wholly inside.
    RegionShape look(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
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
