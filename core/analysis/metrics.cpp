// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"

#include "core/analysis/internal/bridging.h"
#include "core/analysis/metric_table.h"
#include "core/analysis/motion_stretches.h"
#include "core/analysis/quantity_curve.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

namespace odo {

namespace {

constexpr double sigmasOfLargest = 3; // of a hundred values one is off by nearly as much

/// What a value surely exceeds: by this the largest of several is chosen.
double leastOf(const UncertainValue &value)
{
    return value.value - sigmasOfLargest * value.sigma;
}

/// How far the instants at rest next to a stretch lie from the first of them, mean square: step by step (−1
/// or 1) as far as `end`. After a hard stop a smoothed track swings, and by so much its end is in doubt.
double wanderOf(const std::vector<RunInstant> &instants, std::size_t at, int step, std::size_t end)
{
    constexpr double longestS = 1;
    const RunInstant *place = nullptr;
    double squares = 0, count = 0;
    while (at != end && instants[step < 0 ? at : at + 1].joined) {
        at = step < 0 ? at - 1 : at + 1;
        if (!place)
            place = &instants[at];
        if (std::abs(instants[at].timeS - place->timeS) > longestS)
            break;
        squares += (instants[at].point->position - place->point->position).squaredNorm() -
                   2 * std::pow(ownSigmaOfPosition(instants[at]), 2);
        count += 1;
    }
    return count > 0 ? std::max(0.0, squares / count) : 0;
}

/// σ of the length of a stretch: of its two ends, and ∫ω·e dt of the error e across a path that turns at ω.
double sigmaOfLengthOf(const std::vector<MotionStretch> &motions, std::size_t which,
                       const std::vector<RunInstant> &instants)
{
    const MotionStretch &motion = motions[which];
    double variance = std::pow(sigmaOfPosition(*instants[motion.first].point), 2) +
                      std::pow(sigmaOfPosition(*instants[motion.last].point), 2) +
                      wanderOf(instants, motion.first, -1, which > 0 ? motions[which - 1].last : 0) +
                      wanderOf(instants, motion.last, 1,
                               which + 1 < motions.size() ? motions[which + 1].first : instants.size() - 1);
    for (std::size_t i = motion.first + 1; i <= motion.last; ++i) {
        const auto course = courseOf(*instants[i].point);
        if (!course)
            continue;
        // a clock may stand still
        const double step = std::max(0.0, instants[i].timeS - instants[i - 1].timeS);
        variance += std::pow(course->turnRateRadps * sigmaOfPosition(*instants[i].point), 2) * step *
                    correlationTimeS(instants[i]);
    }
    return std::sqrt(variance);
}

/// Relative scale uncertainty of the calibration: its σ at two positions over their distance.
double sigmaScale(const std::vector<RunInstant> &instants)
{
    Eigen::Vector2d low = instants.front().point->position, high = low;
    double variance = 0;
    for (const RunInstant &instant : instants) {
        low = low.cwiseMin(instant.point->position);
        high = high.cwiseMax(instant.point->position);
        variance += instant.commonSigmaM * instant.commonSigmaM;
    }
    const double sigma = std::sqrt(2 * variance / static_cast<double>(instants.size()));
    // A robot that hardly moves says nothing of the scale: the error of a metre at most.
    return sigma / std::max(1.0, (high - low).norm());
}

/// Seconds of the gaps between two instants.
double gapTimeS(const std::vector<RunInstant> &instants, std::size_t from, std::size_t to)
{
    double timeS = 0;
    for (std::size_t i = from + 1; i <= to; ++i)
        if (!instants[i].joined)
            timeS += instants[i].timeS - instants[i - 1].timeS;
    return timeS;
}

/// Whether the robot was seen to stand between two motions. Bridged points show none: it stood where a
/// measured one is among them.
bool isStop(const std::vector<RunInstant> &instants, const MotionStretch &before, const MotionStretch &after)
{
    bool isBridged = false, isSeen = false;
    for (std::size_t i = before.last + 1; i <= after.first; ++i) {
        if (!instants[i].joined)
            return false;
        isBridged = isBridged || !instants[i].measured || instants[i].bridgedS > 0;
        isSeen = isSeen || (i < after.first && instants[i].measured && isAtRest(instants[i]));
    }
    return isSeen || !isBridged || before.last == after.first;
}

/// σ of the moment of an end of a motion. A smoothed speed begins to rise before the robot starts: 175
/// simulated runs have an error of 0.15 of the time for which its errors go together.
double sigmaOfEnd(const std::vector<RunInstant> &instants, std::size_t at)
{
    constexpr double blurred = 0.15;
    return std::hypot(sigmaOfMoment(instants, at), blurred * correlationTimeS(instants[at]));
}

/// Length, times and what hangs on both, of what was measured; the duration alone goes on through gaps.
void addCourse(std::vector<Metric> &metrics, const std::vector<RunInstant> &instants,
               const std::vector<MotionStretch> &motions, double scale)
{
    const std::vector<Bridge> bridges = bridgesOf(instants);
    const bool mayHaveStopped = std::ranges::any_of(bridges, &Bridge::mayHaveStopped);
    double duration = 0, measured = 0, path = 0, movingTime = 0, sigmaDuration = 0, sigmaPath = 0, chord = 0,
           sigmaEnds = 0, stops = 0;
    if (!motions.empty()) {
        const MotionStretch &first = motions.front(), &last = motions.back();
        duration = last.stopS - first.startS;
        measured = duration - gapTimeS(instants, first.first, last.last);
        for (std::size_t i = 1; i < motions.size(); ++i)
            stops += isStop(instants, motions[i - 1], motions[i]);
        sigmaDuration = std::hypot(sigmaOfEnd(instants, first.first), sigmaOfEnd(instants, last.last));
        sigmaDuration = std::hypot(sigmaDuration, sigmaOfBridgedMoment(bridges, first.startS, 1));
        sigmaDuration = std::hypot(sigmaDuration, sigmaOfBridgedMoment(bridges, last.stopS, -1));
        for (const MotionStretch &motion : motions) {
            path += lengthOf(motion, instants);
            movingTime += motion.stopS - motion.startS;
        }
        // An error of the path is, on a straight line, that of its ends; where it turns, errors across it
        // count too.
        sigmaEnds = std::hypot(sigmaOfPosition(*instants[first.first].point),
                               sigmaOfPosition(*instants[last.last].point));
        for (std::size_t i = 0; i < motions.size(); ++i)
            sigmaPath = std::hypot(sigmaPath, sigmaOfLengthOf(motions, i, instants));
        for (const Bridge &bridge : bridges)
            sigmaPath = std::hypot(sigmaPath, bridge.sigmaLengthM);
        sigmaPath = std::hypot(sigmaPath, scale * path);
        chord = (instants[last.last].point->position - instants[first.first].point->position).norm();
    }
    const double meanSpeed = measured > 0 ? path / measured : 0;
    double sigmaMean =
        measured > 0 ? std::hypot(sigmaPath / measured, meanSpeed * sigmaDuration / measured) : 0;
    if (measured > 0) {
        const SpeedRange range = meanSpeedRange(instants, motions, path, duration);
        sigmaMean =
            std::hypot(sigmaMean, std::max(meanSpeed - range.leastMps, range.mostMps - meanSpeed) / 2);
    }
    const double straightness = path > 0 ? std::min(1.0, chord / path) : 0;
    const double sigmaStraight = path > 0 ? sigmaEnds * std::hypot(1.0, straightness) / path : 0;
    double sigmaMoving = 0;
    for (const MotionStretch &motion : motions)
        sigmaMoving = std::hypot(
            sigmaMoving, std::hypot(sigmaOfEnd(instants, motion.first), sigmaOfEnd(instants, motion.last)));
    metrics = {{"duration", "s", duration, sigmaDuration, !motions.empty() && mayBeLonger(instants, motions)},
               {"path_length", "m", path, sigmaPath},
               {"mean_speed", "m/s", meanSpeed, sigmaMean},
               {"straightness", "1", straightness, sigmaStraight},
               {"moving_time", "s", movingTime, sigmaMoving},
               {"stops", "1", stops, std::nullopt, mayHaveStopped},
               {"standing_time", "s", std::max(0.0, measured - movingTime),
                motions.size() > 1 ? std::hypot(sigmaMoving, sigmaDuration) : 0.0}};
}

void addCircle(std::vector<Metric> &metrics, const std::vector<RunInstant> &instants,
               const std::vector<MotionStretch> &motions, double scale)
{
    // More points than that say no more of a circle: of a longer run every second, third, … is taken.
    constexpr std::size_t mostPoints = 100'000;
    const std::size_t stride = instants.size() / mostPoints + 1;
    std::vector<Eigen::Vector2d> path;
    for (const MotionStretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; i += stride)
            path.push_back(instants[i].point->position);
    }
    if (const auto circle = fitCircle(path))
        metrics.push_back({"circle_radius", "m", circle->radiusM,
                           std::hypot(circle->sigmaRadiusM, scale * circle->radiusM)});
}

/// The largest of noisy values, by leastOf. σ: its own, and how far the largest of several that are equal
/// exceeds them. Of n with normal errors that is σ√(2 ln n) at most; n counts the peaks that may be the true
/// largest. What errors all of them share makes none of them larger than others: σ is what the peaks scatter,
/// at most.
UncertainValue largestOf(const std::vector<UncertainValue> &values)
{
    const UncertainValue largest = *std::ranges::max_element(values, {}, leastOf);
    double peaks = 0, below = 0, squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double here = values[i].value;
        const bool isPeak =
            (i == 0 || here > values[i - 1].value) && (i + 1 == values.size() || here >= values[i + 1].value);
        if (!isPeak || here + 2 * values[i].sigma < largest.value)
            continue;
        peaks += 1;
        below += largest.value - here;
        squares += std::pow(largest.value - here, 2);
    }
    const double variance = largest.sigma * largest.sigma;
    if (peaks < 2)
        return largest;
    const double scatter = (squares - below * below / peaks) / (peaks - 1);
    return {largest.value, std::sqrt(variance + 2 * std::log(peaks) * std::min(variance, scatter))};
}

