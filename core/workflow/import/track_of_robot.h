// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_file.h"

#include <filesystem>
#include <string>

namespace odo {

/// The only track of a file, or the one of several that is called as the robot. NotFound where there is none.
Result<FileTrack> trackOfRobot(TrackFile file, const std::string &robot, const std::filesystem::path &path);

} // namespace odo
