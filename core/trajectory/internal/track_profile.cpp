// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/track_profile.h"

#include "core/analysis/metrics.h"
#include "core/analysis/task_metrics.h"
#include "core/trajectory/internal/heading_curve.h"
#include "core/trajectory/internal/spike_flags.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastSamples = 3; // an acceleration needs three positions
constexpr double longestUnseenS = 0.2;  // of the ends: a few frames

/// Whether the robot moves when it is measured last, or first, and there are frames for a while beyond: what
/// it did then can only add to the metrics.
bool isMovingUnseen(const std::vector<Sample> &samples, const std::vector<RunInstant> &instants)
{
    const double firstS = toSeconds(samples.front().time), lastS = toSeconds(samples.back().time);
    const double longestS =
        std::max(longestUnseenS, bridgedIntervals * (lastS - firstS) / double(samples.size()));
    return (!isAtRest(instants.back()) && lastS - instants.back().timeS > longestS) ||
           (!isAtRest(instants.front()) && instants.front().timeS - firstS > longestS);
}

/// The error of the point that stands for the robot turns with the body: at a rate ω it is one of ωσ of the
/// velocity, and of ω²σ of the acceleration.
void addTurningErrors(const std::vector<Sample> &samples, std::vector<ProfilePoint> &points)
{
    double variance = 0; // of each direction; in a gap that of the sample before it
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (samples[i].position)
            variance = samples[i].commonCovariance.trace() / 2;
        ProfilePoint &point = points[i];
        if (!point.valid || !point.body)
            continue;
        const double rate = point.body->turnRateRadps, sigma = std::sqrt(variance);
        point.sigmaSpeedMps = std::hypot(point.sigmaSpeedMps, rate * sigma);
        point.sigmaAccelMps2 = std::hypot(point.sigmaAccelMps2, rate * rate * sigma);
    }
}

} // namespace

Message cannotMeasurePath()
{
    return ODO_TEXT("trajectory.path_not_measured", "the robot's path cannot be measured");
}

tl::unexpected<Error> notEnoughData(std::size_t frames, std::size_t used, Message advice)
{
    return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                joined({ODO_TEXT("trajectory.not_enough_data", "not enough data"),
                        ODO_TEXT("trajectory.frames_that_tell",
                                 "only %2 of %1 frames give a usable position")(frames, used)},
                       Join::Colon),
                std::move(advice));
}

Result<Profile> profileOfTrack(FusedTrack track, const AnalysisOptions &options,
                               const MeasurementNoise &measurement)
{
    const SpikeVerdict verdict = flagSpikes(track.samples, options, measurement);
    Profile profile;
    profile.points = makePoints(track.samples, verdict.changes, options, verdict.noise);
    smoothHeadings(track.samples, options.longestBridgedGap, profile.points);
    addTurningErrors(track.samples, profile.points);
    const auto used = static_cast<std::size_t>(
        std::count_if(track.samples.begin(), track.samples.end(),
                      [](const Sample &sample) { return sample.position && !isRejected(sample.flags); }));
    const bool anyValid = std::any_of(profile.points.begin(), profile.points.end(),
                                      [](const ProfilePoint &point) { return point.valid; });
    if (used < leastSamples || !anyValid)
        return notEnoughData(track.samples.size(), used,
                             ODO_TEXT("trajectory.choose_longer_video",
                                      "choose a longer video, or check the robot's colour and the light"));
    profile.spikes = describeSpikes(track, profile.points, options.longestBridgedGap);
    const std::vector<RunInstant> instants = validInstants(track.samples, profile.points);
    profile.metrics = measureRun(instants);
    measureGaps(instants, profile);
    const bool isUnseen =
        isMovingUnseen(track.samples, instants) || std::ranges::any_of(track.samples, &Sample::isAfterBreak);
    if (options.task) {
        TaskMetrics metrics = measureTask(*options.task, track.samples, profile.points);
        profile.passages = std::move(metrics.passages);
        profile.metrics.insert(profile.metrics.end(), metrics.metrics.begin(), metrics.metrics.end());
    }
    if (isUnseen) {
        markLowerBounds(profile.metrics, {TimeSpan{track.samples.front().time, track.samples.back().time}});
        std::ranges::find(profile.metrics, "duration", &Metric::name)->isAtLeast = true;
    }
    profile.samples = std::move(track.samples);
    return profile;
}

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

