// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace odo {

/// The cubic through two values with their rates, over a step of time (Hermite). part runs from 0 to 1 over
/// the step.
struct CubicStep
{
    double from = 0, to = 0, rateFrom = 0, rateTo = 0, stepS = 0;

    double value(double part) const
    {
        const double rest = 1 - part;
        return rest * rest * ((1 + 2 * part) * from + part * stepS * rateFrom) +
               part * part * ((1 + 2 * rest) * to - rest * stepS * rateTo);
    }
    double rate(double part) const
    {
        return 6 * part * (1 - part) * (to - from) / stepS + (1 - part) * (1 - 3 * part) * rateFrom +
               part * (3 * part - 2) * rateTo;
    }
    /// The part at which it is zero; from and to have different signs.
    double root() const
    {
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            ((value(middle) > 0) == (to > 0) ? high : low) = middle;
        }
        return (low + high) / 2;
    }
};

} // namespace odo
