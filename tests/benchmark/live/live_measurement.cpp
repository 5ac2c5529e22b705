// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/live_measurement.h"

#include <algorithm>

namespace odo::test {

bool LiveMeasurement::nothingLost() const
{
    return std::ranges::all_of(views, [](const LiveViewStatistics &view) {
        return view.recorded > 0 && view.played == view.recorded && view.lostByUs == 0 &&
               view.lostOnWire == view.skipped && view.spanned == view.recorded + view.lostOnWire;
    });
}

double LiveMeasurement::memoryPerMinuteMb() const
{
    constexpr double settledS = 60, leastS = 180;
    if (memory.empty() || memory.back().first < leastS)
        return 0;
    double n = 0, sumX = 0, sumY = 0, sumXx = 0, sumXy = 0;
    for (const auto &[timeS, megabytes] : memory) {
        if (timeS < settledS)
            continue;
        n += 1;
        sumX += timeS;
        sumY += megabytes;
        sumXx += timeS * timeS;
        sumXy += timeS * megabytes;
    }
    return 60 * (n * sumXy - sumX * sumY) / (n * sumXx - sumX * sumX);
}

} // namespace odo::test
