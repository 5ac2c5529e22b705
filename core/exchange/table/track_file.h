// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/exchange/table/track_reading.h"
#include "core/trajectory/imported_track.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// One track of a file. A missing position is one that the file leaves blank or marks as lost.
struct FileTrack
{
    std::string name; ///< as the file has it; of several without names their number; else empty
    std::vector<ImportedPosition> positions;
    double roundedM = 0; ///< what its numbers are rounded to, where the robot often stays within it; else 0
    std::vector<Message> facts = {};   ///< how it was read, where the header alone does not say it
    std::vector<Message> notices = {}; ///< what was left out, and why
};

/// A finished track as another program, or our own export, has written it.
struct TrackFile
{
    TrackFormat format = TrackFormat::Csv;
    /// at least one, each with three positions or more
    std::vector<FileTrack> tracks;
};

/// Reads a file of finished tracks, recognising by its content who has written it (docs/formats.md): columns
/// by their names, the decimal sign by all numbers, units by the header, the format or a person; marks of
/// lost positions are blanks, and rows that cannot be right are left out with a notice. What remains open
/// and would change the metrics is an Error that says what to choose. Times are not shifted to zero. At most
/// 256 MiB. Any thread; asks for cancellation. Errors, with file and line: no such content, a wrong number of
/// cells, a value that is no number, more than a few times that do not increase, a position beyond 100 km, a
/// track over more than a week or with fewer than three positions.
Result<TrackFile> readTrackFile(const std::filesystem::path &file, const TrackReading &reading,
                                const JobControl &control);

} // namespace odo
