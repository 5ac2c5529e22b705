// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/units.h"
#include "core/exchange/table/track_reading.h"

#include <filesystem>
#include <vector>

namespace odo {

/// Reads when the frames of a video were taken: a table beside it with one row a frame, in their order, as
/// times since the first, strictly increasing. The column is found by its name, as in tables of tracks
/// (docs/formats.md); without a header it is the first one, or the second where the first counts the rows.
/// Units as of a track: of the header, of `reading`, or by the size of stamps since 1970. At most 256 MiB.
/// Any thread; asks for cancellation. Errors, with file and line: no time, one that is blank, no number or
/// not later than the one before, a unit that is not said and not clear, frame numbers in place of times,
/// numbers that can be read in two ways.
Result<std::vector<Nanoseconds>> readFrameTimes(const std::filesystem::path &file,
                                                const TrackReading &reading, const JobControl &control);

} // namespace odo