std::vector<ProfilePoint> makePoints(std::vector<Sample> &samples, const std::vector<MotionChange> &changes,
                                     const AnalysisOptions &options, MotionNoise noise)
{
    std::vector<ProfilePoint> points(samples.size(), emptyPoint());
    for (Sample &sample : samples)
        sample.flags &= ~flagBit(SampleFlag::Interpolated);
    auto segments = cutIntoSegments(samples, options.longestBridgedGap);
    markChanges(segments, changes);
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

namespace {

constexpr std::size_t windowNodes = 11;
constexpr std::size_t coefficients = 4; // of a cubic

/// Rows: weights of position, velocity, acceleration; columns: the neighbours.
using Weights = Eigen::Matrix<double, 3, Eigen::Dynamic>;

MotionEstimate weightedSum(std::span<const TrackNode> track, const std::vector<std::size_t> &neighbours,
                           const Weights &weights, double scale)
{
    MotionEstimate estimate;
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
        const TrackNode &node = track[neighbours[n]];
        const Eigen::Vector3d w = weights.col(static_cast<Eigen::Index>(n));
        for (int row = 0; row < 3; ++row) {
            estimate.mean.segment<2>(2 * row) += w[row] * node.position;
            for (int column = 0; column < 3; ++column)
                estimate.covariance.block<2, 2>(2 * row, 2 * column) +=
                    w[row] * w[column] * scale * node.covariance;
        }
    }
    return estimate;
}

/// The measured nodes nearest to index, at most `windowNodes`, in order.
std::vector<std::size_t> nearestMeasured(std::span<const TrackNode> track, std::size_t index)
{
    std::vector<std::size_t> chosen;
    std::size_t left = index, right = index + 1; // next to look at: left - 1 and right
    if (track[index].measured)
        chosen.push_back(index);
    while (chosen.size() < windowNodes && (left > 0 || right < track.size())) {
        // In turn from both sides, so that the window stays centred away from the ends.
        const std::size_t toLeft = index - left, toRight = right - index - 1;
        const bool goLeft = left > 0 && (right >= track.size() || toLeft <= toRight);
        const std::size_t next = goLeft ? --left : right++;
        if (track[next].measured)
            chosen.push_back(next);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

/// True when the nodes index + from ... index + to exist and are measured.
bool allMeasured(std::span<const TrackNode> track, std::size_t index, std::size_t before, std::size_t behind)
{
    if (index < before || index + behind >= track.size())
        return false;
    return std::all_of(track.begin() + static_cast<std::ptrdiff_t>(index - before),
                       track.begin() + static_cast<std::ptrdiff_t>(index + behind + 1),
                       [](const TrackNode &node) { return node.measured; });
}

} // namespace

std::optional<MotionEstimate> savitzkyGolay(std::span<const TrackNode> track, std::size_t index, double scale)
{
    const auto neighbours = nearestMeasured(track, index);
    if (neighbours.size() < coefficients)
        return std::nullopt;
    const double middle = track[index].timeS;
    const double span = track[neighbours.back()].timeS - track[neighbours.front()].timeS;
    // In units of the window's length, so that the powers are of one size.
    Eigen::MatrixXd powers(neighbours.size(), coefficients);
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
        const double u = (track[neighbours[n]].timeS - middle) / span;
        powers.row(static_cast<Eigen::Index>(n)) << 1, u, u * u, u * u * u;
    }
    const Eigen::MatrixXd fit =
        powers.householderQr().solve(Eigen::MatrixXd::Identity(powers.rows(), powers.rows()));
    Weights weights(3, powers.rows());
    weights.row(0) = fit.row(0);
    weights.row(1) = fit.row(1) / span;
    weights.row(2) = 2 * fit.row(2) / (span * span);
    return weightedSum(track, neighbours, weights, scale);
}

std::optional<MotionEstimate> trackerDifferences(std::span<const TrackNode> track, std::size_t index,
                                                 double scale)
{
    if (!allMeasured(track, index, 2, 2))
        return std::nullopt;
    const double twoSteps = track[index + 1].timeS - track[index - 1].timeS;
    const double step = (track[index + 2].timeS - track[index - 2].timeS) / 4;
    Weights weights(3, 5);
    weights.row(0) << 0, 0, 1, 0, 0;
    weights.row(1) << 0, -1, 0, 1, 0;
    weights.row(1) /= twoSteps;
    weights.row(2) << 2, -1, -2, -1, 2;
    weights.row(2) /= 7 * step * step;
    return weightedSum(track, {index - 2, index - 1, index, index + 1, index + 2}, weights, scale);
}

std::optional<MotionEstimate> rawDifferences(std::span<const TrackNode> track, std::size_t index,
                                             double scale)
{
    if (!allMeasured(track, index, 2, 0))
        return std::nullopt;
    const double last = track[index].timeS - track[index - 1].timeS;
    const double before = track[index - 1].timeS - track[index - 2].timeS;
    Weights weights(3, 3);
    weights.row(0) << 0, 0, 1;
    weights.row(1) << 0, -1 / last, 1 / last;
    weights.row(2) << 1 / before, -1 / before - 1 / last, 1 / last;
    weights.row(2) /= last;
    return weightedSum(track, {index - 2, index - 1, index}, weights, scale);
}

} // namespace odo
