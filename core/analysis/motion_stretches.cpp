// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/motion_stretches.h"

#include "core/analysis/internal/slow_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace odo {

namespace {

constexpr double sigmasAboveRest = 3;
constexpr std::size_t shortestMotion = 3; // points
constexpr double longestCorrelationS = 1;
constexpr double longestBridgedS = 1.5;
// Less without a measurement is not bridged: a robot hardly leaves its course in it.
constexpr double leastBridgedS = 0.1, leastBridgedSteps = 2.5;

double excess(const RunInstant &instant)
{
    return instant.point->speedMps - instant.thresholdMps;
}

/// Whether the robot went so far between two instants, by what is measured around them.
bool isTravel(const std::vector<RunInstant> &instants, std::size_t first, std::size_t last)
{
    while (first > 0 && !instants[first].measured && instants[first].joined)
        --first;
    while (last + 1 < instants.size() && !instants[last].measured && instants[last + 1].joined)
        ++last;
    return std::any_of(instants.begin() + static_cast<std::ptrdiff_t>(first),
                       instants.begin() + static_cast<std::ptrdiff_t>(last + 1),
                       [&](const RunInstant &instant) { return isApart(instants[first], instant); });
}

/// A bridged time without points.
bool isHole(const RunInstant &from, const RunInstant &to)
{
    return from.measured && to.joined && to.bridgedS > 0;
}

/// Bridged points are at rest where the measured ones around them would be: their own σ is that of a guess.
void adoptThreshold(std::vector<RunInstant> &instants)
{
    std::size_t first = instants.size() - 1;
    while (first > 0 && !instants[first - 1].measured && instants[first].joined)
        --first;
    const double before = first > 0 && instants[first].joined ? instants[first - 1].thresholdMps : 0;
    const double threshold = std::max(before, instants.back().thresholdMps);
    for (std::size_t i = first; i + 1 < instants.size(); ++i)
        instants[i].thresholdMps = threshold;
}

} // namespace

bool GapWatch::joins(double timeS)
{
    const double step = timeS - m_lastS;
    const bool isJoined =
        !m_skipped && (m_stepS == 0 || step <= std::max(longestBridgedS, bridgedIntervals * m_stepS));
    if (isJoined && step > 0) // a clock may stand still
        m_stepS = step;
    m_lastS = timeS;
    m_skipped = false;
    return isJoined;
}

void appendInstants(std::span<const Sample> samples, std::span<const ProfilePoint> points, RunState &state,
                    std::vector<RunInstant> &instants)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isUsed(samples[i]))
            state.commonSigmaM = std::sqrt(std::max(0.0, samples[i].commonCovariance.trace() / 2));
        if (!points[i].valid) {
            state.gaps.skip();
            continue;
        }
        const double timeS = toSeconds(samples[i].time);
        RunInstant instant{timeS,
                           &points[i],
                           sigmasAboveRest * points[i].sigmaSpeedMps,
                           state.commonSigmaM,
                           state.gaps.joins(timeS),
                           isUsed(samples[i])};
        if (instant.measured) {
            const double step = timeS - state.measuredS;
            if (instant.joined && state.stepS > 0 &&
                step > std::max(leastBridgedS, leastBridgedSteps * state.stepS)) {
                instant.bridgedS = step;
                state.stepS *= 2; // where that comes again and again it is the usual one
            } else if (instant.joined && step > 0) {
                state.stepS = step;
            }
            state.measuredS = timeS;
        }
        instants.push_back(instant);
        if (instant.measured)
            adoptThreshold(instants);
    }
}

std::vector<RunInstant> validInstants(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points)
{
    std::vector<RunInstant> instants;
    instants.reserve(points.size());
    RunState state;
    appendInstants(samples, points, state, instants);
    return instants;
}

