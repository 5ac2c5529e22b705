// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/track_times.h"

#include "core/base/percentile.h"
#include "core/exchange/table/internal/even_times.h"
#include "core/exchange/table/internal/table_reader.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t enoughRows = 10;   // to judge a unit by them
constexpr double mostStampSeconds = 4e9; // a century on both sides of 1970
constexpr auto longest = std::chrono::hours(24 * 7);
constexpr long double daySeconds = 86400;

/// The unit of stamps that count from 1970, by their size.
std::optional<TimeUnit> unitSince1970(long double stamp)
{
    constexpr long double from = 9e8, to = 4.2e9; // 1998 to 2103
    for (const TimeUnit unit :
         {TimeUnit::Second, TimeUnit::Millisecond, TimeUnit::Microsecond, TimeUnit::Nanosecond}) {
        const long double seconds = stamp * nanosecondsPer(unit) / nanosecondsPer(TimeUnit::Second);
        if (seconds > from && seconds < to)
            return unit;
    }
    return std::nullopt;
}

double medianStep(const std::vector<long double> &stamps)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < stamps.size(); ++i) {
        if (stamps[i] >= stamps[i - 1])
            steps.push_back(static_cast<double>(stamps[i] - stamps[i - 1]));
    }
    return steps.empty() ? 0 : upperMedian(std::move(steps));
}

bool areWhole(const std::vector<long double> &stamps)
{
    return std::ranges::all_of(stamps, [](long double stamp) { return stamp == std::round(stamp); });
}

Message chooseTimeUnit(TimeUnit likely)
{
    return ODO_TEXT("exchange.choose_time_unit",
                    "choose their unit: s, ms, us, ns, min, h, d or frame; %1 is likely")(
        std::string(wordOf(likely)));
}

constexpr double fewFrames = 5; // from row to row: no milliseconds

/// The unit that makes such steps plausible.
TimeUnit likelyUnit(double step, bool isWhole)
{
    constexpr double mostMs = 1000, mostUs = 1e6;
    if (step < fewFrames && isWhole)
        return TimeUnit::Frame;
    return step <= mostMs   ? TimeUnit::Millisecond
           : step <= mostUs ? TimeUnit::Microsecond
                            : TimeUnit::Nanosecond;
}

/// The unit, longer than a second, that makes such steps plausible.
TimeUnit likelyLongUnit(double step)
{
    constexpr double leastS = 0.005, minuteS = 60, hourS = 3600;
    return step * minuteS >= leastS ? TimeUnit::Minute
           : step * hourS >= leastS ? TimeUnit::Hour
                                    : TimeUnit::Day;
}

/// A spreadsheet's times are days since the end of 1899.
bool areSheetDays(const RawTrack &track)
{
    constexpr long double from = 29'000, to = 74'000; // 1979 to 2102
    constexpr double most = 10.0 / 86400;             // days from row to row
    const double step = medianStep(track.stamps);
    return track.size() >= enoughRows && step > 0 && step < most && track.stamps.front() > from &&
           track.stamps.back() < to && !areWhole(track.stamps);
}

/// Seconds, where rows are then as far apart as those of a robot's track; isSaid: the header says seconds.
Result<TimeUnit> secondsOr(const RawTrack &track, bool isSaid, const Understanding &how)
{
    // Seconds from row to row: a thousand rows a second are a quick log, more are minutes or days.
    constexpr double least = 9e-4, most = 1, mostIfSaid = 5;
    const double step = medianStep(track.stamps);
    if (track.size() < enoughRows || step == 0 ||
        (step < (isSaid ? mostIfSaid : most) && (isSaid || step >= least)))
        return TimeUnit::Second;
    const bool isWhole = areWhole(track.stamps);
    if (how.reading.rate && step < fewFrames && isWhole)
        return TimeUnit::Frame;
    if (step < least)
        return how.wrong(track.lines.front(),
                         ODO_TEXT("exchange.time_steps_too_short",
                                  "its times have no unit, and as seconds the rows would be %1 apart")(
                             quantity(step * 1e6, step < 1e-6 ? 3 : 0, "µs")),
                         chooseTimeUnit(likelyLongUnit(step)));
    const double lasts = static_cast<double>(track.stamps.back() - track.stamps.front());
    return how.wrong(track.lines.front(),
                     ODO_TEXT("exchange.time_steps_too_long",
                              "if its times are seconds, the rows are %1 apart and the run is %2 long")(
                         quantity(step, 1, "s"), quantity(lasts, 0, "s")),
                     chooseTimeUnit(likelyUnit(step, isWhole)));
}

