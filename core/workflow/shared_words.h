// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>
#include <string>
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

/// The AlreadyExists of a trial that is to be made.
tl::unexpected<Error> trialIsThere(Message what);

Message notTrackedYet();
Message nothingToAnalyseAgain();
Message trackItFirst();
/// robots: that were tracked in the trial.
Message severalRobots(const std::vector<std::string> &robots);
Message robotNotTracked(const std::string &robot, const std::vector<std::string> &robots);
Message noRobotToTrack();
Message noSuchFrame();
Message chooseFrame(std::int64_t first, std::int64_t last);
Message chooseAnotherOne();
Message giveAnotherFile();
Message giveEachViewItsCamera();
Message registerItFirst();
/// "it is interlaced", and what comes of it: of a video.
Message measuredByFields();

} // namespace odo
