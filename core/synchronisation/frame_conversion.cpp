// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/frame_conversion.h"

#include "core/base/percentile.h"
#include "core/synchronisation/internal/clean_track.h"
#include "core/video/frame_times.h"

#include <algorithm>
#include <set>

namespace odo {

namespace {

constexpr std::size_t fewestRepeats = 8;
constexpr std::int64_t longestCycle = 12, shortestCycle = 3;
constexpr double leastInPhase = 0.9, leastSeen = 0.5;
constexpr double timedShare = 0.8; // of the usual interval, before a repeated frame

/// How many of the frames are at the most frequent place of a cycle, and that place.
struct Phase
{
    std::size_t count = 0;
    std::int64_t place = 0;
};

Phase phaseOf(const std::set<std::int64_t> &frames, std::int64_t cycle)
{
    std::vector<std::size_t> counts(static_cast<std::size_t>(cycle));
    for (const std::int64_t frame : frames)
        ++counts[static_cast<std::size_t>(frame % cycle)];
    const auto most = std::ranges::max_element(counts);
    return {*most, most - counts.begin()};
}

} // namespace

std::optional<FrameConversion> findConversion(const std::vector<FrameTrack> &tracks,
                                              const std::vector<Nanoseconds> &frameTimes)
{
    std::set<std::int64_t> repeats;
    for (const FrameTrack &track : tracks)
        for (const std::int64_t frame : cleaned(track).repeats)
            if (frame > 0 && frame < static_cast<std::int64_t>(frameTimes.size()))
                repeats.insert(frame);
    if (repeats.size() < fewestRepeats)
        return std::nullopt;
    const auto span = double(*repeats.rbegin() - *repeats.begin());
    for (std::int64_t cycle = longestCycle; cycle >= shortestCycle; --cycle) {
        const Phase phase = phaseOf(repeats, cycle);
        if (double(phase.count) < leastInPhase * double(repeats.size()) ||
            double(phase.count) < leastSeen * span / double(cycle))
            continue;
        std::vector<double> before;
        for (const std::int64_t frame : repeats)
            before.push_back(toSeconds(frameTimes[std::size_t(frame)] - frameTimes[std::size_t(frame - 1)]));
        const bool isTimed = median(std::move(before)) < timedShare * toSeconds(spacingOf(frameTimes).usual);
        return FrameConversion{cycle, phase.place > 0 ? phase.place : cycle, isTimed};
    }
    return std::nullopt;
}

std::vector<Nanoseconds> convertedTimes(const FrameConversion &conversion,
                                        const std::vector<Nanoseconds> &frameTimes)
{
    const auto count = static_cast<std::int64_t>(frameTimes.size());
    const double usualS = toSeconds(spacingOf(frameTimes).usual), fresh = double(conversion.every - 1);
    const auto timeS = [&](std::int64_t frame) { return toSeconds(frameTimes[std::size_t(frame)]); };
    std::vector<double> times(frameTimes.size());
    // cycles begin behind a repeated frame, the first perhaps before the video
    for (std::int64_t start = conversion.first + 1 - conversion.every; start < count;
         start += conversion.every) {
        const std::int64_t next = start + conversion.every;
        double fromS = 0, toS = double(conversion.every) * usualS;
        if (start >= 0 && next < count) {
            fromS = timeS(start);
            toS = timeS(next);
        } else if (start >= 0) {
            fromS = timeS(start);
            toS += fromS;
        } else if (next < count) {
            fromS = timeS(next) - toS;
            toS = timeS(next);
        }
        for (std::int64_t frame = std::max<std::int64_t>(0, start); frame < std::min(next, count); ++frame) {
            const auto place = double(frame - start);
            times[std::size_t(frame)] =
                fromS + (toS - fromS) * (frame + 1 < next ? place : place - 0.5) / fresh;
        }
    }
    std::vector<Nanoseconds> taken;
    for (const double time : times)
        taken.push_back(fromSeconds(time - times.front()));
    return taken;
}

} // namespace odo
