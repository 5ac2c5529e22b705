// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace odo {

/// Whether a file lies in a project's media folder, all links followed. What a project names outside of it belongs to somebody
/// else and is never removed: a project may come from anyone. Looks at the disk; any thread.
bool isOwnMedia(const std::filesystem::path &file, const std::filesystem::path &mediaFolder);

} // namespace odo