std::vector<TimeSpan> gapsBetween(const std::vector<RunInstant> &instants)
{
    std::vector<TimeSpan> gaps;
    for (std::size_t i = 1; i < instants.size(); ++i)
        if (!instants[i].joined)
            gaps.push_back({fromSeconds(instants[i - 1].timeS), fromSeconds(instants[i].timeS)});
    return gaps;
}

void measureGaps(const std::vector<RunInstant> &instants, Profile &profile)
{
    profile.gaps = gapsBetween(instants);
    profile.measuredS = instants.empty() ? 0 : instants.back().timeS - instants.front().timeS;
    for (const TimeSpan &gap : profile.gaps)
        profile.measuredS -= toSeconds(gap.end - gap.begin);
}

namespace {

/// Where a stretch begins or ends.
struct MotionEnd
{
    std::size_t at = 0; ///< the outermost instant
    double timeS = 0, speedMps = 0;
};

/// The robot rests at the other end of a hole: it changed its speed evenly, as far as it came.
MotionEnd endInHole(const RunInstant &moving, const RunInstant &resting, std::size_t at)
{
    const double speed = moving.point->speedMps, distance = distanceBetween(moving, resting),
                 hole = resting.timeS - moving.timeS;
    const double lasts = std::min(std::abs(hole), 2 * distance / speed);
    if (!(lasts > 0))
        return {at, moving.timeS, speed};
    return {at, moving.timeS + std::copysign(lasts, hole), 2 * distance / lasts - speed};
}

/// From one instant of a stretch outwards (step −1 or 1), as long as the robot goes on: where its speed is
/// less sure, at half the speed it had there.
MotionEnd endOf(const std::vector<RunInstant> &instants, std::size_t at, int step, std::size_t limit)
{
    const Eigen::Vector2d velocity = instants[at].point->velocity;
    const double speed = velocity.norm();
    const auto along = [&](std::size_t i) { return instants[i].point->velocity.dot(velocity) / speed; };
    while (at != limit) {
        const std::size_t next = step < 0 ? at - 1 : at + 1;
        const RunInstant &later = instants[std::max(at, next)];
        if (!later.joined)
            break;
        if (isHole(instants[std::min(at, next)], later) && isAtRest(instants[next]))
            return endInHole(instants[at], instants[next], at);
        const double from = along(at), to = along(next),
                     least = std::min(speed / 2, instants[next].thresholdMps);
        if (to <= least) {
            const double part = from > to ? std::clamp((from - least) / (from - to), 0.0, 1.0) : 0.5;
            return {at, instants[at].timeS + part * (instants[next].timeS - instants[at].timeS), least};
        }
        at = next;
    }
    return {at, instants[at].timeS, instants[at].point->speedMps};
}

} // namespace

std::vector<MotionStretch> findMotions(const std::vector<RunInstant> &instants)
{
    std::vector<MotionStretch> motions;
    for (std::size_t i = 0; i < instants.size();) {
        if (isAtRest(instants[i])) {
            // It rests before and after a hole, but elsewhere.
            if (i + 1 < instants.size() && isHole(instants[i], instants[i + 1]) &&
                isAtRest(instants[i + 1]) && isApart(instants[i], instants[i + 1]))
                motions.push_back({i, i + 1, instants[i].timeS, instants[i + 1].timeS, 0, 0});
            ++i;
            continue;
        }
        std::size_t last = i;
        const auto goesOn = [&](std::size_t next) { return next < instants.size() && instants[next].joined; };
        while (goesOn(last + 1) && excess(instants[last + 1]) > 0)
            ++last;
        if (last + 1 - i >= shortestMotion && isTravel(instants, i, last)) {
            const MotionEnd start = endOf(instants, i, -1, motions.empty() ? 0 : motions.back().last + 1);
            const MotionEnd stop = endOf(instants, last, 1, instants.size() - 1);
            motions.push_back({start.at, stop.at, start.timeS, stop.timeS, start.speedMps, stop.speedMps});
            last = stop.at;
        }
        i = last + 1;
    }
    return withSlowMotions(instants, motions);
}

