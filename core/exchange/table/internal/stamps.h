// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/internal/number_style.h"

#include <optional>
#include <string_view>

namespace odo {

/// A moment as a table writes it. Plain value.
struct Stamp
{
    enum class Kind {
        Number,   ///< in a unit that the column says, or not
        Duration, ///< 33.3 ms: seconds
        Clock,    ///< 10:11:03.25, 10:11:03.25 PM: seconds of the day
        Timecode, ///< 0:00:03:25: seconds, and hundredths of what the last part counts: frames or hundredths
        Date ///< 2024-05-06T10:11:03.25Z, 5/6/2024 10:11:03: seconds since 1970; without a zone as of UTC
    };
    Kind kind = Kind::Number;
    long double value = 0;
};

/// A whole cell as a moment; nullopt: it is none.
std::optional<Stamp> stampOf(std::string_view cell, const NumberStyle &style);

} // namespace odo
