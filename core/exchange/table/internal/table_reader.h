// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/track_reading.h"

#include <filesystem>

namespace odo {

/// Reads the rows of a file of finished tracks, whoever has written it, with its numbers as they are. Twice
/// where what parts its cells leaves open how it writes numbers. At most 256 MiB and 1.5 million positions;
/// asks for cancellation. Any thread. Errors, with file and line: no such content, numbers that can be read
/// in two ways, a wrong number of cells, a value that is no number, half a position.
Result<RawTable> readRawTable(const std::filesystem::path &file, const TrackReading &reading,
                              const JobControl &control);

/// "run.csv:12", as messages call it.
Message atLineOf(const std::filesystem::path &file, const TrackReading &reading, int line);

/// How many rows of so many may be bad before the file is refused.
std::size_t mostBadRows(std::size_t rows);

Message beginWithHeaderOrTum(); ///< advice

} // namespace odo
