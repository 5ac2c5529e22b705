// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmark/metrics.h"

#include <array>
#include <cstdint>

namespace odo::test {

/// What became of one view.
struct LiveViewStatistics
{
    std::uint64_t recorded = 0;   ///< pictures in the project with their times
    std::uint64_t played = 0;     ///< pictures that the file has
    std::uint64_t spanned = 0;    ///< from the first to the last recorded one by the camera's own count
    std::uint64_t lostOnWire = 0; ///< as the program counted them
    std::uint64_t lostByUs = 0;
    std::uint64_t skipped = 0; ///< that the camera was told to lose
};

/// What a live recording cost and gave.
struct LiveMeasurement
{
    std::array<LiveViewStatistics, 2> views;
    double seconds = 0; ///< that was recorded
    double cores = 0;   ///< processor time of this process by time
    std::vector<double>
        latenciesMs; ///< of each position that the map painted, from the middle of the exposure
    std::uint64_t positions = 0, notTracked = 0;
    double longestBusyMs = 0;                      ///< of the window's thread, processor time
    std::vector<std::pair<double, double>> memory; ///< seconds since the beginning, resident MB
    std::uint64_t bytes = 0;                       ///< of both files

    bool nothingLost() const;
    /// By which it grows from the second minute on, by a straight line through all; 0 of a recording shorter
    /// than three.
    double memoryPerMinuteMb() const;
};

} // namespace odo::test
