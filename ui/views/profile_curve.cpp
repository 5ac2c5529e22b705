// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_curve.h"

#include <algorithm>
#include <numbers>

namespace odo {

namespace {

constexpr double band95 = 1.959964; // of the normal distribution

} // namespace

std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity)
{
    auto values = quantityValues(profile, quantity);
    const double factor = curveFactor(quantity);
    for (auto &value : values)
        if (value)
            value = CurveValue{factor * value->value, factor * value->sigma};
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
        return QStringLiteral("\u00b0/s");
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return QStringLiteral("mm");
}

double curveFactor(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
    case Quantity::Acceleration:
        return 1;
    case Quantity::Heading:
    case Quantity::TurnRate:
        return 180 / std::numbers::pi;
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return toMillimetres(1);
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

QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity)
{
    QList<QPointF> points;
    const auto values = measuredValues(profile, quantity);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            points.append({toSeconds(profile.samples[i].time), curveFactor(quantity) * values[i]->value});
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
