// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/kalman_smoother.h"

#include "core/base/job_control.h"
#include "core/trajectory/internal/wobble_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace odo {

namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Matrix28 = Eigen::Matrix<double, 2, 8>;

/// Of one axis (position, velocity, acceleration): one abrupt change at an unknown moment of the last t
/// seconds, all moments alike.
Eigen::Matrix3d changeNoise(double sigmaSpeedMps, double sigmaAccelMps2, double t)
{
    // A change u before now has moved the position by Δv·u and Δa·u²/2 and the velocity by Δa·u; u is even in
    // [0, T], so that E[uⁿ] = Tⁿ/(n + 1).
    const double t2 = t * t;
    Eigen::Matrix3d ofSpeed, ofAccel;
    ofSpeed << t2 / 3, t / 2, 0, t / 2, 1, 0, 0, 0, 0;
    ofAccel << t2 * t2 / 20, t2 * t / 8, t2 / 6, t2 * t / 8, t2 / 3, t / 2, t2 / 6, t / 2, 1;
    return sigmaSpeedMps * sigmaSpeedMps * ofSpeed + sigmaAccelMps2 * sigmaAccelMps2 * ofAccel;
}

/// The way from one node to the next: state ← F · state, with the covariance Q added. F holds the position's,
/// velocity's and acceleration's integration, and how much of the slow error is kept. It is mostly zeros, so
/// it is never written out: rows and columns are added to one another.
struct Step
{
    double dt, kept;
    Eigen::Matrix3d axisNoise;

    Step(double dtS, double pathM, const TrackNode &to, const MotionNoise &motion)
        : dt(dtS), kept(std::exp(-std::abs(pathM) / motion.slowLengthM)),
          axisNoise(jerkNoise(dtS, to, motion))
    {
    }

    /// F · matrix.
    template <class Matrix>
    Matrix applied(Matrix matrix) const
    {
        matrix.template topRows<2>() +=
            dt * matrix.template middleRows<2>(2) + dt * dt / 2 * matrix.template middleRows<2>(4);
        matrix.template middleRows<2>(2) += dt * matrix.template middleRows<2>(4);
        matrix.template bottomRows<2>() *= kept;
        return matrix;
    }

    /// F · covariance · Fᵀ + Q.
    Matrix8 predicted(const Matrix8 &covariance) const
    {
        Matrix8 result = applied(Matrix8(applied(covariance).transpose()));
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                result.block<2, 2>(2 * i, 2 * j).diagonal().array() += axisNoise(i, j);
        }
        result.bottomRightCorner<2, 2>().diagonal().array() += 1 - kept * kept;
        return result;
    }
};

/// How a measurement follows from the state.
struct Sight
{
    Matrix28 design = Matrix28::Zero();
    Eigen::Matrix2d noise;

    Sight(const TrackNode &node, const MotionNoise &motion)
    {
        const Eigen::Matrix2d covariance = motion.measurementScale * node.covariance;
        design.leftCols<2>().setIdentity();
        design.rightCols<2>() = (motion.slowShare * covariance).llt().matrixL();
        if (!(motion.slowShare > 0))
            design.rightCols<2>().setZero();
        noise = (1 - motion.slowShare) * covariance;
    }
};

/// Position, velocity and acceleration along one axis, where the axes are apart. The covariance is symmetric.
struct AxisState
{
    double mean[3], covariance[3][3];

    AxisState(const MotionFilter::State &state, int axis)
    {
        for (int i = 0; i < 3; ++i) {
            mean[i] = state.mean[2 * i + axis];
            for (int j = 0; j < 3; ++j)
                covariance[i][j] = state.covariance(2 * i + axis, 2 * j + axis);
        }
    }

    void put(MotionFilter::State &into, int axis) const
    {
        for (int i = 0; i < 3; ++i) {
            into.mean[2 * i + axis] = mean[i];
            for (int j = 0; j < 3; ++j)
                into.covariance(2 * i + axis, 2 * j + axis) = covariance[i][j];
        }
    }

