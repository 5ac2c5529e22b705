// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/light_gain.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

namespace {

constexpr double comparedSamples = 2000;
constexpr int codedBlack = 16, leastLuma = 24; // darker is noise
constexpr float leastFactor = 0.2F, mostFactor = 5;
constexpr std::size_t fewestRatios = 50;

} // namespace

LightGain LightGain::between(const PlaneView &plane, const PlaneView &reference, bool fullRange)
{
    LightGain gain{1, fullRange ? 0 : codedBlack};
    const int step = std::max(1, static_cast<int>(std::sqrt(double(plane.width) * plane.height / comparedSamples)));
    std::vector<float> ratios;
    for (int y = step / 2; y < plane.height; y += step) {
        const std::uint8_t *now = plane.row(y), *before = reference.row(y);
        for (int x = step / 2; x < plane.width; x += step) {
            if (std::min(now[x], before[x]) >= leastLuma + gain.black && std::max(now[x], before[x]) <= mostLuma)
                ratios.push_back(float(now[x] - gain.black) / float(before[x] - gain.black));
        }
    }
    if (ratios.size() < fewestRatios)
        return gain;
    // The mean of the middle half: the median alone would step with the code values.
    const auto quarter = static_cast<std::ptrdiff_t>(ratios.size() / 4);
    std::nth_element(ratios.begin(), ratios.begin() + quarter, ratios.end());
    std::nth_element(ratios.begin() + quarter, ratios.end() - quarter, ratios.end());
    double sum = 0;
    for (auto ratio = ratios.begin() + quarter; ratio != ratios.end() - quarter; ++ratio)
        sum += double(*ratio);
    gain.factor = std::clamp(static_cast<float>(sum / double(ratios.size() - 2 * std::size_t(quarter))), leastFactor, mostFactor);
    return gain;
}

std::array<std::uint8_t, 256> LightGain::table(float by) const
{
    std::array<std::uint8_t, 256> values{};
    for (int i = 0; i < 256; ++i)
        values[std::size_t(i)] = static_cast<std::uint8_t>(std::clamp(float(black) + by * float(i - black) + 0.5F, 0.0F, 255.0F));
    return values;
}

} // namespace odo
