// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace odo {

/// Messages about a file that cannot be used, the same everywhere. because: the system's own words.
Message cannotBeRead(std::string because);
Message cannotBeRead();
Message cannotBeWritten(std::string because);
Message cannotWriteFile(const std::filesystem::path &file); ///< what an error is about
Message fileIsEmpty();
Message noSuchFile();
Message noSuchFolder(const std::filesystem::path &folder);
Message isThereAlready();

/// The Io of a file of which the system does not say what it is; the InvalidInput of one that cannot be made.
tl::unexpected<Error> cannotBeInspected(Message what, const std::error_code &problem, Message advice);
tl::unexpected<Error> nameIsTooLong(Message what);

/// Advice.
Message nameAFile();
Message chooseAnotherName();
Message chooseAnotherNameOrFolder();
Message chooseFolderWithSpace();
Message chooseWritableFolder();
Message freeDiskSpace();
Message checkItsFolder(); ///< its free space and rights
Message makeFolderFirst();
Message checkFileMayBeRead();
Message checkFileIsThere();

} // namespace odo
