// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/frame_rate_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr std::array usualRates{24e3 / 1001, 24.0,        25.0, 30e3 / 1001, 30.0,  48.0,
                                50.0,        60e3 / 1001, 60.0, 100.0,       120.0, 240.0};
constexpr double mostTimes = 2.001;
constexpr double sameRate = 0.003; ///< of it

} // namespace

std::vector<double> labelRates()
{
    std::vector<double> rates;
    for (const double taken : usualRates) {
        for (const double stated : usualRates) {
            const double times = taken / stated;
            if (times < mostTimes && times > 1 / mostTimes && std::abs(times - 1) > sameRate)
                rates.push_back(times - 1);
        }
    }
    std::sort(rates.begin(), rates.end());
    return rates;
}

std::optional<double> rateBehindLabel(double statedRate, double clockRate)
{
    const auto nearest = [](double rate) {
        return *std::min_element(usualRates.begin(), usualRates.end(), [rate](double a, double b) {
            return std::abs(a - rate) < std::abs(b - rate);
        });
    };
    const double taken = statedRate * (1 + clockRate), usual = nearest(taken), stated = nearest(statedRate);
    if (std::abs(usual - taken) > sameRate * taken || std::abs(stated - statedRate) > sameRate * statedRate ||
        std::abs(usual - stated) < sameRate * stated)
        return std::nullopt;
    return usual;
}

} // namespace odo
