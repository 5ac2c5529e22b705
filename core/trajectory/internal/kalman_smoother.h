// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
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
    double travelM = 0;    ///< way up to here, and restDriftMps: what changes the slow part of the noise
    bool struck = false;   ///< the velocity changed abruptly since the node before: a blow
    double liveliness = 1; ///< factor on the jerk's density since the node before: rest, drive, impact
};

/// By how much a collision changes the velocity and a motor, or a collision, the acceleration.
constexpr double blowSpeedSigmaMps = 1.5, blowAccelSigmaMps2 = 10;

/// While a robot stands, its errors change as if it crept at this speed, in metres per second: the coding of
/// a video keeps an edge for a while, the light flickers.
constexpr double restDriftMps = 0.05;

/// How the errors of the measurements are correlated. A part of them changes as the robot moves and
/// turns before the camera (its edges lie otherwise among the pixels, its sides are lit otherwise) and hardly
/// else: standing still does not average it out, and over a short distance it looks like motion. Correlation
/// exp(−distance / slowLengthM), an Ornstein–Uhlenbeck process.
struct MeasurementNoise
{
    double scale = 1;     ///< factor on the stated covariances
    double slowShare = 0; ///< part of the scaled variance that is slow; the rest is independent
    double slowLengthM = 0.1;
    double trust = 10; ///< how many innovations the scale counts as, against those of the data
    /// The error may have a part that wobbles or drifts; whether it has is found from the track. Only where
    /// the covariances do not correlate x with y.
    bool mayWobble = false;
    double wobbleM = 0, wobbleRate = 0; ///< of that part, as of MotionNoise
    int wobbleOrder = 2;
};

/// What moves the robot and blurs the measurement.
struct MotionNoise
{
    double jerkDensity = 1;      ///< spectral density of the white jerk of each axis, m²/s⁵
    double measurementScale = 1; ///< as of MeasurementNoise
    double slowShare = 0, slowLengthM = 0.1;
    double wobbleM = 0, wobbleRate = 0; ///< σ and λ, 1/s, as WobbleFilter says; without σ there is none
    int wobbleOrder = 2;                ///< 2: its rate changes smoothly; 1: it drifts, in independent steps
};

/// Noise added to position, velocity and acceleration of one axis by white jerk, and by the blow where the
/// node was struck, in the time before it.
Eigen::Matrix3d jerkNoise(double stepS, const TrackNode &node, const MotionNoise &motion);

/// What a filter knows of the motion when it begins: nothing.
inline constexpr double firstSigmaMps = 10, firstSigmaMps2 = 50;

/// Until the data show it: a robot that changes its acceleration by 3 m/s² in a third of a second.
inline constexpr double usualJerkDensity = 10;

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
/// 2001, eq. 6.2.3-4..9), exact for irregular intervals, with the slow error of the measurements as two more
/// states (the same, § 8.2: coloured measurement noise by augmentation). Starts at the first measurement with
/// 10 m/s and 50 m/s² of ignorance.
class MotionFilter
{
public:
    explicit MotionFilter(MotionNoise noise) : m_noise(noise) {}

    bool started() const { return m_started; }
    /// Moves the estimate on to a node's time (no-op before the start), disturbed by a blow if it is struck.
    void predict(const TrackNode &node);
    /// Squared Mahalanobis distance of a measurement from the prediction; logDeterminant of its covariance if
    /// wanted.
    double distanceSquared(const TrackNode &measurement, double *logDeterminant = nullptr) const;
    /// Takes a measurement in (Joseph's form); the first one starts the filter.
    void update(const TrackNode &measurement);
    /// Forgets the past: begins again at this measurement, with this much ignorance of the motion.
    void restart(const TrackNode &measurement, double sigmaSpeedMps = firstSigmaMps,
                 double sigmaAccelMps2 = firstSigmaMps2);
    /// Allows for one abrupt change of velocity and of acceleration at an unknown moment of the last sinceS
    /// seconds, all moments alike; call it after predict.
    void disturb(double sigmaSpeedMps, double sigmaAccelMps2, double sinceS);

    MotionEstimate estimate() const { return estimateOf(m_state); }

    /// The whole state: motion, and the slow error in units of its standard deviation along two axes.
    struct State
    {
        Eigen::Matrix<double, 8, 1> mean = Eigen::Matrix<double, 8, 1>::Zero();
        Eigen::Matrix<double, 8, 8> covariance = Eigen::Matrix<double, 8, 8>::Zero();
        /// x and y say nothing of one another, and no error is slow, as in tracks that other programs
        /// measured: each axis is then filtered by itself, with the same result in a tenth of the time.
        bool axesApart = false;
    };
    const State &state() const { return m_state; }
    /// What is known of a node, given what all nodes from the one behind it on say.
    static State smoothed(State now, const TrackNode &node, const State &next, const TrackNode &nextNode,
                          const MotionNoise &noise);
    static MotionEstimate estimateOf(const State &state)
    {
        return {state.mean.head<6>(), state.covariance.topLeftCorner<6, 6>()};
    }
    /// Logarithm of the determinant of the estimate's covariance.
    double logVolume() const;

private:
    MotionNoise m_noise;
    State m_state;
    double m_timeS = 0, m_travelM = 0;
    bool m_started = false;
};

/// Is given the index of a node and the estimate at its time.
using TakeEstimate = std::function<void(std::size_t, const MotionEstimate &)>;

/// Rauch–Tung–Striebel smoother (Rauch, Tung, Striebel 1965): one estimate for every time, from all
/// measurements, given from the last to the first. The first time must be measured. At a blow the motion
/// before and after are smoothed each by itself, except for the position, which continues. A long track is
/// filtered again in blocks during the backward pass: the forward pass keeps only the filter at the start of
/// each. Pure.
void smoothMotion(std::span<const TrackNode> track, MotionNoise noise, const TakeEstimate &take);

/// χ² with two degrees of freedom, 99.9 %.
constexpr double refusalGate = 13.8155;

/// The first innovations of a segment, while velocity and acceleration are all ignorance: they say nothing.
constexpr int startingInnovations = 2;

} // namespace odo
