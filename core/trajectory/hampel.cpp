// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/hampel.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// Reorders the values.
double medianOf(std::span<double> values)
{
    if (values.empty())
        return 0;
    constexpr std::size_t fewValues = 16;
    if (values.size() <= fewValues) { // as most windows: sorted more quickly than parted
        for (std::size_t i = 1; i < values.size(); ++i) {
            const double value = values[i];
            std::size_t at = i;
            for (; at > 0 && values[at - 1] > value; --at)
                values[at] = values[at - 1];
            values[at] = value;
        }
        const std::size_t half = values.size() / 2;
        return values.size() % 2 == 1 ? values[half] : (values[half] + values[half - 1]) / 2;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

constexpr double toStandardDeviation = 1.4826;

} // namespace

double median(std::vector<double> values) { return medianOf(values); }

double medianDeviation(const std::vector<double> &values)
{
    const double centre = median(values);
    std::vector<double> deviations;
    deviations.reserve(values.size());
    for (const double value : values)
        deviations.push_back(std::abs(value - centre));
    return toStandardDeviation * median(std::move(deviations));
}

std::vector<bool> hampelOutliers(std::span<const double> values, const HampelSettings &settings)
{
    std::vector<bool> outliers(values.size());
    const auto half = static_cast<std::size_t>(std::max(0, settings.halfWindow));
    std::vector<double> window; // one memory for all of them
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t first = i > half ? i - half : 0, end = std::min(values.size(), i + half + 1);
        window.assign(values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(end));
        const double centre = medianOf(window);
        for (double &value : window)
            value = std::abs(value - centre);
        const double deviation = std::max(settings.leastDeviation, toStandardDeviation * medianOf(window));
        outliers[i] = std::abs(values[i] - centre) > settings.threshold * deviation;
    }
    return outliers;
}

std::vector<HampelSpike> hampelSpikes(std::span<const TrackNode> track)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (track[i].measured)
            indices.push_back(i);
    }
    constexpr int halfWindow = 3;
    constexpr double threshold = 5;
    std::vector<HampelSpike> spikes(track.size());
    for (int axis : {0, 1}) {
        std::vector<double> positions, speeds; // speeds[i]: from measurement i to the next
        double sigma = 0, speedSigma = 0;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const TrackNode &node = track[indices[i]];
            positions.push_back(node.position[axis]);
            sigma = std::max(sigma, std::sqrt(node.covariance(axis, axis)));
            if (i == 0)
                continue;
            const double step = node.timeS - track[indices[i - 1]].timeS;
            speeds.push_back((positions[i] - positions[i - 1]) / step);
            speedSigma = std::max(speedSigma, sigma / step);
        }
        const auto far = hampelOutliers(positions, {halfWindow, threshold, sigma});
        const auto fast = hampelOutliers(speeds, {halfWindow, threshold, speedSigma});
        for (std::size_t i = 0; i < indices.size(); ++i) {
            spikes[indices[i]].byPosition |= far[i];
            spikes[indices[i]].bySpeed |= i > 0 && i < speeds.size() && fast[i - 1] && fast[i];
        }
    }
    return spikes;
}

} // namespace odo
