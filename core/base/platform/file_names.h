// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

/// What has a name in a folder, where the standard library does not say or do it safely. Any thread.
namespace odo {

namespace files {

/// The names of all that lies in a folder, but "." and "..", in no order. problem: why it could not be read
/// to its end; what was read until then is given. std::filesystem's iterators end the program where memory is
/// refused: libstdc++ 12 puts their paths together in a function that is noexcept.
std::vector<std::string> namesIn(const std::filesystem::path &folder, std::error_code &problem);

} // namespace files

/// Gives a file or folder its name, in the same file system, and never replaces another:
/// std::errc::file_exists.
std::error_code giveFreeName(const std::filesystem::path &from, const std::filesystem::path &to);
/// A new folder that only this user may open.
std::error_code makeOwnFolder(const std::filesystem::path &folder);
/// Anything but a folder.
std::error_code removeFile(const std::filesystem::path &file);
/// Has the system write a file, or the names in a folder, to the disk.
std::error_code syncToDisk(const std::filesystem::path &path);
/// Whether that is why something could not be written: the disk is full, or this user's part of it.
bool isDiskFull(const std::error_code &problem);

} // namespace odo
