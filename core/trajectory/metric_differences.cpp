// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/metric_differences.h"

#include "core/trajectory/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

bool isOfTask(const std::string &name)
{
    static constexpr std::array<std::string_view, 4> names{"gate_time", "laps", "best_lap", "mean_lap"};
    return name.starts_with("cross_track") || name.starts_with("zone_") || name == "path_completed" ||
           std::ranges::find(names, name) != names.end();
}

/// Whether a calibration's error of scale is part of its σ.
bool hasScale(const std::string &unit)
{
    return unit == "m" || unit == "m/s" || unit == "m/s²";
}

double sigmaOf(const Metric &metric)
{
    if (metric.sigma)
        return *metric.sigma;
    return metric.name == "path_completed" ? completedResolution : 0;
}

Difference differenceOf(const Metric &a, double scaleA, const Metric &b, double scaleB, bool shareCalibration)
{
    const double sigma = std::hypot(sigmaOf(a), sigmaOf(b));
    if (!shareCalibration || !hasScale(a.unit))
        return {b.value - a.value, sigma};
    const double commonA = scaleA * a.value, commonB = scaleB * b.value;
    const double own = std::max(0.0, sigma * sigma - commonA * commonA - commonB * commonB);
    return {b.value - a.value, std::sqrt(own + std::pow(commonB - commonA, 2))};
}

} // namespace

std::vector<MetricDifference> metricDifferences(const Profile &a, const Profile &b, bool shareCalibration,
                                                bool sameTask)
{
    const double scaleA = sigmaOfScale(a.samples, a.points), scaleB = sigmaOfScale(b.samples, b.points);
    std::vector<MetricDifference> differences;
    for (const Metric &metric : a.metrics) {
        if (!sameTask && isOfTask(metric.name))
            continue;
        MetricDifference line{metric.name,  metric.unit,  metric.value, std::nullopt,
                              metric.sigma, std::nullopt, std::nullopt};
        if (const auto other = std::ranges::find(b.metrics, metric.name, &Metric::name);
            other != b.metrics.end()) {
            line.b = other->value;
            line.sigmaB = other->sigma;
            line.difference = differenceOf(metric, scaleA, *other, scaleB, shareCalibration);
        }
        differences.push_back(std::move(line));
    }
    for (const Metric &metric : b.metrics)
        if ((sameTask || !isOfTask(metric.name)) &&
            std::ranges::find(a.metrics, metric.name, &Metric::name) == a.metrics.end())
            differences.push_back({metric.name, metric.unit, std::nullopt, metric.value, std::nullopt,
                                   metric.sigma, std::nullopt});
    return differences;
}

} // namespace odo
