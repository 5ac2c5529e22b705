// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_times.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double tolerance = 0.1;

std::vector<Nanoseconds> intervalsOf(const std::vector<Nanoseconds> &times)
{
    std::vector<Nanoseconds> intervals;
    for (std::size_t i = 1; i < times.size(); ++i)
        intervals.push_back(times[i] - times[i - 1]);
    return intervals;
}

FrameSpacing spacingOfIntervals(const std::vector<Nanoseconds> &intervals)
{
    if (intervals.empty())
        return {};
    std::vector<Nanoseconds> sorted = intervals;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    const Nanoseconds median = *middle;
    // Times rounded to milliseconds have a median of 33 ms at 30 frames/s: the mean of the ordinary intervals
    // is better.
    Nanoseconds ordinarySum{0};
    std::int64_t ordinary = 0;
    for (const Nanoseconds interval : intervals) {
        if (std::abs(toSeconds(interval - median)) <= tolerance * toSeconds(median)) {
            ordinarySum += interval;
            ++ordinary;
        }
    }
    return {ordinary > 0 ? ordinarySum / ordinary : median,
            ordinary < static_cast<std::int64_t>(intervals.size())};
}

} // namespace

FrameSpacing spacingOf(const std::vector<Nanoseconds> &frameTimes)
{
    return spacingOfIntervals(intervalsOf(frameTimes));
}

std::vector<Nanoseconds> fieldTimes(const std::vector<Nanoseconds> &frameTimes)
{
    const Nanoseconds usual = spacingOf(frameTimes).usual;
    std::vector<Nanoseconds> times;
    times.reserve(2 * frameTimes.size());
    for (std::size_t i = 0; i < frameTimes.size(); ++i) {
        const bool isLast = i + 1 == frameTimes.size();
        const Nanoseconds untilNext = isLast ? usual : std::min(usual, frameTimes[i + 1] - frameTimes[i]);
        times.push_back(frameTimes[i]);
        times.push_back(frameTimes[i] + std::max(Nanoseconds(1), untilNext / 2));
    }
    return times;
}

std::optional<UnevenRate> unevenRate(const std::vector<Nanoseconds> &frameTimes)
{
    constexpr double share = 0.05;
    const std::vector<Nanoseconds> intervals = intervalsOf(frameTimes);
    const FrameSpacing spacing = spacingOfIntervals(intervals);
    if (!spacing.isVariable || spacing.usual.count() <= 0)
        return std::nullopt;
    const auto offBeat = [usualS = toSeconds(spacing.usual)](Nanoseconds interval) {
        const double beats = toSeconds(interval) / usualS;
        return std::abs(beats - std::max(1.0, std::round(beats))) > tolerance;
    };
    if (static_cast<double>(std::ranges::count_if(intervals, offBeat)) <
        share * static_cast<double>(intervals.size()))
        return std::nullopt;
    const auto [shortest, longest] = std::ranges::minmax(intervals);
    return UnevenRate{shortest, longest};
}

Message unevenRateWords(const std::vector<Nanoseconds> &frameTimes)
{
    const auto uneven = unevenRate(frameTimes);
    if (!uneven)
        return {};
    return joined({ODO_TEXT("video.rate_varies", "its frame rate varies: frames are %1 to %2 apart")(
                       quantity(1e3 * toSeconds(uneven->shortest), 0),
                       quantity(1e3 * toSeconds(uneven->longest), 0, "ms")),
                   ODO_TEXT("video.each_at_its_time", "each frame keeps its own time")},
                  Join::Semicolon);
}

} // namespace odo
