// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>

namespace odo::test {

/// CPU time of the calling thread: what other programs do does not count, as it would in time by the clock.
inline double threadCpuS()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What a look at the clock costs (half a microsecond, a call of the kernel): it is in every stretch that is
/// clocked, and no part of the work in it.
inline double clockCostS()
{
    static const double cost = [] {
        double least = 1;
        for (int i = 0; i < 1000; ++i) {
            const double begin = threadCpuS();
            least = std::min(least, threadCpuS() - begin);
        }
        return least;
    }();
    return cost;
}

/// CPU time from `begin` to `end`, both told by threadCpuS().
inline double workS(double begin, double end)
{
    return end - begin - clockCostS();
}

} // namespace odo::test