UncertainValue largestValue(const std::vector<RunInstant> &instants, Curve curve)
{
    std::vector<UncertainValue> values;
    for (const RunInstant &instant : instants)
        if (instant.measured)
            values.push_back({instant.point->*curve.value, instant.point->*curve.sigma});
    if (!values.empty())
        return largestOf(values);
    const ProfilePoint &bridged = *instants.front().point;
    return {bridged.*curve.value, bridged.*curve.sigma};
}

/// The fastest turn, of the body wherever that was measured, also at standstill; elsewhere of the path. Where
/// the rate is hardly known the robot may have turned faster: then it is the least that it was.
std::optional<Metric> fastestTurn(const std::vector<RunInstant> &instants,
                                  const std::vector<MotionStretch> &motions)
{
    std::vector<bool> isMoving(instants.size());
    for (const MotionStretch &motion : motions)
        std::fill(isMoving.begin() + std::ptrdiff_t(motion.first),
                  isMoving.begin() + std::ptrdiff_t(motion.last) + 1, true);
    std::vector<UncertainValue> rates;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const auto rate = turnRateOf(*instants[i].point);
        if (rate && (instants[i].point->body || isMoving[i]))
            rates.push_back({std::abs(rate->value), rate->sigma});
    }
    if (rates.empty())
        return std::nullopt;
    const UncertainValue fastest = largestOf(rates);
    const bool mayBeFaster = std::ranges::any_of(rates, [&](const UncertainValue &rate) {
        return rate.value + 2 * rate.sigma > fastest.value + sigmasOfLargest * fastest.sigma;
    });
    return Metric{"max_turn_rate", "rad/s", fastest.value, fastest.sigma,
                  mayBeFaster}; // an angle has no scale
}

} // namespace

