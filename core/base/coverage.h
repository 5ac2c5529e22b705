// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace odo {

/// So many σ to either side hold 95 % of a normal distribution (JCGM 100:2008, table G.1): the reach of
/// bands, and the bound of what chance alone gives.
constexpr double coverage95 = 1.959964;

/// Student's t that is exceeded in either direction in 5 of 100 cases: exact for one and two degrees of
/// freedom, else the expansion of Cornish and Fisher (Abramowitz and Stegun 1964, 26.7.5), right to 0.003.
/// degrees: 1 or more.
inline double studentT95(int degrees)
{
    constexpr double share = 0.05; // in both tails together
    if (degrees == 1)
        return 1 / std::tan(share * std::numbers::pi / 2);
    if (degrees == 2)
        return std::sqrt(2 / (share * (2 - share)) - 2);
    constexpr double z = coverage95;
    const double n = degrees, z2 = z * z;
    const double g1 = z * (z2 + 1) / 4;
    const double g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
    const double g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    const double g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
    return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

} // namespace odo