    /// F · mean, and F · covariance · Fᵀ + Q.
    void predict(const Step &step)
    {
        const double t = step.dt, half = t * t / 2;
        mean[0] += t * mean[1] + half * mean[2];
        mean[1] += t * mean[2];
        for (auto &row : covariance) { // covariance · Fᵀ
            row[0] += t * row[1] + half * row[2];
            row[1] += t * row[2];
        }
        for (int j = 0; j < 3; ++j) {
            covariance[0][j] += t * covariance[1][j] + half * covariance[2][j];
            covariance[1][j] += t * covariance[2][j];
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                covariance[i][j] += step.axisNoise(i, j);
        }
    }

    /// Joseph's form, as MotionFilter::update.
    void update(double position, double variance)
    {
        const double s = covariance[0][0] + variance, innovation = position - mean[0];
        const double gain[3] = {covariance[0][0] / s, covariance[1][0] / s, covariance[2][0] / s};
        double kept[3][3];
        for (int i = 0; i < 3; ++i) {
            mean[i] += gain[i] * innovation;
            for (int j = 0; j < 3; ++j)
                kept[i][j] = covariance[i][j] - gain[i] * covariance[0][j];
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j <= i; ++j) {
                const double below = kept[i][j] - kept[i][0] * gain[j],
                             above = kept[j][i] - kept[j][0] * gain[i];
                covariance[i][j] = covariance[j][i] = (below + above) / 2 + gain[i] * variance * gain[j];
            }
        }
    }

    double determinant() const
    {
        const auto &c = covariance;
        return c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) -
               c[0][1] * (c[1][0] * c[2][2] - c[1][2] * c[2][0]) +
               c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
    }
};

/// Solves symmetric · x = right for a positive definite matrix (L D Lᵀ).
void solve(const double (&symmetric)[3][3], double (&x)[3])
{
    const double d0 = symmetric[0][0], l10 = symmetric[1][0] / d0, l20 = symmetric[2][0] / d0;
    const double d1 = symmetric[1][1] - l10 * symmetric[1][0], s21 = symmetric[2][1] - l20 * symmetric[1][0],
                 l21 = s21 / d1;
    const double d2 = symmetric[2][2] - l20 * symmetric[2][0] - l21 * s21;
    x[1] -= l10 * x[0];
    x[2] -= l20 * x[0] + l21 * x[1];
    x[2] /= d2;
    x[1] = x[1] / d1 - l21 * x[2];
    x[0] = x[0] / d0 - l10 * x[1] - l20 * x[2];
}

/// Whether a measurement keeps the axes apart.
bool leavesAxesApart(const TrackNode &measurement, const MotionNoise &noise)
{
    return noise.slowShare == 0 && measurement.covariance(0, 1) == 0 && measurement.covariance(1, 0) == 0;
}

} // namespace

Eigen::Matrix3d jerkNoise(double stepS, const TrackNode &node, const MotionNoise &motion)
{
    const double t2 = stepS * stepS, t3 = t2 * stepS;
    Eigen::Matrix3d noise;
    noise << t3 * t2 / 20, t2 * t2 / 8, t3 / 6, //
        t2 * t2 / 8, t3 / 3, t2 / 2,            //
        t3 / 6, t2 / 2, stepS;
    noise *= motion.jerkDensity * node.liveliness;
    if (node.struck)
        noise += changeNoise(blowSpeedSigmaMps, blowAccelSigmaMps2, stepS);
    return noise;
}

double MotionFilter::logVolume() const
{
    if (m_state.axesApart)
        return std::log(AxisState(m_state, 0).determinant() * AxisState(m_state, 1).determinant());
    return std::log(estimate().covariance.determinant());
}

void MotionFilter::predict(const TrackNode &node)
{
    endIfCancelled();
    if (!m_started)
        return;
    const Step step(node.timeS - m_timeS, node.travelM - m_travelM, node, m_noise);
    if (m_state.axesApart) {
        for (const int axis : {0, 1}) {
            AxisState its(m_state, axis);
            its.predict(step);
            its.put(m_state, axis);
        }
    } else {
        m_state.mean = step.applied(m_state.mean);
        m_state.covariance = step.predicted(m_state.covariance);
    }
    m_timeS = node.timeS;
    m_travelM = node.travelM;
}

