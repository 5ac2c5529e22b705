// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/kalman_smoother.h"

#include <array>

namespace odo {

/// As MotionFilter, for tracks whose error wobbles or drifts. Besides the independent part the error then has
/// a Gauss–Markov process (Gelb 1974, § 3.8) with the standard deviation wobbleM. Of second order (a Matérn
/// process of ν = 3/2), with the correlation (1 + λt)·exp(−λt): a marker on a mast that rocks, or positions
/// that another program has smoothed. Of first order, with exp(−λt): a localisation that drifts and is pulled
/// back. Its speed would otherwise be taken for the robot's. Each axis by itself: correlations of x and y in
/// the covariances are not used.
class WobbleFilter
{
public:
    /// Of each axis: position, velocity, acceleration, the wobble and its rate.
    struct Axis
    {
        Eigen::Matrix<double, 5, 1> mean = Eigen::Matrix<double, 5, 1>::Zero();
        Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
    };
    using State = std::array<Axis, 2>;

    explicit WobbleFilter(MotionNoise noise) : m_noise(noise) {}

    bool started() const { return m_started; }
    void predict(const TrackNode &node);
    double distanceSquared(const TrackNode &measurement, double *logDeterminant = nullptr) const;
    void update(const TrackNode &measurement);
    const State &state() const { return m_state; }

    /// What is known of a node, given what all nodes from the one behind it on say (Rauch, Tung, Striebel).
    static State smoothed(State now, const TrackNode &node, const State &next, const TrackNode &nextNode,
                          const MotionNoise &noise);
    static MotionEstimate estimateOf(const State &state);

private:
    MotionNoise m_noise;
    State m_state;
    double m_timeS = 0;
    bool m_started = false;
};

} // namespace odo
