// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/base/platform/file_names.h" // of it, namesIn()

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

/// What the program asks of the file system. Nothing here throws what std::filesystem throws: a path that is
/// too long, a folder that may not be entered, a loop of links or a working directory that is gone gives a
/// plain answer, and where `problem` is asked for, the system's reason (cleared where there is none). Where
/// memory is refused std::bad_alloc is thrown. Any thread. tests/base/tst_file_system_calls refuses calls of
/// std::filesystem anywhere else.
namespace odo::files {

enum class Kind { Missing, File, Folder, Link, Pipe, Socket, Device };

/// What is there, through links. Missing with a problem: it cannot be accessed.
Kind kindOf(const std::filesystem::path &path, std::error_code &problem);
/// What is there itself: a link is a Link. Missing where it cannot be accessed.
Kind kindOfItself(const std::filesystem::path &path);
/// What is there in place of a file: "it is a named pipe". Empty for a file, a link and nothing.
Message insteadOfFile(Kind kind);

/// Through links; false where it cannot be accessed.
bool exists(const std::filesystem::path &path);
bool isFile(const std::filesystem::path &path);
bool isFolder(const std::filesystem::path &path);
/// Whether both lead to one file or folder; false where either cannot be accessed.
bool isSame(const std::filesystem::path &a, const std::filesystem::path &b);

/// In bytes; 0 with a problem.
std::uintmax_t sizeOf(const std::filesystem::path &file, std::error_code &problem);
struct DiskSpace
{
    /// what this user may still write, and the size of the whole disk
    std::uintmax_t freeBytes = 0, bytes = 0;
};
/// Of the disk that a folder is on.
DiskSpace diskSpace(const std::filesystem::path &folder, std::error_code &problem);
std::filesystem::file_time_type lastWritten(const std::filesystem::path &file, std::error_code &problem);

/// From the root; as it was given where the working directory is gone.
std::filesystem::path absolute(const std::filesystem::path &path);
/// From the root, through all links as far as the path exists; as absolute() gives it where that is
/// not known.
std::filesystem::path realPath(const std::filesystem::path &path);
std::filesystem::path realPath(const std::filesystem::path &path, std::error_code &problem);
/// Where a path leads that exists, from the root, without links, dots and doubled slashes; empty with a
/// problem.
std::filesystem::path existingPath(const std::filesystem::path &path, std::error_code &problem);
/// Where a link leads, as it was written; empty with a problem.
std::filesystem::path linkTarget(const std::filesystem::path &link, std::error_code &problem);

/// Calls visit for each file below a folder until it returns false. Links are followed to files only; what
/// may not be read below the folder is left out.
void eachFileBelow(const std::filesystem::path &folder,
                   const std::function<bool(const std::filesystem::path &)> &visit, std::error_code &problem);

/// With the folders above it. Whether there was none before.
bool makeFolders(const std::filesystem::path &folder, std::error_code &problem);
/// A file, a link or an empty folder; what is not there is no problem.
void remove(const std::filesystem::path &path, std::error_code &problem);
/// The same, where nobody is helped by knowing why it stays.
void remove(const std::filesystem::path &path);
/// With all that lies in it, as far as that may be removed. Links are not followed.
void removeAll(const std::filesystem::path &path);
/// Gives a file a second name, which nothing may have. Not every file system can.
void link(const std::filesystem::path &file, const std::filesystem::path &name, std::error_code &problem);
/// Permissions of an ordinary folder: everyone may read it, its owner may write to it.
void letAllRead(const std::filesystem::path &folder, std::error_code &problem);
/// Replaces a file of the new name.
void rename(const std::filesystem::path &from, const std::filesystem::path &to, std::error_code &problem);

} // namespace odo::files
