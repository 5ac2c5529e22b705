// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/units.h"
#include "core/project/records.h"
#include "core/workflow/import/recording_source.h"
#include "core/workflow/media_copy.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct ImportSettings;

/// What a view of an import is made of, and what is found of it.
struct ViewSource
{
    RecordingSource source;
    Message remark;                 ///< a sentence on missing images, or empty
    std::filesystem::path table;    ///< of frame times; empty: none
    std::filesystem::path file;     ///< its one video, after findFile
    std::vector<Nanoseconds> times; ///< of its frames, after findFile; empty: as the file says
    std::optional<MediaCopy> made;  ///< the file, where it was made in the media folder
};

/// Of all views. Looks at names alone; quick. Errors: those of recordingSourceOf, a file that cannot be read,
/// one that several views were given, frame times of no view, two tables or a table and a rate for one view,
/// images without times, or whose numbers count no frames and which have no table.
Result<std::vector<ViewSource>> viewSourcesOf(const ImportSettings &settings);

/// Reads the table of a view, if it has one, and makes one video of chapters or images. Gives whole
/// sentences that the user should know. Any thread. Errors: those of readFrameTimes and makeRecording,
/// another number of times than of images.
Result<std::vector<Message>> findFile(ViewSource &view, const ImportSettings &settings, std::size_t index,
                                      const std::filesystem::path &mediaFolder, const JobControl &control);

/// When the views were filmed: the earliest that their headers say (the latest where they are over a day
/// apart), or else when the files were last written, if a clock that was set can have said so; nullopt: none.
/// Opens the files.
std::optional<Instant> filmedAt(const std::vector<ViewSource> &views);

/// By the usual interval, frames/s; 0 of a single frame.
double rateOfTimes(const std::vector<Nanoseconds> &times);

/// What the project's list of changes says; of what several files were made into one, their names too.
Message importChange(const std::string &trial, const std::vector<ViewSource> &views);

} // namespace odo
