// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace odo {

/// The value at or below which so many of a hundred lie, the nearest one by rank; 0 of none.
inline double percentile(std::vector<double> values, double percent)
{
    if (values.empty())
        return 0;
    const auto at =
        static_cast<std::ptrdiff_t>(std::lround(percent / 100 * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// The middle value, of an even number the larger of the two in the middle: always one of the values. At
/// least one must be given.
template <class Value>
Value upperMedian(std::vector<Value> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The middle value, of an even number the mean of the two; 0 for none. Reorders the values.
inline double medianOf(std::span<double> values)
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

/// The same of values that are kept.
inline double median(std::vector<double> values)
{
    return medianOf(values);
}

} // namespace odo
