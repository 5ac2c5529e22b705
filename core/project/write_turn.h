// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>

namespace odo {

/// Held by the connection that writes to a project file, from the beginning of a transaction to its end with
/// whatever SQLite does then, so that of several connections of this program one writes at a time: before
/// 3.51.3 SQLite can damage a file to whose log two write at once. One for a file, however its path is
/// written. Any thread.
std::shared_ptr<std::recursive_mutex> writeTurnOf(const std::filesystem::path &file);

} // namespace odo
