// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace odo {

namespace {

/// As much of what was typed as an error shows.
std::string beginningOf(std::string_view text)
{
    return std::string(text.substr(0, 40));
}

} // namespace

Nanoseconds fromSeconds(double seconds)
{
    return Nanoseconds(std::llround(seconds * 1e9));
}

Result<double> parseNumber(std::string_view text)
{
    // from_chars knows no leading '+', which spreadsheets like to write.
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    double value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
        return fail(ErrorCode::InvalidInput, ODO_TEXT("base.number", "number '%1'")(beginningOf(text)),
                    ODO_TEXT("base.no_number", "not a finite decimal number"),
                    ODO_TEXT("base.write_number", "write it with digits and a point, like 12.5"));
    return value;
}

std::string formatNumber(double value, int decimals)
{
    char text[400]; // the longest double has 309 digits before its point
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
    return std::string(text, end);
}

std::string sizeText(int width, int height)
{
    return std::to_string(width) + "×" + std::to_string(height);
}

Result<double> parseLengthM(std::string_view text)
{
    struct Unit
    {
        std::string_view suffix;
        double metres;
    };
    static constexpr Unit units[] = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"", 0.001}};
    for (const Unit &unit : units) {
        if (!text.ends_with(unit.suffix))
            continue;
        const auto value = parseNumber(text.substr(0, text.size() - unit.suffix.size()));
        if (!value)
            break;
        return *value * unit.metres;
    }
    return fail(ErrorCode::InvalidInput, ODO_TEXT("base.length", "length '%1'")(beginningOf(text)),
                ODO_TEXT("base.no_length", "not a number with the unit mm, cm or m"),
                ODO_TEXT("base.write_length", "write it like 25mm, 2.5cm or 0.3m"));
}

std::string RgbColour::toString() const
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", red, green, blue);
    return text;
}

Result<RgbColour> parseColour(std::string_view text)
{
    unsigned value = 0;
    if (text.size() == 7 && text[0] == '#') {
        const auto [end, problem] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
        if (problem == std::errc() && end == text.data() + 7)
            return RgbColour{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
                             static_cast<std::uint8_t>(value)};
    }
    return fail(ErrorCode::InvalidInput, ODO_TEXT("base.colour", "colour '%1'")(beginningOf(text)),
                ODO_TEXT("base.no_colour", "not of the form #rrggbb"),
                ODO_TEXT("base.write_colour", "write it like #d72328"));
}

} // namespace odo
