// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// One time of a track, in order of time: with a measured position, or with none (a gap to be bridged). SI.
struct TrackNode
{
    double timeS = 0;
    bool measured = false;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< m², positive definite where measured
};

/// What moves the robot and blurs the measurement.
struct MotionNoise
{
    double jerkDensity = 1;      ///< spectral density of the white jerk of each axis, m²/s⁵
    double measurementScale = 1; ///< factor on the stated covariances of the measurements
};

/// Position, velocity and acceleration (x, y, vx, vy, ax, ay) at one time. SI.
struct MotionEstimate
{
    Eigen::Matrix<double, 6, 1> mean = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();

    Eigen::Vector2d position() const { return mean.head<2>(); }
    Eigen::Vector2d velocity() const { return mean.segment<2>(2); }
    Eigen::Vector2d acceleration() const { return mean.tail<2>(); }
};

/// Kalman filter over a model of constant acceleration driven by white jerk (Bar-Shalom, Li, Kirubarajan
/// 2001, eq. 6.2.3-4..9), exact for irregular intervals. Starts at the first measurement with 10 m/s and 50
/// m/s² of ignorance.
class MotionFilter
{
public:
    explicit MotionFilter(MotionNoise noise) : m_noise(noise) {}

    bool started() const { return m_started; }
    /// Moves the estimate on to a time (no-op before the start).
    void predict(double timeS);
    /// Squared Mahalanobis distance of a measurement from the prediction; logDeterminant of its covariance if
    /// wanted.
    double distanceSquared(const TrackNode &measurement, double *logDeterminant = nullptr) const;
    /// Takes a measurement in (Joseph's form); the first one starts the filter.
    void update(const TrackNode &measurement);
    /// Forgets the past: begins again at this measurement, with this much ignorance of the motion.
    void restart(const TrackNode &measurement, double sigmaSpeedMps = 10, double sigmaAccelMps2 = 50);
    /// Allows for one abrupt change of velocity and of acceleration at an unknown moment of the last sinceS
    /// seconds, all moments alike; call it after predict.
    void disturb(double sigmaSpeedMps, double sigmaAccelMps2, double sinceS);

    const MotionEstimate &estimate() const { return m_estimate; }

private:
    MotionNoise m_noise;
    MotionEstimate m_estimate;
    double m_timeS = 0;
    bool m_started = false;
};

/// Rauch–Tung–Striebel smoother (Rauch, Tung, Striebel 1965): one estimate for every time, from all
/// measurements. The first time must be measured. Pure.
std::vector<MotionEstimate> smoothMotion(std::span<const TrackNode> track, MotionNoise noise);

/// Noise by maximum likelihood of the innovations (prediction error decomposition: Harvey 1989, § 3.4) over
/// all segments: the measurement scale in closed form, the jerk density by a logarithmic grid and a golden
/// section. The scale is drawn to 1 as by ten more innovations, so that few samples change little. robust: an
/// innovation beyond refusalGate counts as the gate and is not taken in (for data with spikes), scale 1.
MotionNoise estimateMotionNoise(const std::vector<std::span<const TrackNode>> &segments, bool robust);

/// χ² with two degrees of freedom, 99.9 %.
constexpr double refusalGate = 13.8155;

} // namespace odo
