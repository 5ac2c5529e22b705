// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// The folders that the system gives to this user. They may not exist yet. Any thread, while none
/// changes the environment.
namespace odo {

/// For what a program keeps for its next start: $XDG_STATE_HOME/odograph, or ~/.local/state/odograph.
/// Empty where neither is known.
std::filesystem::path stateFolder();

/// Where this user's own files lie; empty where that is not known.
std::filesystem::path homeFolder();

/// Where a file lies that nobody needs for long.
std::filesystem::path temporaryFolder();

} // namespace odo