double MotionFilter::distanceSquared(const TrackNode &measurement, double *logDeterminant) const
{
    if (m_state.axesApart && leavesAxesApart(measurement, m_noise)) {
        double squared = 0, determinant = 1;
        for (const int axis : {0, 1}) {
            const double s = m_state.covariance(axis, axis) +
                             m_noise.measurementScale * measurement.covariance(axis, axis);
            const double innovation = measurement.position[axis] - m_state.mean[axis];
            squared += innovation * innovation / s;
            determinant *= s;
        }
        if (logDeterminant)
            *logDeterminant = std::log(determinant);
        return squared;
    }
    const Sight sight(measurement, m_noise);
    const Eigen::Matrix2d s = sight.design * m_state.covariance * sight.design.transpose() + sight.noise;
    const Eigen::Vector2d innovation = measurement.position - sight.design * m_state.mean;
    if (logDeterminant)
        *logDeterminant = std::log(s.determinant());
    return innovation.dot(s.inverse() * innovation);
}

void MotionFilter::restart(const TrackNode &measurement, double sigmaSpeedMps, double sigmaAccelMps2)
{
    const Eigen::Matrix2d covariance = m_noise.measurementScale * measurement.covariance;
    const Eigen::Matrix2d slow = Sight(measurement, m_noise).design.rightCols<2>();
    m_state = State();
    m_state.axesApart = leavesAxesApart(measurement, m_noise);
    m_state.mean.head<2>() = measurement.position;
    m_state.covariance.topLeftCorner<2, 2>() = covariance;
    m_state.covariance.diagonal().segment<2>(2).setConstant(sigmaSpeedMps * sigmaSpeedMps);
    m_state.covariance.diagonal().segment<2>(4).setConstant(sigmaAccelMps2 * sigmaAccelMps2);
    // What is measured too far is the slow error's sum with the position: the two are anticorrelated.
    m_state.covariance.bottomRightCorner<2, 2>().setIdentity();
    m_state.covariance.topRightCorner<2, 2>() = -slow;
    m_state.covariance.bottomLeftCorner<2, 2>() = -slow.transpose();
    m_timeS = measurement.timeS;
    m_travelM = measurement.travelM;
    m_started = true;
}

void MotionFilter::disturb(double sigmaSpeedMps, double sigmaAccelMps2, double sinceS)
{
    const Eigen::Matrix3d axis = changeNoise(sigmaSpeedMps, sigmaAccelMps2, sinceS);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m_state.covariance.block<2, 2>(2 * i, 2 * j).diagonal().array() += axis(i, j);
    }
}

void MotionFilter::update(const TrackNode &measurement)
{
    if (!m_started) {
        restart(measurement);
        return;
    }
    m_state.axesApart = m_state.axesApart && leavesAxesApart(measurement, m_noise);
    if (m_state.axesApart) {
        for (const int axis : {0, 1}) {
            AxisState its(m_state, axis);
            its.update(measurement.position[axis],
                       m_noise.measurementScale * measurement.covariance(axis, axis));
            its.put(m_state, axis);
        }
        return;
    }
    const Sight sight(measurement, m_noise);
    const Eigen::Matrix<double, 8, 2> crossed = m_state.covariance * sight.design.transpose();
    const Eigen::Matrix2d s = sight.design * crossed + sight.noise;
    const Eigen::Matrix<double, 8, 2> gain = crossed * s.inverse();
    m_state.mean += gain * (measurement.position - sight.design * m_state.mean);
    const Matrix8 kept = m_state.covariance - gain * crossed.transpose();
    const Matrix8 joseph =
        kept - (kept * sight.design.transpose()) * gain.transpose() + gain * sight.noise * gain.transpose();
    // Rounding must not grow into an asymmetry that the next steps multiply.
    m_state.covariance = (joseph + joseph.transpose()) / 2;
}

