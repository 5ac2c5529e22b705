// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/motion_stretches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double sigmasAboveRest = 3;
constexpr std::size_t shortestMotion = 3; // points
constexpr double longestCorrelationS = 1;

double excess(const RunInstant &instant)
{
    return instant.point->speedMps - instant.thresholdMps;
}

/// The moment between two neighbours where the speed crosses the threshold.
double crossing(const RunInstant &a, const RunInstant &b)
{
    const double from = excess(a), to = excess(b);
    const double fraction = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
    return a.timeS + fraction * (b.timeS - a.timeS);
}

} // namespace

void appendInstants(std::span<const Sample> samples, std::span<const ProfilePoint> points, double &commonSigmaM,
                    std::vector<RunInstant> &instants)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (samples[i].position && !isRejected(samples[i].flags))
            commonSigmaM = std::sqrt(std::max(0.0, samples[i].commonCovariance.trace() / 2));
        if (points[i].valid)
            instants.push_back({toSeconds(samples[i].time), &points[i],
                                std::max(leastMovingMps, sigmasAboveRest * points[i].sigmaSpeedMps),
                                commonSigmaM});
    }
}

std::vector<RunInstant> validInstants(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points)
{
    std::vector<RunInstant> instants;
    instants.reserve(points.size());
    double commonSigmaM = 0;
    appendInstants(samples, points, commonSigmaM, instants);
    return instants;
}

std::vector<MotionStretch> findMotions(const std::vector<RunInstant> &instants)
{
    std::vector<MotionStretch> motions;
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

double sigmaOfMoment(const std::vector<RunInstant> &instants, std::size_t at)
{
    const RunInstant &instant = instants[at];
    const double steepness = std::max(instant.point->accelMps2, instant.point->sigmaAccelMps2);
    const double step = instants.size() < 2        ? 0.0
                        : at + 1 < instants.size() ? instants[at + 1].timeS - instant.timeS
                                                   : instant.timeS - instants[at - 1].timeS;
    if (steepness <= 0)
        return step;
    return std::min(instant.point->sigmaSpeedMps / steepness, 10 * step);
}

double correlationTimeS(const RunInstant &instant)
{
    const double position = sigmaOfPosition(*instant.point);
    const double own =
        std::sqrt(std::max(0.0, position * position - instant.commonSigmaM * instant.commonSigmaM));
    const double speed = instant.point->sigmaSpeedMps;
    return speed > 0 ? std::min(longestCorrelationS, std::sqrt(2 * std::numbers::pi) * own / speed) : 0;
}

double sigmaOfPosition(const ProfilePoint &point)
{
    return std::sqrt((std::pow(point.sigmaXM, 2) + std::pow(point.sigmaYM, 2)) / 2);
}

} // namespace odo
