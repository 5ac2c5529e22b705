// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// A database file in the making: written under a temporary name beside its place, and given its name only
/// when it is whole and on the disk. What was not published is removed, with SQLite's side files.
class NewFile
{
public:
    /// `what` names it in messages.
    NewFile(std::filesystem::path target, std::string what);
    ~NewFile();
    NewFile(const NewFile &) = delete;
    NewFile &operator=(const NewFile &) = delete;

    /// Errors: AlreadyExists, NotFound (no such folder), ReadOnly (the folder cannot be written to).
    Result<void> prepare();
    const std::filesystem::path &temporary() const { return m_temporary; }
    /// Never replaces a file: AlreadyExists when one appeared in the meantime.
    Result<void> publish();

private:
    tl::unexpected<Error> alreadyThere() const;

    std::filesystem::path m_target, m_temporary;
    std::vector<std::string> m_toRemove; ///< the temporary file, and what SQLite may leave beside it
    std::string m_what;
    bool m_prepared = false;
};

/// Has the kernel write the file, or the entries of the folder, to the disk. False when it reported an error.
bool syncToDisk(const std::filesystem::path &path);

} // namespace odo
