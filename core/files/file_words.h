// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <filesystem>
#include <string>

namespace odo {

/// What is said of a file that cannot be used, the same words everywhere. because: the system's own words.
Message cannotBeRead(std::string because);
Message cannotBeWritten(std::string because);
Message noSuchFile();
Message noSuchFolder(const std::filesystem::path &folder);
Message isThereAlready();

Message nameAFile();
Message chooseAnotherName();
Message chooseAnotherNameOrFolder();
Message chooseFolderWithRoom();
Message makeFolderFirst();
Message checkFileMayBeRead();
Message checkFileIsThere();

} // namespace odo
