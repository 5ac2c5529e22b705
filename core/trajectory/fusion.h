// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/trajectory/floor_positions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace odo {

/// One view's word on where the robot is.
struct ViewPosition
{
    std::uint32_t view = 0; ///< index of the view
    FloorPosition place;
};

/// The part of single frames and the part of the calibration together, m².
Eigen::Matrix2d totalCovariance(const FloorPosition &place);

/// Several views' word, joined.
struct FusedPosition
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();       ///< frame to frame, m²
    Eigen::Matrix2d commonCovariance = Eigen::Matrix2d::Zero(); ///< of the views' calibrations, m²
    Eigen::Vector2d displacementPerMetreHeight = Eigen::Vector2d::Zero();
    std::uint32_t views = 0; ///< bit i: view i
};

/// Minimum-variance fusion on the plane (Sankaranarayanan and Chellappa 2008, eq. 9): x = (ΣΣᵢ⁻¹)⁻¹ ΣΣᵢ⁻¹xᵢ
/// with Σᵢ the pixel and calibration parts together; the two parts are then carried through the same weights
/// apart, because only the pixel part averages out over frames. The calibrations of different views count as
/// independent. positions must not be empty.
FusedPosition fuse(std::span<const ViewPosition> positions);

/// Largest distance between two of the positions, metres; 0 for one.
double largestDistance(std::span<const ViewPosition> positions);

/// Decides whether views contradict one another, measured against how well they agree in the whole run: a
/// steady disagreement is the calibration's, a sudden one a false sighting.
class AgreementGate
{
public:
    /// views: sightings of each view at the same times, on the plane used.
    explicit AgreementGate(const std::vector<std::vector<Sighting>> &views);

    /// χ²(2) 99.9 % of the difference.
    bool agree(const ViewPosition &a, const ViewPosition &b) const;
    /// The largest group of views that all agree with one another; of equal groups the one with the smaller
    /// variance. One position: itself.
    std::vector<ViewPosition> largestAgreeingGroup(std::span<const ViewPosition> positions) const;

private:
    double m_scale = 1; ///< on the variance
};

} // namespace odo
