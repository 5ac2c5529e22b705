// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/project/records.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// Recordings and their frame times as rows; TrialRepository's part of them.
Result<RecordId> addRecording(ProjectConnection &connection, const RecordingRecord &recording);
/// Position, file size and hash, image size, rate, sync and frame times of a recording that is there, by
/// its id.
Result<void> updateRecording(ProjectConnection &connection, const RecordingRecord &recording);
Result<std::vector<RecordingRecord>> recordingsOf(const ProjectConnection &connection, RecordId trial);
Result<std::vector<RecordingRecord>> recordingsWithoutTimes(const ProjectConnection &connection);
Result<std::optional<RecordingRecord>> newestRecordingOf(const ProjectConnection &connection,
                                                         RecordId camera);

/// How a path is stored: relative to the project's folder, with '/', when the file lies in it or below, so
/// that folder and project can move together; absolute otherwise.
std::string storedPath(const std::filesystem::path &projectFile, const std::filesystem::path &file);

/// The project's file, links followed, absolute and without "." and "..": what belongs to a project is
/// beside the file itself, by whatever name it was opened.
std::filesystem::path realProjectFile(const std::filesystem::path &projectFile);
/// "<name>.media" beside that.
std::filesystem::path mediaFolderOf(const std::filesystem::path &projectFile);

/// Where the file of a recording is. A relative path that would climb out of the project's folder is cut to
/// its file name: a project from elsewhere cannot point at other files that way. What was stored in the media
/// folder of a project that was renamed since, together with that folder, is in today's. Looks at the disk.
std::filesystem::path absolutePath(const std::filesystem::path &projectFile, const std::string &path);

/// SHA-256 of a file in lower-case hexadecimal. Any thread. Errors: NotFound, Io, Cancelled.
Result<std::string> fileSha256(const std::filesystem::path &file, const JobControl &control);

} // namespace odo
