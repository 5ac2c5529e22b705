// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/blob_finder.h"

#include <vector>

namespace odo {

/// A line of samples across the outline, along a row or a column of the chroma plane and the luma rows or
/// columns that it stands for. Lengths in luma pixels.
struct ScanLine
{
    bool alongX = false;
    int line = 0;    ///< chroma row (along x) or chroma column
    int inward = 1;  ///< sign of the direction to the inside
    float start = 0; ///< place along the line where the hull crosses it
    float slope = 0; ///< of the hull: change of the place for one luma pixel across the lines
    float room = 0;  ///< length of the hull along the line
};

/// Lays scan lines all round the convex hull of a mask, in order, clockwise on the screen: along rows where
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

} // namespace odo
