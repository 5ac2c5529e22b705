// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/edge_finder.h"

#include <vector>

namespace odo {

/// Tells from the edges of a robot whether the chroma's samples lie elsewhere than the stream says: then its
/// edges keep away from the luma's, everywhere in the same direction. A siting is wrong by half a pixel or
/// not at all; less is shading. Learns from the first hundred outlines.
class SitingCheck
{
public:
    /// What all outlines up to this one say is put right in this one's edges already.
    void learn(const std::vector<ScanLine> &lines, std::vector<LineEdge> &edges);
    /// By how much the chroma planes must be shifted to lie on the luma plane: luma pixels.
    const Eigen::Vector2d &lagPx() const { return m_lag; }

private:
    /// Normal equations: lag = normal⁻¹ · right.
    Eigen::Matrix2d m_normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d m_right = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_lag = Eigen::Vector2d::Zero();
    int m_outlines = 0;
};

} // namespace odo
