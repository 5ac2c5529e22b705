// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/internal/understanding.h"

#include <vector>

namespace odo {

/// The times of a track's rows, strictly increasing, and takes out the few rows whose stamps fit nowhere. The
/// unit is the one that a person, the header or the format says; stamps since 1970 say it by their size.
/// Stamps that were rounded are spread where the rows come at an even rate. Errors: a unit that is not said
/// and not clear, frame numbers without a rate, stamps out of order, rows that share stamps and are not even,
/// a track of more than a week.
Result<std::vector<Nanoseconds>> timesOf(RawTrack &track, const RawTable &table, Understanding &how);

/// The same with every row at the very time that it states, in whatever order.
Result<std::vector<Nanoseconds>> statedTimesOf(RawTrack &track, const RawTable &table, Understanding &how);

/// Why a time cannot follow another one that is not earlier.
Message whyNotLater(Nanoseconds before, Nanoseconds time);

} // namespace odo
