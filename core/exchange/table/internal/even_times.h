// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <cstddef>
#include <vector>

namespace odo {

// Times that were rounded when they were written. All functions are pure and thread-safe.

/// The coarsest step of which all differences of times are a multiple. 0: fewer than two times, or all the
/// same.
Nanoseconds resolutionOf(const std::vector<Nanoseconds> &times);

/// How many times are those of the row before.
std::size_t sharedStamps(const std::vector<Nanoseconds> &times);

enum class EvenSpread {
    NotEven,     ///< nothing was done
    AlreadyEven, ///< nothing had to be done
    Slightly,    ///< the rounding is a small part of the interval
    Much
};
/// Where the resolution shows beside the usual interval and the rows come evenly but for the rounding:
/// spreads them.
EvenSpread spreadEvenly(std::vector<Nanoseconds> &times, Nanoseconds resolution);
/// The same of times that increase, with rows missing here and there.
EvenSpread spreadWithGaps(std::vector<Nanoseconds> &times, Nanoseconds resolution);

} // namespace odo