Result<TimeUnit> unitOf(const RawTrack &track, const RawTable &table, Understanding &how)
{
    if (track.stampKind == Stamp::Kind::Timecode)
        return TimeUnit::Frame;
    if (track.stampKind != Stamp::Kind::Number)
        return TimeUnit::Second;
    if (!table.columns.time)
        return TimeUnit::Frame;
    if (how.reading.timeUnit)
        return *how.reading.timeUnit;
    const auto said = table.columns.time->unit;
    if (said && *said != TimeUnit::Second)
        return *said;
    if (track.stamps.empty())
        return TimeUnit::Second;
    if (!said && areSheetDays(track)) {
        how.facts.push_back(ODO_TEXT("exchange.times_in_days", "times in days, as spreadsheets write them"));
        return TimeUnit::Day;
    }
    if (const auto unit = said ? std::nullopt : unitSince1970(track.stamps[track.size() / 2])) {
        if (*unit != TimeUnit::Second)
            how.facts.push_back(
                ODO_TEXT("exchange.times_since_1970", "times in %1 since 1970")(std::string(wordOf(*unit))));
        return *unit;
    }
    return secondsOr(track, said.has_value(), how);
}

/// Seconds of the day go on behind midnight.
void passMidnight(RawTrack &track)
{
    long double added = 0;
    for (std::size_t i = 1; i < track.size(); ++i) {
        track.stamps[i] += added;
        if (track.stamps[i] < track.stamps[i - 1] - daySeconds / 2) {
            added += daySeconds;
            track.stamps[i] += daySeconds;
        }
    }
}

/// What "0:00:03:24" counts behind the seconds: the frames of each of them, where it takes all values from 0
/// to the last, as video programs write it; else hundredths, as Kinovea does. Then the stamps are seconds.
Result<void> readTimecodes(RawTrack &track, const Understanding &how)
{
    constexpr int mostFrames = 60;
    constexpr std::size_t leastFrames = 8;
    std::array<bool, 100> isThere{};
    std::vector<std::pair<long double, int>> parts;
    for (const long double stamp : track.stamps) {
        const long double seconds = std::floor(stamp + 1e-6L);
        parts.emplace_back(seconds, static_cast<int>(std::lround((stamp - seconds) * 100)));
        isThere[static_cast<std::size_t>(std::clamp(parts.back().second, 0, 99))] = true;
    }
    const auto last = std::ranges::find(isThere.rbegin(), isThere.rend(), true);
    const auto count = static_cast<std::size_t>(isThere.rend() - last);
    const auto values = static_cast<std::size_t>(std::ranges::count(isThere, true));
    if (count > mostFrames || values < leastFrames || 10 * values < 9 * count) {
        track.stampKind = Stamp::Kind::Clock;
        return {};
    }
    const auto perSecond = static_cast<long double>(std::round(how.reading.rate.value_or(0)));
    if (perSecond < static_cast<long double>(count))
        return how.wrong(track.lines.front(),
                         ODO_TEXT("exchange.timecode_without_rate",
                                  "the last part of its times counts frames, up to %1 a second")(count),
                         ODO_TEXT("exchange.give_rate", "give the frame rate of the camera"));
    for (std::size_t i = 0; i < track.size(); ++i)
        track.stamps[i] = parts[i].first * perSecond + parts[i].second;
    return {};
}

Result<std::vector<Nanoseconds>> converted(RawTrack &track, TimeUnit unit, const Understanding &how)
{
    if (unit == TimeUnit::Frame && !how.reading.rate)
        return how.wrong(track.lines.empty() ? 0 : track.lines.front(),
                         ODO_TEXT("exchange.frames_without_rate", "it has frame numbers in place of times"),
                         ODO_TEXT("exchange.give_rate", "give the frame rate of the camera"));
    const long double perUnit = unit == TimeUnit::Frame ? 1e9L / *how.reading.rate : nanosecondsPer(unit);
    std::vector<Nanoseconds> times;
    times.reserve(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        const long double nanoseconds = track.stamps[i] * perUnit;
        if (std::abs(nanoseconds) > mostStampSeconds * 1e9L)
            return how.wrong(track.lines[i],
                             ODO_TEXT("exchange.time_of_no_age", "its time is more than a century from 1970"),
                             ODO_TEXT("exchange.check_unit_of_times",
                                      "check the unit of the times, and that all lines are of one run"));
        times.emplace_back(std::llroundl(nanoseconds));
    }
    return times;
}