std::vector<Metric> measureRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    return measureRun(validInstants(samples, points));
}

std::vector<Metric> measureRun(const std::vector<RunInstant> &instants)
{
    if (instants.empty())
        return {};
    const std::vector<MotionStretch> motions = findMotions(instants);
    const double scale = sigmaScale(instants);
    std::vector<Metric> course;
    addCourse(course, instants, motions, scale);

    // A speed scales with lengths; compared with its σ the calibration's scale uncertainty is small, but not
    // zero.
    const auto scaled = [&](const char *name, const char *unit, UncertainValue estimate) {
        return Metric{name, unit, estimate.value, std::hypot(estimate.sigma, scale * estimate.value)};
    };
    std::vector<Metric> metrics{
        course[0],
        course[1],
        course[2],
        scaled("max_speed", "m/s", largestValue(instants, speedCurve)),
        scaled("rms_speed", "m/s", rootMeanSquare(instants, motions, speedCurve)),
        scaled("max_accel", "m/s²", largestValue(instants, accelCurve)),
        scaled("rms_accel", "m/s²", rootMeanSquare(instants, motions, accelCurve)),
        course[3],
        course[4],
        course[5],
        course[6],
        scaled("median_speed", "m/s", percentile(instants, motions, speedCurve, 0.5)),
        scaled("p95_speed", "m/s", percentile(instants, motions, speedCurve, 0.95)),
        scaled("p95_accel", "m/s²", percentile(instants, motions, accelCurve, 0.95)),
    };
    if (const auto turn = fastestTurn(instants, motions))
        metrics.push_back(*turn);
    addCircle(metrics, instants, motions, scale);
    const std::vector<TimeSpan> gaps = gapsBetween(instants);
    // The ends of a run say how straight it was only if all of it was seen.
    if (!gaps.empty())
        std::erase_if(metrics, [](const Metric &metric) { return metric.name == "straightness"; });
    markLowerBounds(metrics, gaps);
    return metrics;
}

