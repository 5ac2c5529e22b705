// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace odo::test {

/// What the library failing_calls is told and what it tells, in memory that a test shares with the process it
/// tests. Of the calls on files below a folder the nth one fails, of all threads together. Which calls count
/// depends on the error: a full disk (ENOSPC) refuses to write, make, name, enlarge and sync; a folder that
/// has become read-only (EROFS) refuses all that changes it; a failing disk (EIO) refuses anything, reading
/// too where `reads` says so. A process is killed at calls that change something.
struct FailingCalls
{
    enum class How : int {
        Once,
        FromThenOn,   ///< a full disk still takes half of the first
        Killed,       ///< SIGKILL instead of the call
        KilledHalfway ///< half of it is written, then SIGKILL
    };

    char folder[512] = {};
    int nth = 0; ///< counted from 1; 0: none, all are counted
    int error = 0;
    How how = How::Once;
    bool reads = false;
    std::atomic<int> count = 0, failed = 0;
    char call[32] = {}, path[512] = {}; ///< of the first that failed
};

/// The environment variable with the file that a program under test maps as its FailingCalls.
constexpr const char *failingCallsVariable = "ODOGRAPH_FAILING_CALLS";

/// From now on calls of this process fail so; null: none. Of the library, which a test links or preloads.
extern "C" void odographSetFailingCalls(FailingCalls *set);

} // namespace odo::test
