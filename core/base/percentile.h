// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
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

} // namespace odo
