// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/wobble_filter.h"

#include "core/base/job_control.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace odo {

namespace {

using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

/// A position is measured with the wobble on it.
const Vector5 seen = (Vector5() << 1, 0, 0, 1, 0).finished();

/// From one node to the next: state ← F · state, with Q added.
struct WobbleStep
{
    Matrix5 transition = Matrix5::Identity(), noise = Matrix5::Zero();

    WobbleStep(double dt, const TrackNode &to, const MotionNoise &motion)
    {
        transition.topLeftCorner<3, 3>() << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
        noise.topLeftCorner<3, 3>() = jerkNoise(dt, to, motion);
        const double rate = motion.wobbleRate, variance = motion.wobbleM * motion.wobbleM;
        const bool drifts = motion.wobbleOrder == 1;
        Eigen::Matrix2d kept = Eigen::Vector2d(1, 0).asDiagonal();
        if (!drifts)
            kept << 1 + rate * dt, dt, -rate * rate * dt, 1 - rate * dt;
        kept *= std::exp(-rate * dt);
        const Eigen::Matrix2d usual =
            Eigen::Vector2d(variance, drifts ? 0 : rate * rate * variance).asDiagonal();
        transition.bottomRightCorner<2, 2>() = kept;
        noise.bottomRightCorner<2, 2>() = usual - kept * usual * kept.transpose();
    }

    Matrix5 predicted(const Matrix5 &covariance) const
    {
        return transition * covariance * transition.transpose() + noise;
    }
};

WobbleFilter::Axis startOf(double position, double variance, const MotionNoise &noise)
{
    const double wobble = noise.wobbleM * noise.wobbleM;
    WobbleFilter::Axis axis;
    axis.mean[0] = position;
    axis.covariance.diagonal() << variance + wobble, firstSigmaMps * firstSigmaMps,
        firstSigmaMps2 * firstSigmaMps2, wobble,
        noise.wobbleOrder == 1 ? 0 : noise.wobbleRate * noise.wobbleRate * wobble;
    // What is measured too far is the wobble's sum with the position: the two are anticorrelated.
    axis.covariance(0, 3) = axis.covariance(3, 0) = -wobble;
    return axis;
}

} // namespace

void WobbleFilter::predict(const TrackNode &node)
{
    endIfCancelled();
    if (!m_started)
        return;
    const WobbleStep step(node.timeS - m_timeS, node, m_noise);
    for (Axis &axis : m_state) {
        axis.mean = step.transition * axis.mean;
        axis.covariance = step.predicted(axis.covariance);
    }
    m_timeS = node.timeS;
}

double WobbleFilter::distanceSquared(const TrackNode &measurement, double *logDeterminant) const
{
    double squared = 0, determinant = 1;
    for (const int i : {0, 1}) {
        const double s = seen.dot(m_state[std::size_t(i)].covariance * seen) +
                         m_noise.measurementScale * measurement.covariance(i, i);
        const double innovation = measurement.position[i] - seen.dot(m_state[std::size_t(i)].mean);
        squared += innovation * innovation / s;
        determinant *= s;
    }
    if (logDeterminant)
        *logDeterminant = std::log(determinant);
    return squared;
}

void WobbleFilter::update(const TrackNode &measurement)
{
    for (const int i : {0, 1}) {
        Axis &axis = m_state[std::size_t(i)];
        const double variance = m_noise.measurementScale * measurement.covariance(i, i);
        if (!m_started) {
            axis = startOf(measurement.position[i], variance, m_noise);
            continue;
        }
        const Vector5 crossed = axis.covariance * seen;
        const Vector5 gain = crossed / (seen.dot(crossed) + variance);
        axis.mean += gain * (measurement.position[i] - seen.dot(axis.mean));
        const Matrix5 kept = Matrix5::Identity() - gain * seen.transpose();
        axis.covariance = kept * axis.covariance * kept.transpose() + gain * variance * gain.transpose();
    }
    m_timeS = measurement.timeS;
    m_started = true;
}

WobbleFilter::State WobbleFilter::smoothed(State now, const TrackNode &node, const State &next,
                                           const TrackNode &nextNode, const MotionNoise &noise)
{
    const WobbleStep step(nextNode.timeS - node.timeS, nextNode, noise);
    for (const std::size_t i : {0, 1}) {
        const Matrix5 predicted = step.predicted(now[i].covariance);
        const Matrix5 gain = predicted.ldlt().solve(step.transition * now[i].covariance).transpose();
        now[i].mean += gain * (next[i].mean - step.transition * now[i].mean);
        const Matrix5 change = gain * (next[i].covariance - predicted) * gain.transpose();
        now[i].covariance += (change + change.transpose()) / 2;
    }
    return now;
}

MotionEstimate WobbleFilter::estimateOf(const State &state)
{
    MotionEstimate estimate;
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 0; i < 3; ++i) {
            estimate.mean[2 * i + axis] = state[std::size_t(axis)].mean[i];
            for (int j = 0; j < 3; ++j)
                estimate.covariance(2 * i + axis, 2 * j + axis) = state[std::size_t(axis)].covariance(i, j);
        }
    }
    return estimate;
}

} // namespace odo
