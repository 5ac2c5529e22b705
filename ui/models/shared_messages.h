// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

namespace odo {

/// What several windows say, or a window and the command line.

Message pictureSubject(); ///< "the picture"
Message anotherJobRuns();
Message waitOrCancel(); ///< what to do while a job runs
Message noProjectIsOpen();

/// What a change does, for Project::change.
Message addCameraWords(const std::string &name);
Message addRobotWords(std::string robot);
Message addTaskWords(std::string task);
Message addLayoutWords(std::string layout);

} // namespace odo
