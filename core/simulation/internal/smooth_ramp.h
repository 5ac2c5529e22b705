// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace odo {

/// A value and its first two derivatives.
struct RampValue
{
    double value = 0, first = 0, second = 0;
};

/// The quintic that goes from 0 at u = 0 to 1 at u = 1 with zero first and second derivative at both;
/// constant outside.
inline RampValue smoothRamp(double u)
{
    const double x = std::clamp(u, 0.0, 1.0);
    return {x * x * x * (10 + x * (-15 + 6 * x)), 30 * x * x * (1 - x) * (1 - x),
            60 * x * (1 - x) * (1 - 2 * x)};
}

/// Its integral from 0 to u, held at 1/2 beyond u = 1.
inline double smoothRampIntegral(double u)
{
    const double x = std::clamp(u, 0.0, 1.0);
    return x * x * x * x * (2.5 + x * (-3 + x));
}

} // namespace odo
