// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/metrics.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double leastSpeedMps = 0.02;
constexpr double sigmasAboveRest = 3;
constexpr std::size_t shortestMotion = 3; // points

/// One valid point with its time.
struct Instant
{
    double timeS;
    const ProfilePoint *point;
    double thresholdMps;
    double commonSigmaM;
};

/// A stretch of motion: first and last instant above the threshold, and the interpolated moments of crossing
/// it.
struct Stretch
{
    std::size_t first, last;
    double startS, stopS;
};

std::vector<Instant> validInstants(const std::vector<Sample> &samples,
                                   const std::vector<ProfilePoint> &points)
{
    std::vector<Instant> instants;
    double commonSigma = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (samples[i].position && !isRejected(samples[i].flags))
            commonSigma = std::sqrt(std::max(0.0, samples[i].commonCovariance.trace() / 2));
        if (points[i].valid)
            instants.push_back({toSeconds(samples[i].time), &points[i],
                                std::max(leastSpeedMps, sigmasAboveRest * points[i].sigmaSpeedMps),
                                commonSigma});
    }
    return instants;
}

double excess(const Instant &instant)
{
    return instant.point->speedMps - instant.thresholdMps;
}

/// The moment between two neighbours where the speed crosses the threshold.
double crossing(const Instant &a, const Instant &b)
{
    const double from = excess(a), to = excess(b);
    const double fraction = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
    return a.timeS + fraction * (b.timeS - a.timeS);
}

std::vector<Stretch> findMotions(const std::vector<Instant> &instants)
{
    std::vector<Stretch> motions;
    for (std::size_t i = 0; i < instants.size();) {
        if (excess(instants[i]) <= 0) {
            ++i;
            continue;
        }
        std::size_t last = i;
        while (last + 1 < instants.size() && excess(instants[last + 1]) > 0)
            ++last;
        if (last + 1 - i >= shortestMotion) {
            const double start = i > 0 ? crossing(instants[i - 1], instants[i]) : instants[i].timeS;
            const double stop = last + 1 < instants.size() ? crossing(instants[last], instants[last + 1])
                                                           : instants[last].timeS;
            motions.push_back({i, last, start, stop});
        }
        i = last + 1;
    }
    return motions;
}

/// Integral of the speed from the moment of starting to that of stopping, by the trapezoidal rule; below the
/// threshold nothing is added but the ramp to it.
double pathOf(const Stretch &motion, const std::vector<Instant> &instants)
{
    const auto speed = [&](std::size_t i) { return instants[i].point->speedMps; };
    double path = 0;
    for (std::size_t i = motion.first; i < motion.last; ++i)
        path += (speed(i) + speed(i + 1)) / 2 * (instants[i + 1].timeS - instants[i].timeS);
    const Instant &first = instants[motion.first], &last = instants[motion.last];
    path += (first.thresholdMps + speed(motion.first)) / 2 * (first.timeS - motion.startS);
    path += (last.thresholdMps + speed(motion.last)) / 2 * (motion.stopS - last.timeS);
    return path;
}

double sigmaPosition(const Instant &instant)
{
    return std::sqrt((std::pow(instant.point->sigmaXM, 2) + std::pow(instant.point->sigmaYM, 2)) / 2);
}

/// σ of the moment of crossing the threshold: the speed's σ over its steepness, at most what the neighbours
/// leave open.
double sigmaMoment(const std::vector<Instant> &instants, std::size_t at)
{
    const Instant &instant = instants[at];
    const double steepness = std::max(instant.point->accelMps2, instant.point->sigmaAccelMps2);
    const double step = instants.size() < 2        ? 0.0
                        : at + 1 < instants.size() ? instants[at + 1].timeS - instant.timeS
                                                   : instant.timeS - instants[at - 1].timeS;
    const double resolution = step / std::sqrt(12.0);
    if (steepness <= 0)
        return resolution;
    return std::hypot(std::min(instant.point->sigmaSpeedMps / steepness, 10 * step), resolution);
}

struct RootMeanSquare
{
    double value = 0, sigma = 0;
};

