// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording_outcome.h"

#include "core/base/percentile.h"
#include "core/capture/clock_map.h"

#include <algorithm>
#include <span>

namespace odo {

namespace {

using namespace std::chrono_literals;

// ClockMap remembers 30 s: what it knows 15 s later has a picture in its middle.
constexpr Nanoseconds lookAhead = 15s, knotEach = 10s, shortestStep = 1us;

/// The clock as it was known around a device time.
struct Knot
{
    Nanoseconds device;
    ClockFit fit;
};

/// Pictures between which the camera's clock was not set anew.
using Stretch = std::span<const RawTime>;

/// Feeds a clock map with a stretch, the readings among the pictures as they came.
std::vector<Knot> knotsOf(Stretch pictures, std::span<const ClockReading> readings)
{
    std::vector<Knot> knots;
    ClockMap clock;
    ClockFit newest;
    Nanoseconds next = pictures.front().device + lookAhead;
    for (const RawTime &picture : pictures) {
        while (!readings.empty() && readings.front().after <= picture.arrival) {
            clock.addLatch(readings.front().device, readings.front().before, readings.front().after);
            readings = readings.subspan(1);
        }
        clock.addArrival(picture.device, picture.arrival);
        newest = clock.fit().value_or(newest);
        if (picture.device >= next + lookAhead) {
            knots.push_back({next, newest});
            next += knotEach;
        }
    }
    knots.push_back({std::max(next, pictures.back().device - lookAhead), newest});
    return knots;
}

/// Between two knots from the one to the other, so that no picture jumps.
Nanoseconds hostTime(const std::vector<Knot> &knots, Nanoseconds device)
{
    const auto after =
        std::ranges::find_if(knots, [device](const Knot &knot) { return knot.device >= device; });
    if (after == knots.begin())
        return knots.front().fit.hostTime(device);
    if (after == knots.end())
        return knots.back().fit.hostTime(device);
    const auto before = after - 1;
    const double share = toSeconds(device - before->device) / toSeconds(after->device - before->device);
    const Nanoseconds from = before->fit.hostTime(device), to = after->fit.hostTime(device);
    return from + fromSeconds(share * toSeconds(to - from));
}

/// Whether no clock that just goes on can show both: the steps of the two clocks differ, whatever moment of
/// each round trip the camera's was read at.
bool isSetAnewBetween(const ClockReading &a, const ClockReading &b)
{
    const Nanoseconds step = b.device - a.device;
    const Nanoseconds bound = largestClockJump + fromSeconds(fastestClockRate * std::abs(toSeconds(step)));
    return (b.before - a.after) - step > bound || step - (b.after - a.before) > bound;
}

/// The first picture on the new scale, where the clock was set anew between two readings: that whose step
/// from the one before is least like the usual one, of those between the readings. Arrivals do not tell:
/// pictures from before may be late by seconds.
std::size_t firstOnNewScale(Stretch pictures, const ClockReading &before, const ClockReading &after)
{
    const auto [from, to] = std::minmax(before.device, after.device);
    std::vector<Nanoseconds> steps;
    for (std::size_t i = 1; i < pictures.size(); ++i)
        steps.push_back(pictures[i].device - pictures[i - 1].device);
    const Nanoseconds usual = steps.empty() ? 0ns : upperMedian(steps);
    std::size_t first = pictures.front().device > to ? 0 : pictures.size();
    Nanoseconds oddest{-1};
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        const Nanoseconds odd = std::chrono::abs(steps[i - 1] - usual);
        if (pictures[i].device >= from && pictures[i - 1].device <= to && odd > oddest) {
            oddest = odd;
            first = i;
        }
    }
    return first;
}

/// How many pictures and readings lie before the next time the camera's clock was set anew.
struct StretchSize
{
    std::size_t pictures, readings;
};

StretchSize nextStretch(Stretch pictures, std::span<const ClockReading> readings)
{
    const auto back = std::ranges::adjacent_find(
        pictures, [](const RawTime &a, const RawTime &b) { return b.device < a.device; });
    const auto backwards =
        back == pictures.end() ? pictures.size() : static_cast<std::size_t>(back - pictures.begin()) + 1;
    const auto set = std::ranges::adjacent_find(readings, isSetAnewBetween);
    if (set != readings.end()) {
        const auto count = static_cast<std::size_t>(set - readings.begin()) + 1;
        if (set[1].device < set->device && backwards < pictures.size())
            return {backwards, count};
        const std::size_t first = firstOnNewScale(pictures.first(backwards), set[0], set[1]);
        if (first < backwards || backwards == pictures.size())
            return {first, count};
    }
    const auto later = std::ranges::find_if(readings, [&](const ClockReading &reading) {
        return backwards < pictures.size() && reading.after > pictures[backwards - 1].arrival;
    });
    return {backwards, static_cast<std::size_t>(later - readings.begin())};
}

void deriveStretch(Stretch pictures, std::span<const ClockReading> readings, DerivedTimes &into)
{
    const std::vector<Knot> knots = knotsOf(pictures, readings);
    for (const Knot &knot : knots)
        into.sigmaS = std::max(into.sigmaS, knot.fit.sigmaS);
    for (const RawTime &picture : pictures) {
        Nanoseconds taken = hostTime(knots, picture.device);
        if (!into.taken.empty())
            taken = std::max(taken, into.taken.back() + shortestStep);
        into.taken.push_back(taken);
    }
}

} // namespace

DerivedTimes deriveTimes(const RecordedTimes &times)
{
    DerivedTimes derived;
    Stretch left(times.pictures);
    std::span<const ClockReading> readings(times.readings);
    while (!left.empty()) {
        const StretchSize size = nextStretch(left, readings);
        if (size.pictures > 0)
            deriveStretch(left.first(size.pictures), readings.first(size.readings), derived);
        left = left.subspan(size.pictures);
        readings = readings.subspan(size.readings);
    }
    return derived;
}

Message putDiskBack()
{
    return ODO_TEXT("capture.put_disk_back", "put its disk or folder back where it was");
}

} // namespace odo
