// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace odo::test {

/// CPU time of the calling thread: what other programs do does not count, as it would in time by the clock.
inline double threadCpuS()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace odo::test
