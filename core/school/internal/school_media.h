// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/internal/school_hub.h"
#include "core/school/school_sync.h"

#include <filesystem>

namespace odo {

/// The school's folder of recordings: FOLDER/ab/abcd….mp4, each called after its SHA-256. A file appears
/// there whole or not at all, and is verified when it is read. On the project's thread.

/// Copies those recordings of this project that the folder lacks; adds their bytes to the report. A recording
/// whose file is missing or changed is warned of. Errors: Io, Cancelled.
Result<void> publishRecordings(Project &project, const std::filesystem::path &folder,
                               const JobControl &control, SchoolReport &report);

/// The file of a recording in the folder; empty: it is not there.
std::filesystem::path mediaFileOf(const std::filesystem::path &folder, const std::string &sha256);

/// Brings the recordings of one trial from elsewhere, all or none, and gives them to the trial. Warned of:
/// those that are not in the folder, with where their bench has them. Errors: Io, Cancelled.
Result<void> pullRecordings(Project &project, RecordId trial, const QByteArray &recordings,
                            const std::string &owner, const std::filesystem::path &folder,
                            const JobControl &control, SchoolReport &report);

} // namespace odo
