// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/curve_statistics.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

} // namespace

const Curve speedCurve{&ProfilePoint::speedMps, &ProfilePoint::sigmaSpeedMps, [](const RunInstant &instant) {
                           const double whole = sigmaOfPosition(*instant.point),
                                        common = instant.commonSigmaM;
                           return std::sqrt(std::max(0.0, whole * whole - common * common));
                       }};
const Curve accelCurve{&ProfilePoint::accelMps2, &ProfilePoint::sigmaAccelMps2,
                       [](const RunInstant &instant) { return instant.point->sigmaSpeedMps; }};

Figure rootMeanSquare(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
                      Curve curve)
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
    // Each value stands at the middle of its time; between two the curve is taken as straight.
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

Figure percentile(const std::vector<RunInstant> &instants, const std::vector<MotionStretch> &motions,
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
    const auto sure = [&](const RunInstant &instant) {
        return instant.point->*curve.value - 2 * (instant.point->*curve.sigma);
    };
    return *std::max_element(instants.begin(), instants.end(),
                             [&](const RunInstant &a, const RunInstant &b) { return sure(a) < sure(b); });
}

} // namespace odo
