// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_curve.h"

#include "core/trajectory/heading.h"

#include <algorithm>
#include <numbers>

namespace odo {

namespace {

constexpr double band95 = 1.959964; // of the normal distribution

double accelerationAlong(const ProfilePoint &point)
{
    constexpr double standing = 1e-9;
    const double speed = point.velocity.norm();
    return speed > standing ? point.acceleration.dot(point.velocity) / speed : point.accelMps2;
}

} // namespace

std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity)
{
    constexpr double degrees = 180 / std::numbers::pi;
    std::vector<std::optional<CurveValue>> values(profile.points.size());
    const auto headings = quantity == Quantity::Heading ? headingsOf(profile.points)
                                                        : std::vector<std::optional<Heading>>();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        switch (quantity) {
        case Quantity::Speed:
            values[i] = {point.speedMps, point.sigmaSpeedMps};
            break;
        case Quantity::Acceleration:
            values[i] = {accelerationAlong(point), point.sigmaAccelMps2};
            break;
        case Quantity::Heading:
            if (headings[i])
                values[i] = {degrees * headings[i]->radians, degrees * headings[i]->sigmaRad.value_or(0)};
            break;
        case Quantity::TurnRate:
            if (const auto course = courseOf(point))
                values[i] = {degrees * course->turnRateRadps, degrees * course->sigmaTurnRateRadps};
            break;
        }
    }
    return values;
}

QString curveUnit(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
        return QStringLiteral("m/s");
    case Quantity::Acceleration:
        return QStringLiteral("m/s\u00b2");
    case Quantity::Heading:
        return QStringLiteral("\u00b0");
    case Quantity::TurnRate:
        break;
    }
    return QStringLiteral("\u00b0/s");
}

std::vector<CurveRun> curveRuns(const Profile &profile, Quantity quantity)
{
    std::vector<CurveRun> runs;
    bool open = false;
    const auto values = curveValues(profile, quantity);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]) {
            open = false;
            continue;
        }
        if (!open)
            runs.emplace_back();
        open = true;
        const CurveValue value = *values[i];
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
    return curveValues(profile, quantity)[index];
}

} // namespace odo
