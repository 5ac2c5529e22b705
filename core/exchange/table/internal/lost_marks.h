// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/internal/understanding.h"

namespace odo {

/// The ways in which programs write "not measured". Each forgets the rows that it finds and says so. Any
/// thread.

/// Rows with a confidence below the least one: a person's, or 0.6 of columns from 0 to 1 (60 %). Errors: a
/// least confidence of a table without that column, and none left.
Result<void> forgetUnsure(RawTrack &track, Understanding &how);
/// Rows of 0, 0 or −1, −1 and the like to which the robot would leap.
void forgetMarks(RawTrack &track, Understanding &how);
/// Rows that repeat the last position while the robot went on, or more often than its noise allows. What a
/// tracker sees of a robot that rests may be the same in every frame: of those one a second is kept, as they
/// say the same thing.
void forgetHeld(RawTrack &track, const std::vector<Nanoseconds> &times, Understanding &how);

} // namespace odo
