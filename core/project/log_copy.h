// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/temporary.h"

#include <filesystem>
#include <memory>

namespace odo {

/// Whether a write-ahead log with anything in it lies beside a database; beside the file itself, where the path is a link.
bool hasLog(const std::filesystem::path &file);

/// A database and its log, copied into a folder of their own below the one for temporary files, which goes with this
/// object: for a place that cannot be written to, where SQLite cannot make the index that it needs to read a log.
class LogCopy
{
public:
    /// Errors: those of TemporaryFolder, Io where they cannot be read or the copy cannot be written, Unavailable where another program
    /// keeps changing them.
    static Result<std::unique_ptr<LogCopy>> make(const std::filesystem::path &file);

    std::filesystem::path file() const { return m_folder->path() / "project.odo"; }

private:
    explicit LogCopy(std::unique_ptr<TemporaryFolder> folder) : m_folder(std::move(folder)) {}
    Result<void> fill(const std::filesystem::path &file) const;

    const std::unique_ptr<TemporaryFolder> m_folder;
};

} // namespace odo
