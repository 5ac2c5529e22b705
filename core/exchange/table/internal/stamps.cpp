// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/stamps.h"

#include "core/base/plain_text.h"
#include "core/exchange/table/internal/column_name.h"

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

struct ClockTime
{
    long double seconds = 0;
    std::optional<int> lastPart = {}; ///< of "0:00:03:25"
};

/// The hours that "AM" or "PM" adds to those of a clock of twelve; nullopt: neither follows.
std::optional<int> halfOfDay(Scanner &scanner, int hour)
{
    Scanner rest = scanner;
    rest.skip(" ");
    const std::string lower = lowerCaseAscii(rest.rest().substr(0, 2));
    constexpr int noon = 12;
    if ((lower != "am" && lower != "pm") || hour < 1 || hour > noon)
        return std::nullopt;
    rest.skip("aApP");
    rest.skip("mM");
    scanner = rest;
    return (lower == "pm" ? noon : 0) - (hour == noon ? noon : 0);
}

/// "10:11:03.25", "10:11:03.25 PM" or "11:03.25"; what follows is left in `from`, which stays as it is where
/// there is none.
std::optional<ClockTime> clockOf(Scanner &from)
{
    constexpr int most = 60;
    constexpr long double hourSeconds = 3600;
    Scanner scanner = from;
    const auto first = scanner.digits(1, 3);
    if (!first || !scanner.skip(":"))
        return std::nullopt;
    const auto second = scanner.digits(2, 2);
    if (!second || *second >= most)
        return std::nullopt;
    if (!scanner.skip(":")) {
        const ClockTime time{60.0L * *first + *second + scanner.fraction()};
        from = scanner;
        return time;
    }
    const auto third = scanner.digits(2, 2);
    if (!third || *third > most) // a leap second
        return std::nullopt;
    ClockTime time{hourSeconds * *first + 60.0L * *second + *third};
    if (scanner.skip(":")) {
        const std::size_t before = scanner.rest().size();
        const auto part = scanner.digits(2, 3);
        if (!part)
            return std::nullopt;
        if (before - scanner.rest().size() == 3)
            time.seconds += 0.001L * *part;
        else
            time.lastPart = part;
        from = scanner;
        return time;
    }
    time.seconds += scanner.fraction();
    if (const auto hours = halfOfDay(scanner, *first))
        time.seconds += hourSeconds * *hours;
    from = scanner;
    return time;
}

/// Days since 1970 of "2024-05-06", "2024/05/06", "06.05.2024", "20240506" or "5/6/2024", which has the month
/// first where that can be. That only says when the file begins: at midnight, a wrong guess leaps by a month.
std::optional<int> dayOf(Scanner &scanner)
{
    constexpr std::size_t compact = 8;
    Scanner rest = scanner;
    int year = 0, month = 0, day = 0;
    if (const auto digits = rest.digits(compact, compact)) {
        year = *digits / 10000, month = *digits / 100 % 100, day = *digits % 100;
        scanner = rest;
    } else {
        const std::size_t before = scanner.rest().size();
        const auto first = scanner.digits(1, 4);
        const bool isYearFirst = first && before - scanner.rest().size() == 4;
        const bool isDayFirst = !isYearFirst && scanner.rest().starts_with('.');
        const auto second = first && scanner.skip("-/.") ? scanner.digits(1, 2) : std::nullopt;
        const auto third = second && scanner.skip("-/.") ? scanner.digits(1, 4) : std::nullopt;
        if (!third)
            return std::nullopt;
        constexpr int months = 12;
        year = isYearFirst ? *first : *third;
        day = isYearFirst ? *third : isDayFirst || *first > months ? *first : *second;
        month = isYearFirst || isDayFirst || *first > months ? *second : *first;
    }
    constexpr int firstYear = 1970, lastYear = 2200;
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok() || year < firstYear || year > lastYear)
        return std::nullopt;
    return static_cast<int>(std::chrono::sys_days(date).time_since_epoch().count());
}

/// "101103.25"
std::optional<ClockTime> compactClockOf(Scanner &scanner)
{
    constexpr std::size_t length = 6;
    Scanner rest = scanner;
    const auto digits = rest.digits(length, length);
    if (!digits || *digits / 10000 >= 24 || *digits / 100 % 100 >= 60 || *digits % 100 > 60)
        return std::nullopt;
    scanner = rest;
    const long double seconds = 3600.0L * (*digits / 10000) + 60.0L * (*digits / 100 % 100) + *digits % 100;
    return ClockTime{seconds + scanner.fraction()};
}

/// "0.0333 sec", "33.3 ms"
std::optional<long double> durationOf(std::string_view cell, const NumberStyle &style)
{
    const std::size_t blank = cell.find_last_of(' ');
    if (blank == std::string_view::npos)
        return std::nullopt;
    const auto unit = timeUnitNamed(lowerCaseAscii(cell.substr(blank + 1)));
    const auto number = styledLongNumber(cell.substr(0, blank), style);
    if (!unit || *unit == TimeUnit::Frame || !number)
        return std::nullopt;
    return *number * nanosecondsPer(*unit) / nanosecondsPer(TimeUnit::Second);
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
    if (const auto seconds = durationOf(cell, style))
        return Stamp{Stamp::Kind::Duration, *seconds};
    Scanner clock(cell);
    if (const auto time = clockOf(clock); time && clock.atEnd())
        return time->lastPart ? Stamp{Stamp::Kind::Timecode, time->seconds + 0.01L * *time->lastPart}
                              : Stamp{Stamp::Kind::Clock, time->seconds};
    Scanner date(cell);
    const auto day = dayOf(date);
    if (!day || !date.skip("Tt /,"))
        return std::nullopt;
    date.skip(" ");
    auto time = clockOf(date);
    if (!time)
        time = compactClockOf(date);
    const auto zone = zoneOf(date);
    if (!time || time->lastPart || !zone)
        return std::nullopt;
    return Stamp{Stamp::Kind::Date, 86400.0L * *day + time->seconds - *zone};
}

} // namespace odo
