// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_curve.h"

#include "ui/models/shown_units.h"

#include <algorithm>
#include <numbers>

namespace odo {

namespace {

constexpr double band95 = 1.959964; // of the normal distribution

ShownUnit unitOf(Quantity quantity)
{
    constexpr double degrees = 180 / std::numbers::pi;
    switch (quantity) {
    case Quantity::Speed:
        return shownUnits().speed;
    case Quantity::Acceleration:
        return shownUnits().acceleration;
    case Quantity::Heading:
        return {QStringLiteral("°"), degrees};
    case Quantity::TurnRate:
        return {QStringLiteral("°/s"), degrees};
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return shownUnits().length;
}

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
    return unitOf(quantity).name;
}

double curveFactor(Quantity quantity)
{
    return unitOf(quantity).perSi;
}

std::vector<double> sampleTimes(const Profile &profile)
{
    std::vector<double> times;
    for (const Sample &sample : profile.samples)
        times.push_back(toSeconds(sample.time));
    return times;
}

std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values, Quantity quantity,
                                const std::vector<double> &places)
{
    std::vector<CurveRun> runs;
    bool open = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]) {
            open = false;
            continue;
        }
        if (!open)
            runs.emplace_back();
        open = true;
        const CurveValue value = *values[i];
        const double place = places[i], reach = band95 * value.sigma;
        CurveRun &run = runs.back();
        run.line.append({place, value.value});
        run.upper.append({place, value.value + reach});
        // A speed is not negative, whatever its σ.
        run.lower.append(
            {place, quantity == Quantity::Speed ? std::max(0.0, value.value - reach) : value.value - reach});
    }
    return runs;
}

ValueRange valueRange(const std::vector<const CurveRun *> &runs, Quantity quantity)
{
    const bool isPlace = quantity == Quantity::PositionX || quantity == Quantity::PositionY;
    double low = isPlace && !runs.empty() ? runs.front()->line.front().y() : 0, high = low;
    for (const CurveRun *run : runs)
        for (const QPointF &point : run->line) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    const double room = 0.25 * std::max(1e-3, high - low);
    const double lineLow = low, lineHigh = high;
    for (const CurveRun *run : runs)
        for (qsizetype i = 0; i < run->line.size(); ++i) {
            low = std::min(low, std::max(run->lower[i].y(), lineLow - room));
            high = std::max(high, std::min(run->upper[i].y(), lineHigh + room));
        }
    return {low, high - low < 1e-6 ? low + 1 : high};
}

QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    QList<QPointF> points;
    const auto values = measuredValues(profile, quantity);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            points.append({places[i], curveFactor(quantity) * values[i]->value});
    return points;
}

QList<QPointF> spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    QList<QPointF> spikes;
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (quantity != Quantity::Speed || index >= profile.points.size())
            continue;
        const auto measured = measuredSpeed(profile, index);
        if (measured || profile.points[index].valid)
            spikes.append({places[index], curveFactor(Quantity::Speed) *
                                              (measured ? *measured : profile.points[index].speedMps)});
    }
    return spikes;
}

} // namespace odo