bool isAtRest(const RunInstant &instant)
{
    return excess(instant) <= 0;
}

double distanceBetween(const RunInstant &a, const RunInstant &b)
{
    return (a.point->position - b.point->position).norm();
}

double sigmaOfDistance(const RunInstant &a, const RunInstant &b)
{
    return std::hypot(ownSigmaOfPosition(a), ownSigmaOfPosition(b));
}

bool isApart(const RunInstant &from, const RunInstant &to)
{
    constexpr double sigmas = 4.5;
    return distanceBetween(from, to) > sigmas * sigmaOfDistance(from, to);
}

std::vector<BridgedStretch> bridgedStretches(const std::vector<RunInstant> &instants)
{
    std::vector<BridgedStretch> stretches;
    for (std::size_t last = 1; last < instants.size(); ++last) {
        if (instants[last].bridgedS <= 0)
            continue;
        std::size_t first = last - 1;
        while (first > 0 && !instants[first].measured)
            --first;
        stretches.push_back({first, last});
    }
    return stretches;
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
    const double speed = instant.point->sigmaSpeedMps;
    return speed > 0 ? std::min(longestCorrelationS,
                                std::sqrt(2 * std::numbers::pi) * ownSigmaOfPosition(instant) / speed)
                     : 0;
}

double sigmaOfPosition(const ProfilePoint &point)
{
    return std::sqrt((std::pow(point.sigmaXM, 2) + std::pow(point.sigmaYM, 2)) / 2);
}

double ownSigmaOfPosition(const RunInstant &instant)
{
    const double whole = sigmaOfPosition(*instant.point);
    return std::sqrt(std::max(0.0, whole * whole - instant.commonSigmaM * instant.commonSigmaM));
}

namespace {

/// How far it is from an end of a stretch to where the robot rests (step 1: behind its last instant; −1:
/// before its first), along its direction and on average over two seconds. A smoothed track swings where the
/// robot stops or starts hard, and its speed counts that; the swing itself is left out. nullopt: it does not
/// rest there for long enough.
std::optional<double> distanceToRest(const std::vector<RunInstant> &instants, std::size_t end, int step)
{
    constexpr double swingS = 0.3, longestS = 2, fewest = 3;
    const RunInstant &moving = instants[end];
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0;
    for (std::size_t at = end; step > 0 ? at + 1 < instants.size() : at > 0;) {
        const std::size_t next = step > 0 ? at + 1 : at - 1;
        const RunInstant &later = instants[std::max(at, next)], &resting = instants[next];
        if (!later.joined || later.bridgedS > 0 || !resting.measured || !isAtRest(resting) ||
            std::abs(resting.timeS - moving.timeS) > longestS)
            break;
        if (std::abs(resting.timeS - moving.timeS) >= swingS) {
            sum += resting.point->position - moving.point->position;
            count += 1;
        }
        at = next;
    }
    const double speed = moving.point->velocity.norm();
    if (count < fewest || !(speed > 0))
        return std::nullopt;
    return step * sum.dot(moving.point->velocity) / (count * speed);
}

} // namespace

std::vector<double> distancesOf(const MotionStretch &motion, const std::vector<RunInstant> &instants)
{
    if (auto slow = slowDistances(instants, motion))
        return *std::move(slow);
    const auto speed = [&](std::size_t i) { return instants[i].point->speedMps; };
    const RunInstant &first = instants[motion.first];
    double distance =
        distanceToRest(instants, motion.first, -1)
            .value_or((motion.startMps + speed(motion.first)) / 2 * (first.timeS - motion.startS));
    std::vector<double> distances{std::max(0.0, distance)};
    for (std::size_t i = motion.first; i < motion.last; ++i) {
        distance += isHole(instants[i], instants[i + 1])
                        ? CubicPath(instants[i], instants[i + 1]).lengthM()
                        : (speed(i) + speed(i + 1)) / 2 * (instants[i + 1].timeS - instants[i].timeS);
        distances.push_back(std::max(0.0, distance));
    }
    return distances;
}

