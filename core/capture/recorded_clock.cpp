// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recorded_clock.h"

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
    std::span<const RawTime> left(times.pictures);
    std::span<const ClockReading> readings(times.readings);
    while (!left.empty()) {
        const auto end = std::ranges::adjacent_find(
            left, [](const RawTime &a, const RawTime &b) { return b.device < a.device; });
        const auto length =
            static_cast<std::size_t>(end == left.end() ? end - left.begin() : end - left.begin() + 1);
        const Stretch stretch = left.first(length);
        left = left.subspan(length);
        const auto later = std::ranges::find_if(readings, [&](const ClockReading &reading) {
            return !left.empty() && reading.after > stretch.back().arrival;
        });
        const auto own = static_cast<std::size_t>(later - readings.begin());
        deriveStretch(stretch, readings.first(own), derived);
        readings = readings.subspan(own);
    }
    return derived;
}

} // namespace odo
