// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <memory>

namespace odo {

/// What is being written gets a name that nobody can foresee, ".odograph-XXXXXXXXXXXX.part", and its own name when it is whole. Files and
/// folders of such names that a killed program has left are removed when the next one is made beside them: as long as somebody writes
/// to one, it is locked (flock). Any thread, one at a time.

/// A new file in the making, removed unless it was published.
class TemporaryFile
{
public:
    /// what: for messages. Errors: NotFound (no such folder), Io (the disk is full), ReadOnly (the folder cannot be written to).
    static Result<std::unique_ptr<TemporaryFile>> make(const std::filesystem::path &folder, const std::string &what);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    int descriptor() const { return m_descriptor; } ///< to write to; belongs to this object
    const std::filesystem::path &path() const { return m_path; }
    /// Has all bytes on the disk, then the file under that name, in the same folder, in place of what was there.
    Result<void> replace(const std::filesystem::path &target);
    /// Likewise, but AlreadyExists where anything has that name.
    Result<void> publish(const std::filesystem::path &target);

private:
    TemporaryFile(std::filesystem::path path, int descriptor, std::string what);
    tl::unexpected<Error> failure(int reason) const;
    Result<void> sync() const;

    const std::filesystem::path m_path;
    const int m_descriptor;
    const std::string m_what;
};

/// A new folder for what takes several files to make, or is opened by others; removed with all that is in it.
class TemporaryFolder
{
public:
    /// Only this user may look into it. Errors as of TemporaryFile.
    static Result<std::unique_ptr<TemporaryFolder>> make(const std::filesystem::path &folder, const std::string &what);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    /// May be given another name and place.
    std::filesystem::path path() const { return m_outer / "new"; }

private:
    TemporaryFolder(std::filesystem::path outer, int descriptor) : m_outer(std::move(outer)), m_descriptor(descriptor) {}

    const std::filesystem::path m_outer; ///< the lock is on it, and not on the folder within: a project made there locks its folder itself
    const int m_descriptor;
};

/// Whether a file or folder is called as those above are.
bool isTemporaryName(const std::filesystem::path &name);

/// Has the system write a file, or the names in a folder, to the disk. False, with errno, when it reported an error.
bool syncToDisk(const std::filesystem::path &path);

/// Gives a file its name, in the same file system, without ever taking the place of another. 0, or errno.
int giveFreeName(const std::filesystem::path &from, const std::filesystem::path &to);

} // namespace odo
