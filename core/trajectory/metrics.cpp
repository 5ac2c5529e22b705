// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/metrics.h"

#include "core/trajectory/circle_fit.h"
#include "core/trajectory/curve_statistics.h"
#include "core/trajectory/driven_way.h"
#include "core/trajectory/heading.h"
#include "core/trajectory/motion_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

/// σ of a stretch's length: of its two ends, and ∫ω·e dt of the error e across a path that turns at ω.
double sigmaOfLengthOf(const MotionStretch &motion, const std::vector<RunInstant> &instants)
{
    double variance = std::pow(sigmaOfPosition(*instants[motion.first].point), 2) +
                      std::pow(sigmaOfPosition(*instants[motion.last].point), 2);
    for (std::size_t i = motion.first + 1; i <= motion.last; ++i) {
        const auto course = courseOf(*instants[i].point);
        if (!course)
            continue;
        const double step = std::max(0.0, instants[i].timeS - instants[i - 1].timeS); // a clock may stand still
        variance += std::pow(course->turnRateRadps * sigmaOfPosition(*instants[i].point), 2) * step *
                    correlationTimeS(instants[i]);
    }
    return std::sqrt(variance);
}

/// Relative error of scale that the calibration leaves: its σ at two places over their distance.
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

/// Length, times and what hangs on both.
void addCourse(std::vector<Metric> &metrics, const std::vector<RunInstant> &instants,
               const std::vector<MotionStretch> &motions, double scale)
{
    double duration = 0, path = 0, movingTime = 0, sigmaDuration = 0, sigmaPath = 0, chord = 0, sigmaEnds = 0;
    if (!motions.empty()) {
        const MotionStretch &first = motions.front(), &last = motions.back();
        duration = last.stopS - first.startS;
        sigmaDuration = std::hypot(sigmaOfMoment(instants, first.first), sigmaOfMoment(instants, last.last));
        for (const MotionStretch &motion : motions) {
            path += lengthOf(motion, instants);
            movingTime += motion.stopS - motion.startS;
        }
        // An error of the path is, on a straight line, that of its ends; where it turns, errors across it
        // count too.
        sigmaEnds = std::hypot(sigmaOfPosition(*instants[first.first].point),
                               sigmaOfPosition(*instants[last.last].point));
        for (const MotionStretch &motion : motions)
            sigmaPath = std::hypot(sigmaPath, sigmaOfLengthOf(motion, instants));
        sigmaPath = std::hypot(sigmaPath, scale * path);
        chord = (instants[last.last].point->position - instants[first.first].point->position).norm();
    }
    const double meanSpeed = duration > 0 ? path / duration : 0;
    const double sigmaMean =
        duration > 0 ? std::hypot(sigmaPath / duration, meanSpeed * sigmaDuration / duration) : 0;
    const double straightness = path > 0 ? std::min(1.0, chord / path) : 0;
    const double sigmaStraight = path > 0 ? sigmaEnds * std::hypot(1.0, straightness) / path : 0;
    double sigmaMoving = 0;
    for (const MotionStretch &motion : motions)
        sigmaMoving = std::hypot(sigmaMoving, std::hypot(sigmaOfMoment(instants, motion.first),
                                                         sigmaOfMoment(instants, motion.last)));
    const double stops = motions.empty() ? 0 : static_cast<double>(motions.size() - 1);
    metrics = {{"duration", "s", duration, sigmaDuration},
               {"path_length", "m", path, sigmaPath},
               {"mean_speed", "m/s", meanSpeed, sigmaMean},
               {"straightness", "1", straightness, sigmaStraight},
               {"moving_time", "s", movingTime, sigmaMoving},
               {"stops", "1", stops, std::nullopt},
               {"standing_time", "s", std::max(0.0, duration - movingTime),
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

/// The fastest turn beyond doubt: by its rate less twice its σ, as of a curve's largest value.
Figure fastestTurn(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions)
{
    Figure fastest;
    double surest = -std::numeric_limits<double>::infinity();
    for (const MotionStretch &motion : motions) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            const auto course = courseOf(*instants[i].point);
            if (!course || std::abs(course->turnRateRadps) - 2 * course->sigmaTurnRateRadps <= surest)
                continue;
            fastest = {std::abs(course->turnRateRadps), course->sigmaTurnRateRadps};
            surest = fastest.value - 2 * fastest.sigma;
        }
    }
    return fastest;
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

    // A speed scales with lengths; next to its σ the calibration's error of scale is small, but it is there.
    const auto scaled = [&](const char *name, const char *unit, Figure figure) {
        return Metric{name, unit, figure.value, std::hypot(figure.sigma, scale * figure.value)};
    };
    const auto at = [](const RunInstant &instant, Curve curve) {
        return Figure{instant.point->*curve.value, instant.point->*curve.sigma};
    };
    const Figure turn = fastestTurn(instants, motions); // an angle has no scale
    std::vector<Metric> metrics{
        course[0],
        course[1],
        course[2],
        scaled("max_speed", "m/s", at(largest(instants, speedCurve), speedCurve)),
        scaled("rms_speed", "m/s", rootMeanSquare(instants, motions, speedCurve)),
        scaled("max_accel", "m/s²", at(largest(instants, accelCurve), accelCurve)),
        scaled("rms_accel", "m/s²", rootMeanSquare(instants, motions, accelCurve)),
        course[3],
        course[4],
        course[5],
        course[6],
        scaled("median_speed", "m/s", percentile(instants, motions, speedCurve, 0.5)),
        scaled("p95_speed", "m/s", percentile(instants, motions, speedCurve, 0.95)),
        scaled("p95_accel", "m/s²", percentile(instants, motions, accelCurve, 0.95)),
        {"max_turn_rate", "rad/s", turn.value, turn.sigma},
    };
    addCircle(metrics, instants, motions, scale);
    return metrics;
}

double sigmaOfScale(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    return instants.empty() ? 0 : sigmaScale(instants);
}

} // namespace odo
