// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace odo {

/// Time everywhere inside: a count of nanoseconds. Its event and zero are documented where it
/// is kept.
using Nanoseconds = std::chrono::nanoseconds;

constexpr double toSeconds(Nanoseconds t)
{
    return static_cast<double>(t.count()) * 1e-9;
}
/// Rounds to the nearest nanosecond.
Nanoseconds fromSeconds(double seconds);

constexpr double millimetresPerMetre = 1000.0;
constexpr double toMillimetres(double metres)
{
    return metres * millimetresPerMetre;
}
constexpr double fromMillimetres(double millimetres)
{
    return millimetres / millimetresPerMetre;
}

/// Reads a whole text as a finite decimal number, independent of the locale. nullopt-like Error where it is
/// none.
Result<double> parseNumber(std::string_view text);

/// Writes a number with so many decimals, with a point whatever the locale.
std::string formatNumber(double value, int decimals);

/// "1280×720"
std::string sizeText(int width, int height);

/// Reads a length as the command line promises: "25mm", "2.5cm", "0.3m"; a bare number is millimetres. Gives
/// metres.
Result<double> parseLengthM(std::string_view text);

/// A colour in sRGB, 8 bits a channel.
struct RgbColour
{
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const RgbColour &) const = default;
    /// "#rrggbb"
    std::string toString() const;
};

/// Reads "#rrggbb".
Result<RgbColour> parseColour(std::string_view text);

/// A stretch of time, both ends included; begin ≤ end.
struct TimeSpan
{
    Nanoseconds begin{0}, end{0};

    bool contains(Nanoseconds time) const { return time >= begin && time <= end; }
    bool operator==(const TimeSpan &) const = default;
};

} // namespace odo