RootMeanSquare rootMeanSquare(const std::vector<Instant> &instants, const std::vector<Stretch> &motions,
                              double ProfilePoint::*figure, double ProfilePoint::*sigma)
{
    double squares = 0, errors = 0, count = 0;
    for (const Stretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const ProfilePoint &point = *instants[i].point;
            squares += std::pow(point.*figure, 2);
            errors += std::abs(point.*figure) * point.*sigma;
            count += 1;
        }
    }
    if (count == 0 || squares == 0)
        return {};
    const double value = std::sqrt(squares / count);
    // Neighbours' errors go together: the bound for fully correlated ones.
    return {value, errors / count / value};
}

/// Where a figure is largest beyond doubt: by its value less twice its σ, so that a badly known point (at the
/// ends, in a gap) does not win by its error.
const Instant &largest(const std::vector<Instant> &instants, double ProfilePoint::*figure,
                       double ProfilePoint::*sigma)
{
    const auto sure = [&](const Instant &instant) {
        return instant.point->*figure - 2 * (instant.point->*sigma);
    };
    return *std::max_element(instants.begin(), instants.end(),
                             [&](const Instant &a, const Instant &b) { return sure(a) < sure(b); });
}

/// Relative error of scale that the calibration leaves: its σ at two places over their distance.
double sigmaScale(const std::vector<Instant> &instants)
{
    Eigen::Vector2d low = instants.front().point->position, high = low;
    double variance = 0;
    for (const Instant &instant : instants) {
        low = low.cwiseMin(instant.point->position);
        high = high.cwiseMax(instant.point->position);
        variance += instant.commonSigmaM * instant.commonSigmaM;
    }
    const double sigma = std::sqrt(2 * variance / static_cast<double>(instants.size()));
    // A robot that hardly moves says nothing of the scale: the error of a metre at most.
    return sigma / std::max(1.0, (high - low).norm());
}

} // namespace

std::vector<Metric> measureRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<Instant> instants = validInstants(samples, points);
    if (instants.empty())
        return {};
    const std::vector<Stretch> motions = findMotions(instants);
    const double scale = sigmaScale(instants);

    double duration = 0, path = 0, movingTime = 0, sigmaDuration = 0, sigmaPath = 0, chord = 0, sigmaEnds = 0;
    if (!motions.empty()) {
        const Stretch &first = motions.front(), &last = motions.back();
        duration = last.stopS - first.startS;
        sigmaDuration = std::hypot(sigmaMoment(instants, first.first), sigmaMoment(instants, last.last));
        for (const Stretch &motion : motions) {
            path += pathOf(motion, instants);
            movingTime += motion.stopS - motion.startS;
        }
        // An error of the path is, on a straight line, that of its two ends.
        sigmaEnds = std::hypot(sigmaPosition(instants[first.first]), sigmaPosition(instants[last.last]));
        sigmaPath = std::hypot(sigmaEnds, scale * path);
        chord = (instants[last.last].point->position - instants[first.first].point->position).norm();
    }
    const double meanSpeed = duration > 0 ? path / duration : 0;
    const double sigmaMean =
        duration > 0 ? std::hypot(sigmaPath / duration, meanSpeed * sigmaDuration / duration) : 0;
    const double straightness = path > 0 ? std::min(1.0, chord / path) : 0;
    const double sigmaStraight = path > 0 ? sigmaEnds * std::hypot(1.0, straightness) / path : 0;
    const Instant &fastest = largest(instants, &ProfilePoint::speedMps, &ProfilePoint::sigmaSpeedMps);
    const Instant &hardest = largest(instants, &ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2);
    const auto speed =
        rootMeanSquare(instants, motions, &ProfilePoint::speedMps, &ProfilePoint::sigmaSpeedMps);
    const auto accel =
        rootMeanSquare(instants, motions, &ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2);
    const double stops = motions.empty() ? 0 : static_cast<double>(motions.size() - 1);

    return {
        {"duration", "s", duration, sigmaDuration},
        {"path_length", "m", path, sigmaPath},
        {"mean_speed", "m/s", meanSpeed, sigmaMean},
        {"max_speed", "m/s", fastest.point->speedMps,
         std::hypot(fastest.point->sigmaSpeedMps, scale * fastest.point->speedMps)},
        {"rms_speed", "m/s", speed.value, speed.sigma},
        {"max_accel", "m/s²", hardest.point->accelMps2, hardest.point->sigmaAccelMps2},
        {"rms_accel", "m/s²", accel.value, accel.sigma},
        {"straightness", "1", straightness, sigmaStraight},
        {"moving_time", "s", movingTime, sigmaDuration},
        {"stops", "1", stops, std::nullopt},
    };
}

} // namespace odo
