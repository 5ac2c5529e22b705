// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <memory>

namespace odo {

class TemporaryFolder;

/// A database file in the making: written in a temporary folder beside its target, and given its name only
/// when it is whole and on the disk. What was not published is removed, with SQLite's side files.
class NewFile
{
public:
    /// `what` names it in messages.
    NewFile(std::filesystem::path target, Message what);
    ~NewFile();
    NewFile(const NewFile &) = delete;
    NewFile &operator=(const NewFile &) = delete;

    /// Errors: AlreadyExists, those of TemporaryFolder.
    Result<void> prepare();
    /// An empty file in place of which to write. After prepare().
    const std::filesystem::path &temporary() const { return m_temporary; }
    /// Never replaces a file: AlreadyExists when one appeared in the meantime.
    Result<void> publish();

private:
    tl::unexpected<Error> alreadyThere() const;
    tl::unexpected<Error> ioError(const std::error_code &reason) const;

    std::filesystem::path m_target, m_temporary;
    Message m_what;
    std::unique_ptr<TemporaryFolder> m_folder;
};

} // namespace odo
