// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curves/profile_curve.h"

#include "ui/models/figure_text.h"
#include "ui/views/widgets/theme.h"

#include <algorithm>
#include <numbers>

namespace odo {

namespace {

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

ValueRange valueRange(const std::vector<ChartCurve> &curves, Quantity quantity)
{
    std::vector<const CurveRun *> runs;
    for (const ChartCurve &curve : curves)
        for (const CurveRun &run : curve.runs)
            if (curve.kind == ChartCurve::Kind::Line && run.isLine())
                runs.push_back(&run);
    const bool isPlace = quantity == Quantity::PositionX || quantity == Quantity::PositionY;
    double low = isPlace && !runs.empty() ? runs.front()->points.front().value : 0, high = low;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, double(point.value));
            high = std::max(high, double(point.value));
        }
    const double room = 0.25 * std::max(1e-3, high - low);
    // A speed is not negative, whatever its σ.
    const double least = quantity == Quantity::Speed ? std::max(0.0, low - room) : low - room,
                 most = high + room;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, std::max(point.low(), least));
            high = std::max(high, std::min(point.high(), most));
        }
    return {low, high - low < 1e-6 ? low + 1 : high};
}

CurveRun measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    CurveRun measured;
    const auto values = measuredValues(profile, quantity);
    measured.points.reserve(static_cast<std::size_t>(std::ranges::count_if(
        values, [](const std::optional<CurveValue> &value) { return value.has_value(); })));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            measured.points.emplace_back(places[i], CurveValue{curveFactor(quantity) * values[i]->value, 0});
    return measured;
}

CurveRun spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    CurveRun spikes;
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (quantity != Quantity::Speed || index >= profile.points.size())
            continue;
        const auto measured = measuredSpeed(profile, index);
        if (measured || profile.points[index].valid)
            spikes.points.emplace_back(places[index],
                                       CurveValue{curveFactor(Quantity::Speed) *
                                                      (measured ? *measured : profile.points[index].speedMps),
                                                  0});
    }
    return spikes;
}

ProfileCurves profileCurves(const Profile &profile, Quantity quantity, const std::vector<double> &places,
                            int group, int place)
{
    ProfileCurves curves;
    for (ChartCurve *curve : {&curves.measured, &curves.line, &curves.spikes}) {
        curve->group = group;
        curve->place = place;
    }
    curves.measured.kind = ChartCurve::Kind::Points;
    curves.measured.ink = ChartInk::Point;
    curves.measured.widthPx = 1;
    curves.measured.runs = {measuredPoints(profile, quantity, places)};
    curves.line.dash = seriesDash(group);
    curves.line.hasBand = true;
    curves.line.runs = curveRuns(curveValues(profile, quantity), places);
    curves.spikes.kind = ChartCurve::Kind::Spikes;
    curves.spikes.ink = ChartInk::Spike;
    curves.spikes.runs = {spikePoints(profile, quantity, places)};
    return curves;
}

} // namespace odo
