// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/derived_curves.h"

#include "core/analysis/curve_fit.h"
#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Values = std::vector<std::optional<CurveValue>>;

std::size_t sampleOf(const Profile &profile, const RunInstant &instant)
{
    return static_cast<std::size_t>(instant.point - profile.points.data());
}

/// ω₀ of the errors between two instants.
double rateBetween(const RunInstant &a, const RunInstant &b)
{
    return (errorRate(ownSigmaOfPosition(a), a.point->sigmaSpeedMps) +
            errorRate(ownSigmaOfPosition(b), b.point->sigmaSpeedMps)) /
           2;
}

/// The instant that is half of jerkSpanS or more away, in one direction, without a gap between; nullptr:
/// none.
const RunInstant *instantApart(const std::vector<RunInstant> &instants, std::size_t at, int step)
{
    constexpr double half = jerkSpanS / 2 * (1 - 1e-9); // times are rounded to nanoseconds
    for (std::size_t i = at;;) {
        if (std::abs(instants[i].timeS - instants[at].timeS) >= half)
            return &instants[i];
        const bool isEnd =
            step < 0 ? i == 0 || !instants[i].joined : i + 1 == instants.size() || !instants[i + 1].joined;
        if (isEnd)
            return nullptr;
        i = step < 0 ? i - 1 : i + 1;
    }
}

} // namespace

std::optional<CurveValue> lateralAccelerationOf(const ProfilePoint &point)
{
    const auto course = courseOf(point);
    if (!course)
        return std::nullopt;
    const double speed = point.velocity.norm();
    const double along = point.acceleration.dot(point.velocity) / speed;
    return CurveValue{course->turnRateRadps * speed,
                      std::hypot(point.sigmaAccelMps2, along * course->sigmaHeadingRad)};
}

Values jerkValues(const Profile &profile)
{
    Values values(profile.points.size());
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const RunInstant *before = instantApart(instants, i, -1), *after = instantApart(instants, i, 1);
        if (!before || !after)
            continue;
        const double time = after->timeS - before->timeS, speed = instants[i].point->velocity.norm();
        const Eigen::Vector2d jerk = (after->point->acceleration - before->point->acceleration) / time;
        const bool isMoving = courseOf(*instants[i].point).has_value();
        const double a = before->point->sigmaAccelMps2, b = after->point->sigmaAccelMps2;
        const double together =
            errorCorrelation(ErrorCourse::Acceleration, rateBetween(*before, *after) * time);
        values[sampleOf(profile, instants[i])] = {
            isMoving ? jerk.dot(instants[i].point->velocity) / speed : jerk.norm(),
            std::sqrt(std::max(0.0, a * a + b * b - 2 * together * a * b)) / time};
    }
    return values;
}

Values distanceValues(const Profile &profile)
{
    Values values(profile.points.size());
    const std::vector<double> distances = distanceTravelled(profile.samples, profile.points);
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    const double scale = sigmaOfScale(profile.samples, profile.points);
    double whole = 0; // variance of all that is behind
    std::size_t next = 0;
    const auto setUntil = [&](std::size_t end, double variance) {
        for (; next < end; ++next) {
            const std::size_t sample = sampleOf(profile, instants[next]);
            values[sample] = {distances[sample], std::hypot(std::sqrt(variance), scale * distances[sample])};
        }
    };
    for (const MotionStretch &motion : findMotions(instants)) {
        setUntil(motion.first, whole);
        double turning = 0;
        const double start = std::pow(ownSigmaOfPosition(instants[motion.first]), 2);
        const auto variance = [&](std::size_t i) {
            return whole + start + std::pow(ownSigmaOfPosition(instants[i]), 2) + turning;
        };
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const auto course = courseOf(*instants[i].point);
            if (i > motion.first && course) // errors across a path that turns make it longer or shorter
                turning += std::pow(course->turnRateRadps * ownSigmaOfPosition(instants[i]), 2) *
                           std::max(0.0, instants[i].timeS - instants[i - 1].timeS) *
                           correlationTimeS(instants[i]);
            setUntil(i + 1, variance(i));
        }
        whole = variance(motion.last);
    }
    setUntil(instants.size(), whole);
    return values;
}

Values displacementValues(const Profile &profile)
{
    Values values(profile.points.size());
    const std::vector<MeasuredPosition> positions = measuredPositions(profile.samples, profile.points);
    if (positions.empty())
        return values;
    const MeasuredPosition &start = positions.front();
    const double scale = sigmaOfScale(profile.samples, profile.points);
    for (const MeasuredPosition &each : positions) {
        const Eigen::Vector2d offset = each.point->position - start.point->position;
        const double distance = offset.norm();
        const Eigen::Vector2d along =
            distance > 0 ? Eigen::Vector2d(offset / distance) : Eigen::Vector2d::UnitX();
        const double own = &each == &start ? 0.0 : std::sqrt(along.dot((each.own + start.own) * along));
        values[static_cast<std::size_t>(each.point - profile.points.data())] = {
            distance, std::hypot(own, scale * distance)};
    }
    return values;
}

namespace {

/// Where a robot is at a time, and its own covariance; nullopt: not measured then.
struct Located
{
    Eigen::Vector2d position;
    Eigen::Matrix2d own;
};
std::optional<Located> locatedAt(const std::vector<MeasuredPosition> &positions, double timeS)
{
    const auto after = std::ranges::lower_bound(positions, timeS, {}, &MeasuredPosition::timeS);
    if (after == positions.end())
        return std::nullopt;
    if (after->timeS == timeS)
        return Located{after->point->position, after->own};
    if (after == positions.begin() || !after->joined)
        return std::nullopt;
    const MeasuredPosition &before = *(after - 1);
    const double share = (timeS - before.timeS) / (after->timeS - before.timeS);
    // Neighbours of a smoothed track share their error: between them it is no smaller.
    return Located{(1 - share) * before.point->position + share * after->point->position,
                   (1 - share) * before.own + share * after->own};
}

} // namespace

Values separationValues(const Profile &profile, OtherProfiles others)
{
    Values values(profile.points.size());
    std::vector<std::vector<MeasuredPosition>> tracks;
    for (const Profile *other : others)
        tracks.push_back(measuredPositions(other->samples, other->points));
    const double scale = sigmaOfScale(profile.samples, profile.points);
    for (const MeasuredPosition &each : measuredPositions(profile.samples, profile.points)) {
        auto &value = values[static_cast<std::size_t>(each.point - profile.points.data())];
        for (const std::vector<MeasuredPosition> &track : tracks) {
            const auto other = locatedAt(track, each.timeS);
            if (!other)
                continue;
            const Eigen::Vector2d offset = other->position - each.point->position;
            const double distance = offset.norm();
            if (value && value->value <= distance)
                continue;
            const Eigen::Vector2d along =
                distance > 0 ? Eigen::Vector2d(offset / distance) : Eigen::Vector2d::UnitX();
            value = CurveValue{distance, std::hypot(std::sqrt(along.dot((each.own + other->own) * along)),
                                                    scale * distance)};
        }
    }
    return values;
}

} // namespace odo
