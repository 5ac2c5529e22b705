// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace odo {

/// What the writers of this folder, and the locks of projects, do with files that they hold open. Any thread.

/// Whether the path leads to this very file, and not through a link: somebody may have renamed or removed it, and another one may have its name.
bool isAt(const std::filesystem::path &path, int descriptor);

/// Writes all of it, behind what was written before. 0, or errno.
int writeAll(int descriptor, std::span<const char> bytes);

/// So many letters and digits that nobody can foresee; empty, with errno, where the system has no random numbers.
std::string randomLetters(std::size_t count);

} // namespace odo