/// The rows outside the longest series that increases (Schensted 1961).
std::vector<bool> outOfOrder(const std::vector<Nanoseconds> &times)
{
    constexpr std::size_t nothing = static_cast<std::size_t>(-1);
    std::vector<std::size_t> ends, before(times.size(), nothing); // ends: the last row of a series so long
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto place =
            std::lower_bound(ends.begin(), ends.end(), times[i],
                             [&](std::size_t row, Nanoseconds time) { return times[row] < time; });
        before[i] = place == ends.begin() ? nothing : *(place - 1);
        if (place == ends.end())
            ends.push_back(i);
        else if (times[*place] != times[i]) // of equal ones the first is kept
            *place = i;
    }
    std::vector<bool> isOut(times.size(), true);
    for (std::size_t row = ends.empty() ? nothing : ends.back(); row != nothing; row = before[row])
        isOut[row] = false;
    return isOut;
}

void takeOut(RawTrack &track, std::vector<Nanoseconds> &times, const std::vector<bool> &isOut)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!isOut[i])
            times[kept++] = times[i];
    }
    times.resize(kept);
    track.remove(isOut);
}

/// Takes out the rows whose stamps fit nowhere, if they are few.
Result<void> takeOutBad(RawTrack &track, std::vector<Nanoseconds> &times, Understanding &how)
{
    const auto wrongAt = std::ranges::adjacent_find(times, std::greater_equal<>());
    if (wrongAt == times.end())
        return {};
    const auto row = static_cast<std::size_t>(wrongAt - times.begin()) + 1;
    const std::vector<bool> isOut = outOfOrder(times);
    const auto count = static_cast<std::size_t>(std::ranges::count(isOut, true));
    if (count > mostBadRows(times.size()))
        return how.wrong(
            track.lines[row], whyNotLater(times[row - 1], times[row]),
            ODO_TEXT("exchange.order_lines", "sort the lines by time, with each time only once"));
    const auto first = static_cast<std::size_t>(std::ranges::find(isOut, true) - isOut.begin());
    how.notices.push_back(
        count == 1 ? ODO_TEXT("exchange.stamp_left_out",
                              "line %1 was left out, because its time repeats or is out of order")(
                         track.lines[first])
                   : ODO_TEXT("exchange.stamps_left_out",
                              "%1 lines were left out, because their times repeat or are out of order; the "
                              "first is line %2")(count, track.lines[first]));
    takeOut(track, times, isOut);
    return {};
}

MessageArgument milliseconds(Nanoseconds time)
{
    return quantity(static_cast<double>(time.count()) / 1e6, time.count() % 1'000'000 == 0 ? 0 : 2, "ms");
}

/// Rows that a log has twice, with their stamps.
void takeOutTwins(RawTrack &track, std::vector<Nanoseconds> &times, Understanding &how)
{
    std::vector<bool> isTwin(times.size(), false);
    const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t i = 1; i < times.size(); ++i)
        isTwin[i] = times[i] == times[i - 1] && isSame(track.x[i], track.x[i - 1]) &&
                    isSame(track.y[i], track.y[i - 1]);
    const auto count = static_cast<std::size_t>(std::ranges::count(isTwin, true));
    if (times.size() < enoughRows || count <= mostBadRows(times.size()))
        return;
    how.notices.push_back(ODO_TEXT("exchange.twins_left_out",
                                   "%1 lines were left out, because they repeat the line before")(count));
    takeOut(track, times, isTwin);
}

/// A clock that was not set yet stamps 0 where all others count from 1970.
void takeOutUnset(RawTrack &track, Understanding &how)
{
    if (track.stampKind != Stamp::Kind::Number || track.size() < enoughRows ||
        !unitSince1970(track.stamps[track.size() / 2]))
        return;
    std::vector<bool> isUnset(track.size(), false);
    for (std::size_t i = 0; i < track.size(); ++i)
        isUnset[i] = track.stamps[i] == 0;
    const auto count = static_cast<std::size_t>(std::ranges::count(isUnset, true));
    if (count == 0 || count > mostBadRows(track.size()))
        return;
    how.notices.push_back(
        ODO_TEXT("exchange.unset_stamps", "lines left out because their time is 0: %1")(count));
    track.remove(isUnset);
}

