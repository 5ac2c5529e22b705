// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/stamps.h"

#include <array>
#include <charconv>
#include <chrono>

namespace odo {

namespace {

/// Reads a text from its beginning, piece by piece.
class Scanner
{
public:
    explicit Scanner(std::string_view text) : m_text(text) {}

    std::optional<int> digits(std::size_t least, std::size_t most)
    {
        std::size_t count = 0;
        int value = 0;
        while (count < most && count < m_text.size() && m_text[count] >= '0' && m_text[count] <= '9')
            value = 10 * value + (m_text[count++] - '0');
        if (count < least)
            return std::nullopt;
        m_text.remove_prefix(count);
        return value;
    }
    bool skip(std::string_view anyOf)
    {
        if (m_text.empty() || anyOf.find(m_text.front()) == std::string_view::npos)
            return false;
        m_text.remove_prefix(1);
        return true;
    }
    /// The digits behind a decimal sign; 0 where none follow.
    long double fraction()
    {
        long double value = 0, place = 0.1L;
        if (!skip(".,"))
            return 0;
        while (!m_text.empty() && m_text.front() >= '0' && m_text.front() <= '9') {
            value += place * (m_text.front() - '0');
            place /= 10;
            m_text.remove_prefix(1);
        }
        return value;
    }
    bool atEnd() const { return m_text.empty(); }
    std::string_view rest() const { return m_text; }

private:
    std::string_view m_text;
};

/// "10:11:03.25" or "11:03.25"; nothing else follows but what `scanner` is left with.
std::optional<long double> clockOf(Scanner &scanner)
{
    constexpr int most = 60;
    const auto first = scanner.digits(1, 3);
    if (!first || !scanner.skip(":"))
        return std::nullopt;
    const auto second = scanner.digits(2, 2);
    if (!second || *second >= most)
        return std::nullopt;
    if (!scanner.skip(":"))
        return 60.0L * *first + *second + scanner.fraction();
    const auto third = scanner.digits(2, 2);
    if (!third || *third > most) // a leap second
        return std::nullopt;
    long double part = 0;
    Scanner rest = scanner; // Kinovea: 0:00:03:25 is 3.25 s
    if (rest.skip(":")) {
        const auto hundredths = rest.digits(2, 2);
        if (!hundredths)
            return std::nullopt;
        part = 0.01L * *hundredths;
        scanner = rest;
    }
    return 3600.0L * *first + 60.0L * *second + *third + part + scanner.fraction();
}

/// Days since 1970 of "2024-05-06", "2024/05/06" or "06.05.2024".
std::optional<int> dayOf(Scanner &scanner)
{
    const auto first = scanner.digits(1, 4);
    if (!first)
        return std::nullopt;
    const bool isYearLast = scanner.skip(".");
    if (!isYearLast && !scanner.skip("-/"))
        return std::nullopt;
    const auto second = scanner.digits(1, 2);
    if (!second || !scanner.skip("-/."))
        return std::nullopt;
    const auto third = scanner.digits(1, 4);
    if (!third)
        return std::nullopt;
    const int year = isYearLast ? *third : *first, day = isYearLast ? *first : *third;
    constexpr int firstYear = 1970, lastYear = 2200;
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(*second)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok() || year < firstYear || year > lastYear)
        return std::nullopt;
    return static_cast<int>(std::chrono::sys_days(date).time_since_epoch().count());
}

/// Seconds that a zone like "Z", "+02:00" or "-0500" is ahead of UTC; nullopt: it is none.
std::optional<int> zoneOf(Scanner scanner)
{
    scanner.skip(" ");
    if (scanner.atEnd() || scanner.rest() == "Z" || scanner.rest() == "z" || scanner.rest() == "UTC")
        return 0;
    const int sign = scanner.rest().front() == '-' ? -1 : 1;
    if (!scanner.skip("+-"))
        return std::nullopt;
    const auto hours = scanner.digits(2, 2);
    scanner.skip(":");
    const auto minutes = scanner.digits(0, 2);
    if (!hours || !minutes || !scanner.atEnd())
        return std::nullopt;
    return sign * (3600 * *hours + 60 * *minutes);
}

} // namespace

std::optional<Stamp> stampOf(std::string_view cell, const NumberStyle &style)
{
    if (const auto number = styledLongNumber(cell, style))
        return Stamp{Stamp::Kind::Number, *number};
    Scanner clock(cell);
    if (const auto seconds = clockOf(clock); seconds && clock.atEnd())
        return Stamp{Stamp::Kind::Clock, *seconds};
    Scanner date(cell);
    const auto day = dayOf(date);
    if (!day || !date.skip("Tt /"))
        return std::nullopt;
    const auto seconds = clockOf(date);
    const auto zone = zoneOf(date);
    if (!seconds || !zone)
        return std::nullopt;
    return Stamp{Stamp::Kind::Date, 86400.0L * *day + *seconds - *zone};
}

} // namespace odo
