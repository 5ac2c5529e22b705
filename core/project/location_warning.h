// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <filesystem>
#include <optional>
#include <string>

namespace odo {

/// The kind of file system that a path is on, as the system's list of mounts ("/proc/self/mounts") names it:
/// "ext4", "nfs4", "fuse.sshfs". Empty where the list does not say.
std::string fileSystemOf(const std::filesystem::path &file, const std::string &mounts);

/// A warning where a project is on a network disk, or in a folder that a program such as
/// Dropbox keeps the same on several computers: it is copied while it changes, by parts. Recognised by the
/// kind of file system, the folders' names and the marks that such programs leave. Any thread; quick.
std::optional<Message> locationWarning(const std::filesystem::path &project);
std::optional<Message> locationWarning(const std::filesystem::path &project, const std::string &mounts);

} // namespace odo
