// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_intervals.h"

#include "core/video/frame_times.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double longestShown = 4.5; ///< usual intervals

/// The next larger of 1, 2 and 5 times a power of ten, from a microsecond on.
Nanoseconds roundWidth(double nanoseconds)
{
    double width = 1000;
    while (width < nanoseconds)
        for (const double step : {2.0, 2.5, 2.0}) // 1, 2, 5, 10
            width *= width < nanoseconds ? step : 1;
    return Nanoseconds(static_cast<std::int64_t>(width));
}

void addBins(const std::vector<Nanoseconds> &intervals, FrameIntervals &result)
{
    const auto longest = static_cast<std::int64_t>(longestShown * static_cast<double>(result.usual.count()));
    // A tenth of the usual interval to either side, so what hardly varies does not fill the axis.
    const Nanoseconds shortest = std::min(result.shortest, result.usual * 9 / 10);
    const Nanoseconds last = std::max(std::min(result.longest, Nanoseconds(longest)), result.usual * 11 / 10);
    const Nanoseconds width =
        roundWidth(static_cast<double>((last - shortest).count()) / (mostIntervalBins - 2));
    const std::int64_t first = shortest.count() / width.count();
    const auto count = static_cast<std::size_t>(last.count() / width.count() - first + 1);
    result.bins.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = first + static_cast<std::int64_t>(i);
        result.bins[i] = {width * number, width * (number + 1), 0};
    }
    for (const Nanoseconds interval : intervals) {
        if (interval > last)
            ++result.longer;
        else
            ++result.bins[static_cast<std::size_t>(interval.count() / width.count() - first)].count;
    }
}

} // namespace

FrameIntervals frameIntervals(const std::vector<Nanoseconds> &frameTimes)
{
    constexpr double fromGap = 1.5, ordinaryShare = 0.1;
    FrameIntervals result;
    std::vector<Nanoseconds> intervals;
    for (std::size_t i = 1; i < frameTimes.size(); ++i)
        intervals.push_back(std::max(Nanoseconds(0), frameTimes[i] - frameTimes[i - 1]));
    if (intervals.empty())
        return result;
    result.count = static_cast<std::int64_t>(intervals.size());
    result.usual = spacingOf(frameTimes).usual;
    const auto [shortest, longest] = std::ranges::minmax(intervals);
    result.shortest = shortest;
    result.longest = longest;
    const double usual = toSeconds(result.usual);
    double squares = 0, counted = 0, ordinarySquares = 0, ordinary = 0;
    for (const Nanoseconds interval : intervals) {
        const double apart = toSeconds(interval) - usual;
        result.repeated += interval.count() == 0 ? 1 : 0;
        if (usual > 0 && toSeconds(interval) >= fromGap * usual) {
            ++result.gaps;
            result.missing += std::max<std::int64_t>(1, std::llround(toSeconds(interval) / usual) - 1);
            continue;
        }
        squares += apart * apart;
        counted += 1;
        if (std::abs(apart) <= ordinaryShare * usual) {
            ordinarySquares += apart * apart;
            ordinary += 1;
        }
    }
    if (counted > 0) {
        result.jitterS = std::sqrt(squares / counted);
        result.jitterSigmaS = result.jitterS / std::sqrt(2 * counted);
    }
    if (ordinary > 0)
        result.usualSigmaS = std::sqrt(ordinarySquares) / ordinary;
    addBins(intervals, result);
    return result;
}

} // namespace odo