double lengthOf(const MotionStretch &motion, const std::vector<RunInstant> &instants)
{
    const RunInstant &last = instants[motion.last];
    const double ramp = (motion.stopMps + last.point->speedMps) / 2 * (motion.stopS - last.timeS);
    return std::max(0.0, distancesOf(motion, instants).back() +
                             distanceToRest(instants, motion.last, 1).value_or(ramp));
}

std::vector<double> distanceTravelled(const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points)
{
    std::vector<double> distances(samples.size(), 0);
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const auto sampleOf = [&](std::size_t instant) {
        return static_cast<std::size_t>(instants[instant].point - points.data());
    };
    double before = 0;
    std::size_t next = 0; // first sample whose way is not set
    for (const MotionStretch &motion : findMotions(instants)) {
        std::vector<double> own = distancesOf(motion, instants);
        const double whole = lengthOf(motion, instants);
        for (double &distance : own)
            distance = std::min(distance, whole);
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const std::size_t sample = sampleOf(i);
            // A point that is not valid has the distance of the one before it.
            std::fill(distances.begin() + static_cast<std::ptrdiff_t>(next),
                      distances.begin() + static_cast<std::ptrdiff_t>(sample),
                      i > motion.first ? before + own[i - 1 - motion.first] : before);
            distances[sample] = before + own[i - motion.first];
            next = sample + 1;
        }
        before += whole;
    }
    std::fill(distances.begin() + static_cast<std::ptrdiff_t>(next), distances.end(), before);
    return distances;
}

namespace {

double correlationOf(const Sample &sample)
{
    const double product = sample.covariance(0, 0) * sample.covariance(1, 1);
    return sample.position && product > 0
               ? std::clamp(sample.covariance(0, 1) / std::sqrt(product), -1.0, 1.0)
               : 0;
}

} // namespace

std::vector<MeasuredPosition> measuredPositions(const std::vector<Sample> &samples,
                                                const std::vector<ProfilePoint> &points)
{
    std::vector<MeasuredPosition> positions;
    Eigen::Matrix2d common = Eigen::Matrix2d::Zero(); // of the last used sample
    GapWatch gaps;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isUsed(samples[i]))
            common = samples[i].commonCovariance;
        if (!points[i].valid) {
            gaps.skip();
            continue;
        }
        MeasuredPosition measured;
        measured.timeS = toSeconds(samples[i].time);
        measured.point = &points[i];
        measured.common = common;
        const double x = std::max(0.0, std::pow(points[i].sigmaXM, 2) - common(0, 0));
        const double y = std::max(0.0, std::pow(points[i].sigmaYM, 2) - common(1, 1));
        const double both = correlationOf(samples[i]) * std::sqrt(x * y);
        measured.own << x, both, both, y;
        measured.joined = gaps.joins(measured.timeS);
        positions.push_back(measured);
    }
    return positions;
}

CubicPath::CubicPath(const RunInstant &from, const RunInstant &to)
{
    const ProfilePoint &a = *from.point, &b = *to.point;
    const double stepS = to.timeS - from.timeS;
    x = {a.position.x(), b.position.x(), a.velocity.x(), b.velocity.x(), stepS};
    y = {a.position.y(), b.position.y(), a.velocity.y(), b.velocity.y(), stepS};
}

double CubicPath::lengthM() const
{
    double length = 0;
    for (int i = 0; i < parts; ++i)
        length += velocity((i + 0.5) / parts).norm() * x.stepS / parts;
    return length;
}

double sigmaAlong(const Eigen::Matrix2d &covariance, const Eigen::Vector2d &direction)
{
    return std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
}

} // namespace odo
