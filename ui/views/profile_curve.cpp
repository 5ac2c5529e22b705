// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_curve.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double band95 = 1.959964; // of the normal distribution

} // namespace

CurveValue curveValue(const ProfilePoint &point, Quantity quantity)
{
    if (quantity == Quantity::Speed)
        return {point.speedMps, point.sigmaSpeedMps};
    const double speed = point.velocity.norm();
    constexpr double standing = 1e-9;
    const double along = speed > standing ? point.acceleration.dot(point.velocity) / speed : point.accelMps2;
    return {along, point.sigmaAccelMps2};
}

std::vector<CurveRun> curveRuns(const Profile &profile, Quantity quantity)
{
    std::vector<CurveRun> runs;
    bool open = false;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        if (!profile.points[i].valid) {
            open = false;
            continue;
        }
        if (!open)
            runs.emplace_back();
        open = true;
        const CurveValue value = curveValue(profile.points[i], quantity);
        const double seconds = toSeconds(profile.samples[i].time), reach = band95 * value.sigma;
        CurveRun &run = runs.back();
        run.line.append({seconds, value.value});
        run.upper.append({seconds, value.value + reach});
        // A speed is not negative, whatever its σ.
        run.lower.append({seconds, quantity == Quantity::Speed ? std::max(0.0, value.value - reach)
                                                               : value.value - reach});
    }
    return runs;
}

std::optional<double> measuredSpeed(const Profile &profile, std::size_t sample)
{
    if (sample == 0 || sample + 1 >= profile.samples.size())
        return std::nullopt;
    const Sample &before = profile.samples[sample - 1], &after = profile.samples[sample + 1];
    if (!before.position || !after.position || after.time <= before.time)
        return std::nullopt;
    return (*after.position - *before.position).norm() / toSeconds(after.time - before.time);
}

QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity)
{
    QList<QPointF> points;
    if (quantity != Quantity::Speed)
        return points;
    for (std::size_t i = 1; i + 1 < profile.samples.size(); ++i) {
        const bool rejected = isRejected(profile.samples[i - 1].flags) ||
                              isRejected(profile.samples[i].flags) ||
                              isRejected(profile.samples[i + 1].flags);
        const auto speed = rejected ? std::nullopt : measuredSpeed(profile, i);
        if (speed)
            points.append({toSeconds(profile.samples[i].time), *speed});
    }
    return points;
}

std::optional<CurveValue> curveValueAt(const Profile &profile, Quantity quantity, Nanoseconds time)
{
    const auto after =
        std::upper_bound(profile.samples.begin(), profile.samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    if (after == profile.samples.begin())
        return std::nullopt;
    const auto index = static_cast<std::size_t>(after - profile.samples.begin()) - 1;
    if (!profile.points[index].valid)
        return std::nullopt;
    return curveValue(profile.points[index], quantity);
}

} // namespace odo