/// Stamps that were rounded so much that it shows.
Result<void> unround(RawTrack &track, std::vector<Nanoseconds> &times, Understanding &how)
{
    const Nanoseconds resolution = resolutionOf(times);
    const EvenSpread spread = spreadEvenly(times, resolution);
    if (spread == EvenSpread::Much)
        how.notices.push_back(ODO_TEXT(
            "exchange.stamps_spread",
            "its times are rounded to %1; the lines were spread evenly, %2 frames/s")(
            milliseconds(resolution),
            quantity(static_cast<double>(times.size() - 1) / toSeconds(times.back() - times.front()), 2)));
    if (spread != EvenSpread::NotEven)
        return {};
    takeOutTwins(track, times, how);
    const std::size_t shared = sharedStamps(times);
    if (shared > mostBadRows(times.size()) && shared > 1)
        return how.wrong(
            track.lines.front(),
            ODO_TEXT("exchange.stamps_shared",
                     "its times are so coarse that %1 lines share theirs with the line before")(shared),
            ODO_TEXT("exchange.write_finer_times",
                     "write the times with more digits, or give the frame rate of an even series"));
    ODO_TRY(takeOutBad(track, times, how));
    if (spreadWithGaps(times, resolution) == EvenSpread::Much)
        how.notices.push_back(
            ODO_TEXT("exchange.stamps_spread_with_gaps",
                     "its times are rounded to %1; the lines were spread evenly, with gaps")(
                milliseconds(resolution)));
    return {};
}

/// What clocks show, as seconds or frames that go on.
Result<void> readClocks(RawTrack &track, const Understanding &how)
{
    if (track.stampKind == Stamp::Kind::Timecode)
        ODO_TRY(readTimecodes(track, how));
    if (track.stampKind == Stamp::Kind::Clock)
        passMidnight(track);
    return {};
}

} // namespace

Message whyNotLater(Nanoseconds before, Nanoseconds time)
{
    return time == before
               ? ODO_TEXT("exchange.time_repeated", "its time is the same as in the line before")
               : ODO_TEXT("exchange.time_goes_back", "its time is earlier than in the line before");
}

Result<std::vector<Nanoseconds>> statedTimesOf(RawTrack &track, const RawTable &table, Understanding &how)
{
    ODO_TRY(readClocks(track, how));
    const TimeUnit unit = ODO_TRY(unitOf(track, table, how));
    return converted(track, unit, how);
}

Result<std::vector<Nanoseconds>> timesOf(RawTrack &track, const RawTable &table, Understanding &how)
{
    ODO_TRY(readClocks(track, how));
    takeOutUnset(track, how);
    const bool isOneStamp =
        track.size() >= enoughRows && track.stamps.front() == track.stamps.back() && how.reading.rate;
    if (isOneStamp) {
        for (std::size_t i = 0; i < track.size(); ++i)
            track.stamps[i] = static_cast<long double>(i);
        how.notices.push_back(ODO_TEXT("exchange.times_by_rate",
                                       "all its times are the same; the lines were spread at %1 frames/s")(
            quantity(*how.reading.rate, 2)));
    }
    const TimeUnit unit = isOneStamp ? TimeUnit::Frame : ODO_TRY(unitOf(track, table, how));
    if (how.reading.rate && unit != TimeUnit::Frame)
        return how.wrong(0, ODO_TEXT("exchange.rate_beside_times", "it has times, and no frame numbers"),
                         ODO_TEXT("exchange.leave_out_rate", "leave out the frame rate"));
    auto times = ODO_TRY(converted(track, unit, how));
    ODO_TRY(unround(track, times, how));
    if (!times.empty() && times.back() - times.front() > longest) {
        const auto late =
            std::ranges::find_if(times, [&](Nanoseconds time) { return time - times.front() > longest; });
        return how.wrong(
            track.lines[static_cast<std::size_t>(late - times.begin())],
            ODO_TEXT("exchange.longer_than_a_week", "it is more than a week after the first line"),
            ODO_TEXT("exchange.check_unit_of_times",
                     "check the unit of the times, and that all lines are of one run"));
    }
    return times;
}

} // namespace odo
