// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/kalman_smoother.h"

#include "core/base/job_control.h"

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

    Step(double dtS, double pathM, bool struck, const MotionNoise &motion)
        : dt(dtS), kept(std::exp(-std::abs(pathM) / motion.slowLengthM))
    {
        const double t2 = dt * dt, t3 = t2 * dt;
        axisNoise << t3 * t2 / 20, t2 * t2 / 8, t3 / 6, //
            t2 * t2 / 8, t3 / 3, t2 / 2,                //
            t3 / 6, t2 / 2, dt;
        axisNoise *= motion.jerkDensity;
        if (struck)
            axisNoise += changeNoise(blowSpeedSigmaMps, blowAccelSigmaMps2, dt);
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
    const Step step(node.timeS - m_timeS, node.travelM - m_travelM, node.struck, m_noise);
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

void filterOn(MotionFilter &filter, const TrackNode &node)
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

/// What is known of a node, given what all nodes from the one behind it on say.
MotionFilter::State smoothed(MotionFilter::State now, const TrackNode &node, const MotionFilter::State &next,
                             const TrackNode &nextNode, const MotionNoise &noise)
{
    const Step step(nextNode.timeS - node.timeS, nextNode.travelM - node.travelM, nextNode.struck, noise);
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

} // namespace

void smoothMotion(std::span<const TrackNode> track, MotionNoise noise, const TakeEstimate &take)
{
    std::vector<MotionFilter> starts; // of each block
    MotionFilter filter(noise);
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (i % smoothedAtOnce == 0)
            starts.push_back(filter);
        if (i / smoothedAtOnce < (track.size() - 1) / smoothedAtOnce) // the last block is filtered below
            filterOn(filter, track[i]);
    }
    std::vector<MotionFilter::State> states;
    MotionFilter::State next;
    for (std::size_t block = starts.size(); block-- > 0;) {
        const std::size_t first = block * smoothedAtOnce;
        const auto nodes = track.subspan(first, std::min(smoothedAtOnce, track.size() - first));
        states.clear();
        for (const TrackNode &node : nodes) {
            filterOn(starts[block], node);
            states.push_back(starts[block].state());
        }
        for (std::size_t i = first + nodes.size(); i-- > first;) {
            const MotionFilter::State &now = states[i - first];
            next = i + 1 < track.size() ? smoothed(now, track[i], next, track[i + 1], noise) : now;
            take(i, {next.mean.head<6>(), next.covariance.topLeftCorner<6, 6>()});
        }
    }
}

namespace {

/// Twice the negative log likelihood and the scale that minimises it, for a ratio of jerk density to scale.
struct Likelihood
{
    double cost = 0;
    double scale = 1;
};

constexpr int startingInnovations = 2; // velocity and acceleration: still all ignorance, no information
constexpr std::size_t blockLength = 500, mostSamples = 20000;

struct Sums
{
    double distances = 0, logDeterminants = 0, count = 0;
};

void addInnovations(std::span<const TrackNode> track, const MotionNoise &noise, bool robust, Sums &sums)
{
    MotionFilter filter(noise);
    int taken = 0;
    for (const TrackNode &node : track) {
        if (!node.measured)
            continue;
        filter.predict(node);
        double distance = 0, logDeterminant = 0;
        if (filter.started())
            distance = filter.distanceSquared(node, &logDeterminant);
        const bool refused = robust && distance > refusalGate;
        if (taken > startingInnovations) {
            sums.distances += refused ? refusalGate : distance;
            sums.logDeterminants += logDeterminant;
            sums.count += 1;
        }
        if (!refused)
            filter.update(node);
        ++taken;
    }
}

Likelihood likelihood(std::span<const std::span<const TrackNode>> blocks, double jerkDensity, bool robust,
                      const MeasurementNoise &measurement)
{
    Sums sums;
    for (const auto &block : blocks)
        addInnovations(block,
                       {jerkDensity, measurement.scale, measurement.slowShare, measurement.slowLengthM},
                       robust, sums);
    if (robust)
        return {sums.logDeterminants + sums.distances, 1};
    const double weight = 2 * (sums.count + measurement.trust);
    const double scale = (sums.distances + 2 * measurement.trust) / weight;
    return {sums.logDeterminants + weight * std::log(scale), scale};
}

/// Long tracks are represented by evenly spread blocks.
std::vector<std::span<const TrackNode>> chooseBlocks(const std::vector<std::span<const TrackNode>> &segments)
{
    std::size_t total = 0;
    for (const auto &segment : segments)
        total += segment.size();
    const std::size_t stride = total / mostSamples + 1;
    std::vector<std::span<const TrackNode>> blocks;
    for (const auto &all : segments) {
        if (stride == 1) {
            blocks.push_back(all);
            continue;
        }
        for (std::size_t begin = 0; begin < all.size(); begin += blockLength * stride)
            blocks.push_back(all.subspan(begin, std::min(blockLength, all.size() - begin)));
    }
    return blocks;
}

} // namespace

MotionNoise estimateMotionNoise(const std::vector<std::span<const TrackNode>> &segments, bool robust,
                                const MeasurementNoise &measurement)
{
    const auto blocks = chooseBlocks(segments);
    const auto costAt = [&](double exponent) {
        return likelihood(blocks, std::pow(10.0, exponent), robust, measurement).cost;
    };
    constexpr double lowest = -5, highest = 6;
    double best = lowest, bestCost = costAt(lowest);
    for (double exponent = lowest + 1; exponent <= highest; ++exponent) {
        if (const double cost = costAt(exponent); cost < bestCost) {
            best = exponent;
            bestCost = cost;
        }
    }
    constexpr double golden = 0.6180339887498949;
    double left = std::max(lowest, best - 1), right = std::min(highest, best + 1);
    double inner = right - golden * (right - left), outer = left + golden * (right - left);
    double innerCost = costAt(inner), outerCost = costAt(outer);
    while (right - left > 0.03) {
        if (innerCost < outerCost) {
            right = outer;
            outer = inner;
            outerCost = innerCost;
            inner = right - golden * (right - left);
            innerCost = costAt(inner);
        } else {
            left = inner;
            inner = outer;
            innerCost = outerCost;
            outer = left + golden * (right - left);
            outerCost = costAt(outer);
        }
    }
    const double ratio = std::pow(10.0, (left + right) / 2);
    const double scale = likelihood(blocks, ratio, robust, measurement).scale;
    return {ratio * scale, measurement.scale * scale, measurement.slowShare, measurement.slowLengthM};
}

} // namespace odo
