// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/trajectory/imported_track.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

enum class TrackFormat { Tum, Csv, Tracker };
/// "tum", "csv", "tracker".
std::string_view trackFormatWord(TrackFormat format);

/// One track of a file. A missing position is one that the file leaves blank.
struct FileTrack
{
    std::string name; ///< as the file has it; may be empty
    std::vector<ImportedPosition> positions;
};

/// A finished track as another program, or our own export, has written it.
struct TrackFile
{
    TrackFormat format = TrackFormat::Csv;
    /// at least one, each with three positions or more; only Tracker text has several
    std::vector<FileTrack> tracks;
};

/// Reads a file of finished tracks, recognising by its content what it is: TUM (`timestamp tx ty tz qx qy qz
/// qw`; the yaw is the heading), a table with a header (readTrackHeader; parted by tabs, `;`, `,` or blanks,
/// decimals with a point or comma), or Tracker's text. Metres and seconds, as in the file: times are not
/// shifted to zero. At most 256 MiB. Any thread; asks for cancellation. Errors, with file and line: no such
/// content, a wrong number of cells, a value that is no finite number, times that do not increase, a position
/// beyond 100 km, a track over more than a week or with fewer than three positions.
Result<TrackFile> readTrackFile(const std::filesystem::path &file, const JobControl &control);

} // namespace odo
