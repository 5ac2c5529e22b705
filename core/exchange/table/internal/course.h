// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/table/internal/raw_track.h"

#include <cstddef>
#include <vector>

namespace odo {

// What the positions of a track say of themselves, in the units of the file. Pure and thread-safe.

/// Too few rows say nothing.
constexpr std::size_t enoughForCourse = 10;

/// The measured rows of a track.
std::vector<std::size_t> measuredRows(const RawTrack &track);
double distanceOf(const RawTrack &track, std::size_t row, std::size_t other);

/// The value that so many percent of the values do not exceed; 0 of none.
double percentileOf(std::vector<double> values, double percent);
/// From the 5th to the 95th percentile of what is no NaN.
double spreadOf(const std::vector<double> &values);

struct CourseFacts
{
    double usualStep = 0;  ///< median of the steps between measured rows that are not 0
    double resolution = 0; ///< of the numbers: a power of ten
    double noise = 0;      ///< standard deviation of a coordinate, while it moves; 0 where that is not known
    double repeats = 0;    ///< share of the measured rows that repeat the one before
    std::size_t repeatRuns = 0; ///< how often a repetition begins
};
CourseFacts courseOf(const RawTrack &track);

/// Speeds between rows five apart, in units of the file a second.
double typicalSpeed(const RawTrack &track, const std::vector<Nanoseconds> &times);

} // namespace odo
