// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"

#include <optional>
#include <vector>

namespace odo {

/// Where a run was at one time.
struct CoursePose
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
    double varianceM2 = 0;    ///< of both coordinates together, the calibration's part included
    double ownVarianceM2 = 0; ///< without it
    double sigmaVelocityMps = 0;
    std::optional<double> headingRad; ///< of the body, without steps of a whole turn; empty: not measured
    double sigmaHeadingRad = 0;
    std::size_t piece = 0; ///< counts on at each gap
};

/// A measured run at any time: the cubic through the smoothed points on both sides, where these were measured
/// one right after the other. The profile must outlive it.
class MeasuredCourse
{
public:
    explicit MeasuredCourse(const Profile &profile);

    bool isEmpty() const { return m_instants.empty(); }
    double firstS() const { return m_instants.front().timeS; } ///< not of an empty one
    double lastS() const { return m_instants.back().timeS; }
    double stepS() const; ///< the usual one
    std::optional<CoursePose> at(double timeS) const;
    /// Between two times at which there is a pose, metres: the distance travelled, and straight across gaps.
    double pathBetween(double fromS, double toS) const;
    const std::vector<RunInstant> &instants() const { return m_instants; }

private:
    bool isJoined(std::size_t i) const; ///< to the instant before it
    double travelledAt(double timeS) const;

    std::vector<RunInstant> m_instants; ///< the measured ones
    std::vector<double> m_travelledM;
    std::vector<std::size_t> m_pieces;
};

} // namespace odo
