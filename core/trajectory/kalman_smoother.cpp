// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/kalman_smoother.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace odo {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 transition(double dt)
{
    Matrix6 f = Matrix6::Identity();
    f.block<2, 2>(0, 2).diagonal().setConstant(dt);
    f.block<2, 2>(2, 4).diagonal().setConstant(dt);
    f.block<2, 2>(0, 4).diagonal().setConstant(dt * dt / 2);
    return f;
}

Matrix6 processCovariance(double dt, double jerkDensity)
{
    const double t2 = dt * dt, t3 = t2 * dt;
    Eigen::Matrix3d axis;
    axis << t3 * t2 / 20, t2 * t2 / 8, t3 / 6, //
        t2 * t2 / 8, t3 / 3, t2 / 2,           //
        t3 / 6, t2 / 2, dt;
    axis *= jerkDensity;
    Matrix6 q = Matrix6::Zero();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            q.block<2, 2>(2 * i, 2 * j).diagonal().setConstant(axis(i, j));
    }
    return q;
}

} // namespace

void MotionFilter::predict(double timeS)
{
    if (!m_started)
        return;
    const double dt = timeS - m_timeS;
    const Matrix6 f = transition(dt);
    m_estimate.mean = f * m_estimate.mean;
    m_estimate.covariance =
        f * m_estimate.covariance * f.transpose() + processCovariance(dt, m_noise.jerkDensity);
    m_timeS = timeS;
}

double MotionFilter::distanceSquared(const TrackNode &measurement, double *logDeterminant) const
{
    const Eigen::Matrix2d s =
        m_estimate.covariance.topLeftCorner<2, 2>() + m_noise.measurementScale * measurement.covariance;
    const Eigen::Vector2d innovation = measurement.position - m_estimate.position();
    if (logDeterminant)
        *logDeterminant = std::log(s.determinant());
    return innovation.dot(s.inverse() * innovation);
}

void MotionFilter::restart(const TrackNode &measurement, double sigmaSpeedMps, double sigmaAccelMps2)
{
    m_estimate.mean.setZero();
    m_estimate.mean.head<2>() = measurement.position;
    m_estimate.covariance.setZero();
    m_estimate.covariance.topLeftCorner<2, 2>() = m_noise.measurementScale * measurement.covariance;
    m_estimate.covariance.diagonal().segment<2>(2).setConstant(sigmaSpeedMps * sigmaSpeedMps);
    m_estimate.covariance.diagonal().tail<2>().setConstant(sigmaAccelMps2 * sigmaAccelMps2);
    m_timeS = measurement.timeS;
    m_started = true;
}

void MotionFilter::disturb(double sigmaSpeedMps, double sigmaAccelMps2, double sinceS)
{
    // A change u before now has moved the position by Δv·u and Δa·u²/2 and the velocity by Δa·u; u is even in
    // [0, T], so that E[uⁿ] = Tⁿ/(n + 1).
    const double t = sinceS, t2 = t * t;
    Eigen::Matrix3d axis;
    axis << t2 / 3, t / 2, 0, t / 2, 1, 0, 0, 0, 0;
    axis *= sigmaSpeedMps * sigmaSpeedMps;
    Eigen::Matrix3d ofAccel;
    ofAccel << t2 * t2 / 20, t2 * t / 8, t2 / 6, t2 * t / 8, t2 / 3, t / 2, t2 / 6, t / 2, 1;
    axis += sigmaAccelMps2 * sigmaAccelMps2 * ofAccel;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m_estimate.covariance.block<2, 2>(2 * i, 2 * j).diagonal().array() += axis(i, j);
    }
}

void MotionFilter::update(const TrackNode &measurement)
{
    if (!m_started) {
        restart(measurement);
        return;
    }
    const Eigen::Matrix2d r = m_noise.measurementScale * measurement.covariance;
    const Eigen::Matrix2d s = m_estimate.covariance.topLeftCorner<2, 2>() + r;
    const Eigen::Matrix<double, 6, 2> gain = m_estimate.covariance.leftCols<2>() * s.inverse();
    m_estimate.mean += gain * (measurement.position - m_estimate.position());
    Matrix6 keep = Matrix6::Identity();
    keep.leftCols<2>() -= gain;
    m_estimate.covariance = keep * m_estimate.covariance * keep.transpose() + gain * r * gain.transpose();
}

std::vector<MotionEstimate> smoothMotion(std::span<const TrackNode> track, MotionNoise noise)
{
    std::vector<MotionEstimate> estimates;
    estimates.reserve(track.size());
    MotionFilter filter(noise);
    for (const TrackNode &node : track) {
        filter.predict(node.timeS);
        if (node.measured)
            filter.update(node);
        estimates.push_back(filter.estimate());
    }
    for (std::size_t i = estimates.size(); i-- > 1;) {
        const MotionEstimate &next = estimates[i];
        MotionEstimate &now = estimates[i - 1];
        const double dt = track[i].timeS - track[i - 1].timeS;
        const Matrix6 f = transition(dt);
        const Matrix6 predicted =
            f * now.covariance * f.transpose() + processCovariance(dt, noise.jerkDensity);
        const Matrix6 gain = predicted.ldlt().solve(f * now.covariance).transpose();
        now.mean += gain * (next.mean - f * now.mean);
        const Matrix6 change = gain * (next.covariance - predicted) * gain.transpose();
        now.covariance += (change + change.transpose()) / 2;
    }
    return estimates;
}

namespace {

/// Twice the negative log likelihood and the scale that minimises it, for a ratio of jerk density to scale.
struct Likelihood
{
    double cost = 0;
    double scale = 1;
};

constexpr double priorInnovations = 10;
constexpr int startingInnovations = 2; // velocity and acceleration: still all ignorance, no information
constexpr std::size_t blockLength = 500, mostSamples = 20000;

struct Sums
{
    double distances = 0, logDeterminants = 0, count = 0;
};

void addInnovations(std::span<const TrackNode> track, double jerkDensity, bool robust, Sums &sums)
{
    MotionFilter filter({jerkDensity, 1});
    int taken = 0;
    for (const TrackNode &node : track) {
        if (!node.measured)
            continue;
        filter.predict(node.timeS);
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

Likelihood likelihood(std::span<const std::span<const TrackNode>> blocks, double jerkDensity, bool robust)
{
    Sums sums;
    for (const auto &block : blocks)
        addInnovations(block, jerkDensity, robust, sums);
    if (robust)
        return {sums.logDeterminants + sums.distances, 1};
    const double weight = 2 * (sums.count + priorInnovations);
    const double scale = (sums.distances + 2 * priorInnovations) / weight;
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

MotionNoise estimateMotionNoise(const std::vector<std::span<const TrackNode>> &segments, bool robust)
{
    const auto blocks = chooseBlocks(segments);
    const auto costAt = [&](double exponent) {
        return likelihood(blocks, std::pow(10.0, exponent), robust).cost;
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
    const double scale = likelihood(blocks, ratio, robust).scale;
    return {ratio * scale, scale};
}

} // namespace odo
