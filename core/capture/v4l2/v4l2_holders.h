// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// The names of the other programs that have a camera's node open, each once, in alphabetical order: as the kernel tells it of the programs of
/// the same user (of all to the administrator). Empty where it tells of none. Any thread; takes some milliseconds.
std::vector<std::string> programsThatHold(const std::filesystem::path &node);

} // namespace odo
