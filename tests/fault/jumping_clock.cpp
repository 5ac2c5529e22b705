// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in front of the C library's calendar clock: it jumps to and fro by an hour, a second and a day, each
// for a third of a second, as with a time server that cannot decide. The steady clocks are left alone.
#include <ctime>
#include <iterator>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

constexpr long jumpsS[] = {0, 3600, -3600, 1, -1, 86400, -86400};
constexpr long stretchNs = 300'000'000;

long jumpNow()
{
    timespec steady{};
    syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &steady);
    const long stretch = (steady.tv_sec * 1'000'000'000L + steady.tv_nsec) / stretchNs;
    return jumpsS[static_cast<unsigned long>(stretch) % std::size(jumpsS)];
}

} // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec *time)
{
    const long done = syscall(SYS_clock_gettime, clock, time);
    if (done == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
        time->tv_sec += jumpNow();
    return static_cast<int>(done);
}

int gettimeofday(timeval *time, void *)
{
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    *time = {now.tv_sec, now.tv_nsec / 1000};
    return 0;
}

time_t time(time_t *place)
{
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (place != nullptr)
        *place = now.tv_sec;
    return now.tv_sec;
}

} // extern "C"
