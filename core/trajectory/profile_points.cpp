// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/profile_points.h"

#include "core/trajectory/local_derivatives.h"

#include <cmath>

namespace odo {

double sigmaOfLength(const Eigen::Vector2d &vector, const Eigen::Matrix2d &covariance)
{
    const double trace = covariance.trace();
    if (!(trace > 0))
        return 0;
    return std::sqrt((vector.dot(covariance * vector) + trace * trace / 2) /
                     (vector.squaredNorm() + trace / 2));
}

ProfilePoint makePoint(const MotionEstimate &estimate, const Eigen::Matrix2d &commonCovariance)
{
    ProfilePoint point;
    point.position = estimate.position();
    point.velocity = estimate.velocity();
    point.acceleration = estimate.acceleration();
    point.sigmaXM = std::sqrt(std::max(0.0, estimate.covariance(0, 0) + commonCovariance(0, 0)));
    point.sigmaYM = std::sqrt(std::max(0.0, estimate.covariance(1, 1) + commonCovariance(1, 1)));
    point.speedMps = point.velocity.norm();
    point.sigmaSpeedMps = sigmaOfLength(point.velocity, estimate.covariance.block<2, 2>(2, 2));
    point.accelMps2 = point.acceleration.norm();
    point.sigmaAccelMps2 = sigmaOfLength(point.acceleration, estimate.covariance.block<2, 2>(4, 4));
    point.valid = true;
    return point;
}

namespace {

ProfilePoint emptyPoint()
{
    ProfilePoint point;
    point.position.setZero();
    point.velocity.setZero();
    point.acceleration.setZero();
    return point;
}

/// Gives the estimate at each node's time, where there is one.
void estimate(const TrackSegment &segment, Smoother smoother, MotionNoise noise, const TakeEstimate &take)
{
    if (smoother == Smoother::Rts) {
        if (segment.measured >= 3)
            smoothMotion(segment.nodes, noise, take);
        return;
    }
    const auto derive = smoother == Smoother::SavGol    ? savitzkyGolay
                        : smoother == Smoother::Tracker ? trackerDifferences
                                                        : rawDifferences;
    for (std::size_t i = 0; i < segment.nodes.size(); ++i) {
        if (const auto derived = derive(segment.nodes, i, noise.measurementScale))
            take(i, *derived);
    }
}

/// The calibration's part for a bridged sample is that of the nearest measured one before it.
const Eigen::Matrix2d &commonPart(const std::vector<Sample> &samples, const TrackSegment &segment,
                                  std::size_t i)
{
    while (!segment.nodes[i].measured)
        --i;
    return samples[segment.first + i].commonCovariance;
}

} // namespace

std::vector<ProfilePoint> makePoints(std::vector<Sample> &samples, const std::vector<bool> &struck,
                                     const AnalysisOptions &options, MotionNoise noise)
{
    std::vector<ProfilePoint> points(samples.size(), emptyPoint());
    for (Sample &sample : samples)
        sample.flags &= ~flagBit(SampleFlag::Interpolated);
    auto segments = cutIntoSegments(samples, options.longestBridgedGap);
    markBlows(segments, struck);
    for (const TrackSegment &segment : segments) {
        estimate(segment, options.smoother, noise, [&](std::size_t i, const MotionEstimate &one) {
            if (!one.mean.allFinite() || !one.covariance.allFinite())
                return;
            points[segment.first + i] = makePoint(one, commonPart(samples, segment, i));
            if (!segment.nodes[i].measured)
                samples[segment.first + i].flags |= flagBit(SampleFlag::Interpolated);
        });
    }
    return points;
}

} // namespace odo
