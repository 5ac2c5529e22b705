// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// The places that the system gives to this user. Whether they are there is not asked. Any thread, while none
/// changes the environment.
namespace odo {

/// Where what a program leaves for its next start lies: $XDG_STATE_HOME/odograph, or ~/.local/state/odograph.
/// Empty where neither is known.
std::filesystem::path stateFolder();

/// Where this user's own files lie; empty where that is not known.
std::filesystem::path homeFolder();

/// Where a file lies that nobody needs for long.
std::filesystem::path temporaryFolder();

} // namespace odo
