// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace odo {

/// What several use cases say in the same words. Pure.

/// What errors are about.
Message folderCalled(const std::filesystem::path &file); ///< "folder 'a'"
Message importSubject(const std::string &trial);
Message importChange(const std::string &trial);                            ///< words of a change
Message giveTaskChange(const std::string &trial, const std::string &task); ///< words of a change
Message recordingSubject(const std::string &trial);
Message trackingSubject();

/// "'red', 'blue'"
MessageArgument quotedNames(const std::vector<std::string> &names, MessageArgument::Kind kind);
/// "1280×720"
std::string sizeText(int width, int height);

/// The AlreadyExists of a trial that is to be made.
tl::unexpected<Error> trialIsThere(Message what);
/// The Io of a file whose size cannot be found out.
tl::unexpected<Error> cannotBeLookedAt(Message what, const std::error_code &problem);

Message notTrackedYet();
Message nothingToAnalyseAgain();
Message trackItFirst();
/// robots: that were tracked in the trial.
Message severalRobots(const std::vector<std::string> &robots);
Message robotNotTracked(const std::string &robot, const std::vector<std::string> &robots);
Message noRobotToLookFor();
Message noSuchFrame();
Message chooseFrame(std::int64_t first, std::int64_t last);
Message chooseAnotherOne();
Message giveAnotherFile();
Message giveEachViewItsCamera();
Message registerItFirst();

} // namespace odo