namespace {

constexpr std::size_t smoothedAtOnce = 1024; // nodes whose filtered states are held

template <class Filter>
void filterOn(Filter &filter, const TrackNode &node)
{
    filter.predict(node);
    if (node.measured)
        filter.update(node);
}

/// As below, of one axis.
void smoothAxis(MotionFilter::State &now, int axis, const AxisState &next, const Step &step)
{
    AxisState smoothed(now, axis), predicted = smoothed;
    predicted.predict(step);
    const double t = step.dt;
    double gain[3][3], change[3][3];
    for (int i = 0; i < 3; ++i) { // covariance · Fᵀ · predicted⁻¹, a row at a time
        const double(&row)[3] = smoothed.covariance[i];
        gain[i][0] = row[0] + t * row[1] + t * t / 2 * row[2];
        gain[i][1] = row[1] + t * row[2];
        gain[i][2] = row[2];
        solve(predicted.covariance, gain[i]);
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            change[i][j] = 0;
            for (int k = 0; k < 3; ++k)
                change[i][j] += gain[i][k] * (next.covariance[k][j] - predicted.covariance[k][j]);
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            smoothed.mean[i] += gain[i][k] * (next.mean[k] - predicted.mean[k]);
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k)
                sum += (change[i][k] * gain[j][k] + change[j][k] * gain[i][k]) / 2;
            smoothed.covariance[i][j] += sum;
            smoothed.covariance[j][i] = smoothed.covariance[i][j];
        }
    }
    smoothed.put(now, axis);
}

} // namespace

MotionFilter::State MotionFilter::smoothed(State now, const TrackNode &node, const State &next,
                                           const TrackNode &nextNode, const MotionNoise &noise)
{
    const Step step(nextNode.timeS - node.timeS, nextNode.travelM - node.travelM, nextNode, noise);
    now.axesApart = now.axesApart && next.axesApart;
    if (now.axesApart) {
        for (const int axis : {0, 1})
            smoothAxis(now, axis, AxisState(next, axis), step);
        return now;
    }
    const Matrix8 predicted = step.predicted(now.covariance);
    const Matrix8 gain = predicted.ldlt().solve(step.applied(now.covariance)).transpose();
    now.mean += gain * (next.mean - step.applied(now.mean));
    const Matrix8 change = gain * (next.covariance - predicted) * gain.transpose();
    now.covariance += (change + change.transpose()) / 2;
    return now;
}

namespace {

template <class Filter>
void smoothInBlocks(std::span<const TrackNode> track, const MotionNoise &noise, const TakeEstimate &take)
{
    std::vector<Filter> starts; // of each block
    Filter filter(noise);
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (i % smoothedAtOnce == 0)
            starts.push_back(filter);
        if (i / smoothedAtOnce < (track.size() - 1) / smoothedAtOnce) // the last block is filtered below
            filterOn(filter, track[i]);
    }
    std::vector<typename Filter::State> states;
    typename Filter::State next;
    for (std::size_t block = starts.size(); block-- > 0;) {
        const std::size_t first = block * smoothedAtOnce;
        const auto nodes = track.subspan(first, std::min(smoothedAtOnce, track.size() - first));
        states.clear();
        for (const TrackNode &node : nodes) {
            filterOn(starts[block], node);
            states.push_back(starts[block].state());
        }
        for (std::size_t i = first + nodes.size(); i-- > first;) {
            const typename Filter::State &now = states[i - first];
            next = i + 1 < track.size() ? Filter::smoothed(now, track[i], next, track[i + 1], noise) : now;
            take(i, Filter::estimateOf(next));
        }
    }
}

} // namespace

void smoothMotion(std::span<const TrackNode> track, MotionNoise noise, const TakeEstimate &take)
{
    if (noise.wobbleM > 0)
        smoothInBlocks<WobbleFilter>(track, noise, take);
    else
        smoothInBlocks<MotionFilter>(track, noise, take);
}

} // namespace odo
