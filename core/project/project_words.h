// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <filesystem>
#include <system_error>

namespace odo {

/// What a project says and who works with one says too, the same words everywhere.

/// What errors are about.
Message copySubject(const std::filesystem::path &copy); ///< the name alone
Message undoSubject();
Message redoSubject();
Message findStrayFiles();
Message searchIn(const std::filesystem::path &folder);

Message isMissing(Message what); ///< "the recording of view 'A' is missing"
Message recordingWasCutOff();
Message readingFile(const std::filesystem::path &file); ///< of a job, by the file's name alone

/// The Io of a folder that cannot be searched, and the InvalidInput of a trial with more than mostViews.
tl::unexpected<Error> cannotSearch(const std::filesystem::path &folder, const std::error_code &problem);
tl::unexpected<Error> tooManyViews(Message what, std::size_t views);

/// Advice.
Message checkProjectFolder(); ///< its free space and rights
Message waitUntilThatHasEnded();
Message endRecordingFirst();
Message restoreAndReopen(); ///< a file, and the project
Message trackTrialAgain();

} // namespace odo