double metricValue(const Profile &profile, std::string_view name)
{
    const auto found = std::ranges::find(profile.metrics, name, &Metric::name);
    return found == profile.metrics.end() ? 0 : found->value;
}

void markLowerBounds(std::vector<Metric> &metrics, const std::vector<TimeSpan> &gaps)
{
    for (Metric &metric : metrics) {
        const MetricKind *kind = metricKind(metric.name);
        metric.isAtLeast = metric.isAtLeast || (!gaps.empty() && kind && kind->growsInGaps());
    }
}

double sigmaOfScale(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    return instants.empty() ? 0 : sigmaScale(instants);
}

namespace {

constexpr std::size_t fewestPoints = 10;
constexpr double leastTurnRad = 2 * std::numbers::pi / 3;
constexpr double largestRelativeRms = 0.03;
constexpr int steps = 10;

/// |p − c|² = R² is linear in c and R² − |c|².
Eigen::Vector3d algebraicCircle(std::span<const Eigen::Vector2d> path, const Eigen::Vector2d &origin)
{
    Eigen::MatrixX3d rows(path.size(), 3);
    Eigen::VectorXd squares(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector2d p = path[i] - origin;
        rows.row(static_cast<Eigen::Index>(i)) << 2 * p.x(), 2 * p.y(), 1;
        squares[static_cast<Eigen::Index>(i)] = p.squaredNorm();
    }
    const Eigen::Vector3d solved = rows.colPivHouseholderQr().solve(squares);
    return {solved.x() + origin.x(), solved.y() + origin.y(),
            std::sqrt(std::max(0.0, solved.z() + solved.head<2>().squaredNorm()))};
}

/// How many neighbours share one error.
double correlatedPoints(const std::vector<double> &distances)
{
    double variance = 0;
    for (const double d : distances)
        variance += d * d;
    double sum = 1;
    for (std::size_t lag = 1; variance > 0 && lag < distances.size() / 2; ++lag) {
        double product = 0;
        for (std::size_t i = lag; i < distances.size(); ++i)
            product += distances[i] * distances[i - lag];
        if (product <= 0)
            break;
        sum += 2 * product / variance;
    }
    return sum;
}

double turnOf(std::span<const Eigen::Vector2d> path, const Eigen::Vector2d &centre)
{
    double turn = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Eigen::Vector2d a = path[i - 1] - centre, b = path[i] - centre;
        turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turn);
}

} // namespace

std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> path)
{
    if (path.size() < fewestPoints)
        return std::nullopt;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d &point : path)
        origin += point / static_cast<double>(path.size());
    Eigen::Vector3d circle = algebraicCircle(path, origin);
    std::vector<double> distances(path.size());
    Eigen::Matrix3d normal;
    for (int step = 0; step < steps; ++step) {
        normal.setZero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < path.size(); ++i) {
            const Eigen::Vector2d outwards = path[i] - circle.head<2>();
            const double radius = outwards.norm();
            if (!(radius > 0))
                return std::nullopt;
            const Eigen::Vector3d slope(outwards.x() / radius, outwards.y() / radius, 1);
            distances[i] = radius - circle.z();
            normal += slope * slope.transpose();
            right += slope * distances[i];
        }
        circle += normal.ldlt().solve(right);
        if (!circle.allFinite())
            return std::nullopt;
    }
    CircleFit fit;
    fit.centre = circle.head<2>();
    fit.radiusM = circle.z();
    double squares = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        distances[i] = (path[i] - fit.centre).norm() - fit.radiusM;
        squares += distances[i] * distances[i];
    }
    fit.rmsM = std::sqrt(squares / static_cast<double>(path.size() - 3));
    const Eigen::Matrix3d inverse = normal.ldlt().solve(Eigen::Matrix3d::Identity());
    fit.sigmaRadiusM = fit.rmsM * std::sqrt(std::max(0.0, inverse(2, 2)) * correlatedPoints(distances));
    if (!(fit.radiusM > 0) || fit.rmsM > largestRelativeRms * fit.radiusM ||
        turnOf(path, fit.centre) < leastTurnRad)
        return std::nullopt;
    return fit;
}

