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
    times.reserve(profile.samples.size());
    for (const Sample &sample : profile.samples)
        times.push_back(toSeconds(sample.time));
    return times;
}

BandPoint::BandPoint(double place, const CurveValue &curveValue)
    : x(place), value(float(curveValue.value)), reach(float(band95 * curveValue.sigma))
{
}

CurveValue BandPoint::curveValue() const
{
    return {double(value), double(reach) / band95};
}

std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values, const std::vector<double> &places)
{
    std::vector<CurveRun> runs;
    const auto exists = [](const std::optional<CurveValue> &value) { return value.has_value(); };
    for (auto begin = std::find_if(values.begin(), values.end(), exists); begin != values.end();) {
        const auto end = std::find_if_not(begin, values.end(), exists);
        CurveRun &run = runs.emplace_back(CurveRun{static_cast<std::size_t>(begin - values.begin()), {}});
        run.points.reserve(static_cast<std::size_t>(end - begin));
        for (auto value = begin; value != end; ++value)
            run.points.emplace_back(places[static_cast<std::size_t>(value - values.begin())], **value);
        begin = std::find_if(end, values.end(), exists);
    }
    return runs;
}

ValueRange valueRange(const std::vector<const CurveRun *> &runs, Quantity quantity)
{
    const bool isPlace = quantity == Quantity::PositionX || quantity == Quantity::PositionY;
    double low = isPlace && !runs.empty() ? runs.front()->points.front().value : 0, high = low;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, double(point.value));
            high = std::max(high, double(point.value));
        }
    const double room = 0.25 * std::max(1e-3, high - low);
    // A speed is not negative, whatever its σ.
    const double least = quantity == Quantity::Speed ? std::max(0.0, low - room) : low - room, most = high + room;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, std::max(point.low(), least));
            high = std::max(high, std::min(point.high(), most));
        }
    return {low, high - low < 1e-6 ? low + 1 : high};
}

QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    QList<QPointF> points;
    const auto values = measuredValues(profile, quantity);
    points.reserve(std::count_if(values.begin(), values.end(), [](const std::optional<CurveValue> &value) { return value.has_value(); }));
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
