// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace odo {

/// By how much a body reaches farther than the simple solid that stands for it, in each direction: the support function of its convex hull less that of the
/// solid's, in metres, kept on a lattice of directions and interpolated between them. Robot's frame: x forward, y to the left, z up.
class ReachCorrection
{
public:
    static constexpr int azimuths = 36, elevations = 15; ///< of the lattice
    static constexpr double stepRad = 0.17453292519943295; ///< 10°
    static constexpr int nodes = azimuths * elevations;

    /// None.
    ReachCorrection() = default;
    explicit ReachCorrection(Eigen::VectorXd valuesM) : m_valuesM(std::move(valuesM)) {}

    /// direction: of any length.
    double at(const Eigen::Vector3d &direction) const;

    /// The nodes about a direction and what each counts there.
    struct Weights
    {
        std::array<int, 4> node{};
        std::array<double, 4> weight{};
    };
    static Weights weightsAt(const Eigen::Vector3d &direction);
    static Eigen::Vector3d directionOf(int node);

private:
    Eigen::VectorXd m_valuesM; ///< of the nodes; empty: none
};

} // namespace odo