const Curve speedCurve{&ProfilePoint::speedMps, &ProfilePoint::sigmaSpeedMps, [](const RunInstant &instant) {
                           const double whole = sigmaOfPosition(*instant.point),
                                        common = instant.commonSigmaM;
                           return std::sqrt(std::max(0.0, whole * whole - common * common));
                       }};
const Curve accelCurve{&ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2,
                       [](const RunInstant &instant) { return instant.point->sigmaSpeedMps; }};

UncertainValue rootMeanSquare(const std::vector<RunInstant> &instants,
                              const std::vector<MotionStretch> &motions, Curve curve)
{
    double squares = 0, errors = 0, count = 0;
    for (const MotionStretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const ProfilePoint &point = *instants[i].point;
            squares += std::pow(point.*curve.value, 2);
            errors += std::abs(point.*curve.value) * point.*curve.sigma;
            count += 1;
        }
    }
    if (count == 0 || squares == 0)
        return {};
    const double value = std::sqrt(squares / count);
    return {value, errors / count / value};
}

namespace {

/// An instant's value with the time that it stands for.
struct Weighted
{
    double value = 0, seconds = 0;
};

/// Sorts the values.
double weightedPercentile(std::vector<Weighted> &values, double share)
{
    std::sort(values.begin(), values.end(),
              [](const Weighted &a, const Weighted &b) { return a.value < b.value; });
    double total = 0;
    for (const Weighted &one : values)
        total += one.seconds;
    // Each value is at the middle of its time; between two the curve is assumed straight.
    double reached = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double middle = reached + values[i].seconds / 2;
        if (middle >= share * total) {
            if (i == 0)
                return values[0].value;
            const double before = reached - values[i - 1].seconds / 2;
            const double part = middle > before ? (share * total - before) / (middle - before) : 1.0;
            return values[i - 1].value + part * (values[i].value - values[i - 1].value);
        }
        reached += values[i].seconds;
    }
    return values.back().value;
}

} // namespace

UncertainValue percentile(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                          Curve curve, double share)
{
    std::vector<Weighted> values;
    values.reserve(instants.size());
    for (const MotionStretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const double from = instants[i == motion.first ? i : i - 1].timeS;
            const double to = instants[i == motion.last ? i : i + 1].timeS;
            const ProfilePoint &point = *instants[i].point;
            values.push_back({point.*curve.value, (to - from) / 2});
        }
    }
    if (values.empty())
        return {};
    const double value = weightedPercentile(values, share);
    double seconds = 0, variance = 0;
    for (const MotionStretch &motion : motions) {
        double stretch = 0; // how long the curve stays next to the value
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const ProfilePoint &point = *instants[i].point;
            const double sigma = point.*curve.sigma;
            const bool near = std::abs(point.*curve.value - value) <= sigmasNearPercentile * sigma;
            if (near)
                stretch += instants[i].timeS - instants[i > motion.first ? i - 1 : i].timeS;
            if (stretch > 0 && (!near || i == motion.last)) {
                const double ofMean = std::sqrt(2.0) * curve.sigmaOfIntegral(instants[i]) / stretch;
                seconds += stretch;
                variance += std::pow(stretch * std::min(sigma, ofMean), 2);
                stretch = 0;
            }
        }
    }
    if (seconds > 0)
        return {value, std::sqrt(variance) / seconds};
    const ProfilePoint *nearest = instants[motions.front().first].point;
    for (const MotionStretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const ProfilePoint &point = *instants[i].point;
            if (std::abs(point.*curve.value - value) < std::abs(nearest->*curve.value - value))
                nearest = &point;
        }
    }
    return {value, nearest->*curve.sigma};
}

const RunInstant &largest(const std::vector<RunInstant> &instants, Curve curve)
{
    // Bridged points are no evidence.
    const auto sure = [&](const RunInstant &instant) {
        return instant.measured ? leastOf({instant.point->*curve.value, instant.point->*curve.sigma})
                                : std::numeric_limits<double>::lowest();
    };
    return *std::max_element(instants.begin(), instants.end(),
                             [&](const RunInstant &a, const RunInstant &b) { return sure(a) < sure(b); });
}

} // namespace odo
