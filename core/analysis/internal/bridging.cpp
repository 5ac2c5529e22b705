// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/bridging.h"

#include "core/analysis/metrics.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double leastTimeToTopS = 0.5;

bool stoodBetween(const RunInstant &a, const RunInstant &b)
{
    return isAtRest(a) && isAtRest(b) && !isApart(a, b);
}

/// By how much the direction changes along it, to either side, radians.
double turnOf(const CubicPath &path)
{
    double turn = 0;
    Eigen::Vector2d before = path.velocity(0);
    for (int i = 1; i <= CubicPath::parts; ++i) {
        const Eigen::Vector2d now = path.velocity(double(i) / CubicPath::parts);
        turn += std::abs(std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now)));
        before = now;
    }
    return turn;
}

double largestAcceleration(const CubicPath &path)
{
    return std::max(std::hypot(path.x.accelerationFrom(), path.y.accelerationFrom()),
                    std::hypot(path.x.accelerationTo(), path.y.accelerationTo()));
}

/// The furthest that a robot comes in a time at whose end it stands.
double reachUntilStop(double speedMps, double timeS, const RobotLimits &limits)
{
    const double braking = speedMps / limits.accelMps2;
    if (timeS < braking)
        return -1;
    const double peak =
        std::min(std::max(limits.speedMps, speedMps), (timeS * limits.accelMps2 + speedMps) / 2);
    const double faster = (peak - speedMps) / limits.accelMps2, slower = peak / limits.accelMps2;
    return (speedMps + peak) / 2 * faster + peak * (timeS - faster - slower) + peak / 2 * slower;
}

bool canStopBetween(const RunInstant &a, const RunInstant &b, const RobotLimits &limits)
{
    constexpr int moments = 20;
    const double timeS = b.timeS - a.timeS, distance = distanceBetween(a, b) - 2 * sigmaOfDistance(a, b);
    for (int i = 0; i <= moments; ++i) {
        const double before = reachUntilStop(a.point->speedMps, timeS * i / moments, limits),
                     after = reachUntilStop(b.point->speedMps, timeS * (moments - i) / moments, limits);
        if (before >= 0 && after >= 0 && before + after >= distance)
            return true;
    }
    return false;
}

/// The length that the metrics give it: of the motion in it.
double lengthBetween(const std::vector<RunInstant> &instants, const BridgedStretch &stretch)
{
    return lengthOf(
        {stretch.first, stretch.last, instants[stretch.first].timeS, instants[stretch.last].timeS, 0, 0},
        instants);
}

double sigmaOfLength(const std::vector<RunInstant> &instants, const BridgedStretch &stretch,
                     const RobotLimits &limits)
{
    const RunInstant &a = instants[stretch.first], &b = instants[stretch.last];
    const CubicPath path(a, b);
    const double timeS = b.timeS - a.timeS, cubic = path.lengthM(), length = lengthBetween(instants, stretch);
    const double peak = std::min((limits.accelMps2 + largestAcceleration(path)) * timeS / 4, limits.speedMps);
    const double turning = turnOf(path) * peak * timeS / 4;
    const double aside =
        std::min(cubic > 0 ? peak * peak / 6 * timeS * timeS / cubic : peak * timeS / 2, peak * timeS / 2);
    const double longer = std::min(aside + turning, std::max(0.0, limits.speedMps * timeS - length)),
                 shorter = std::min(turning, std::max(0.0, length - distanceBetween(a, b)));
    return (std::max(longer, shorter) + std::abs(length - cubic)) / 2;
}

} // namespace

RobotLimits limitsOf(const std::vector<RunInstant> &instants)
{
    const double speed = largest(instants, speedCurve).point->speedMps;
    return {speed, std::max(largest(instants, accelCurve).point->accelMps2, speed / leastTimeToTopS)};
}

std::vector<Bridge> bridgesOf(const std::vector<RunInstant> &instants)
{
    std::vector<Bridge> bridges;
    const auto stretches = bridgedStretches(instants);
    if (stretches.empty())
        return bridges;
    const RobotLimits limits = limitsOf(instants);
    for (const BridgedStretch &stretch : stretches) {
        const RunInstant &a = instants[stretch.first], &b = instants[stretch.last];
        Bridge bridge{stretch, a.timeS, b.timeS};
        if (limits.speedMps > 0 && !stoodBetween(a, b)) {
            bridge.sigmaLengthM = sigmaOfLength(instants, stretch, limits);
            bridge.mayHaveStopped = canStopBetween(a, b, limits);
        }
        bridges.push_back(bridge);
    }
    return bridges;
}

SpeedRange meanSpeedRange(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                          double pathM, double durationS)
{
    double gapsS = 0, straightM = 0;
    for (std::size_t i = 1; i < instants.size(); ++i) {
        const RunInstant &a = instants[i - 1], &b = instants[i];
        const bool isWithin = i > motions.front().first && i <= motions.back().last;
        const bool isBeside = i == motions.front().first || i == motions.back().last + 1;
        if (b.joined || (!isWithin && !isBeside && !isApart(a, b)))
            continue;
        gapsS += b.timeS - a.timeS;
        straightM += distanceBetween(a, b);
        if (!isWithin)
            durationS += b.timeS - a.timeS;
    }
    const double topMps = largest(instants, speedCurve).point->speedMps;
    return {(pathM + straightM) / durationS, (pathM + std::max(straightM, topMps * gapsS)) / durationS};
}

bool mayBeLonger(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions)
{
    for (std::size_t i = 1; i < instants.size(); ++i) {
        if (instants[i].joined || (i > motions.front().first && i <= motions.back().last))
            continue;
        if (i == motions.front().first || i == motions.back().last + 1 ||
            isApart(instants[i - 1], instants[i]))
            return true;
    }
    return false;
}

double sigmaOfBridgedMoment(const std::vector<Bridge> &bridges, double timeS, int step)
{
    for (const Bridge &bridge : bridges) {
        if (timeS < bridge.fromS || timeS >= bridge.toS || bridge.sigmaLengthM <= 0)
            continue;
        const double standing = step > 0 ? timeS - bridge.fromS : bridge.toS - timeS,
                     moving = bridge.toS - bridge.fromS - standing;
        return std::max(standing, moving / 2) / 2;
    }
    return 0;
}

} // namespace odo
