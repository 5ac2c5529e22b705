// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/machine_sleep.h"

#include <algorithm>
#include <atomic>
#include <ctime>

namespace odo {

namespace {

using namespace std::chrono_literals;

// Between the readings of two clocks this thread may be interrupted; it tries again for a quicker reading.
constexpr Nanoseconds quickLook = 20us, shortestSleep = 1ms;
constexpr int mostLooks = 10;

Nanoseconds read(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

/// What CLOCK_BOOTTIME, which goes on, is ahead of CLOCK_MONOTONIC by.
struct Ahead
{
    Nanoseconds least, most;
};

Ahead look()
{
    const Nanoseconds before = read(CLOCK_MONOTONIC), on = read(CLOCK_BOOTTIME),
                      after = read(CLOCK_MONOTONIC);
    return {on - after, on - before};
}

} // namespace

/// The same value until the machine sleeps again, so that no clock trembles by how long a look takes.
Nanoseconds machineSlept()
{
    constexpr Nanoseconds::rep unknown = -1;
    static std::atomic<Nanoseconds::rep> known = unknown;
    Ahead ahead = look();
    const Nanoseconds before(known.load());
    if (before.count() != unknown && before > ahead.least - shortestSleep &&
        before < ahead.most + shortestSleep)
        return before;
    for (int i = 0; i < mostLooks && ahead.most - ahead.least > quickLook; ++i)
        ahead = look();
    const Nanoseconds slept = std::max(Nanoseconds(0), ahead.least + (ahead.most - ahead.least) / 2);
    Nanoseconds::rep expected = before.count();
    // Who finds it out at the same time says the same.
    return known.compare_exchange_strong(expected, slept.count()) ? slept : Nanoseconds(expected);
}

} // namespace odo
