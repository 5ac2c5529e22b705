// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/platform/file_status.h"

#include <filesystem>
#include <list>
#include <mutex>
#include <optional>
#include <vector>

namespace odo {

/// What this process has open or reads, and what nothing may be written over therefore.
struct ProtectedFile
{
    std::filesystem::path named, real;    ///< as it was called, and without links; absolute
    std::optional<FileIdentity> identity; ///< when it was opened
    Message reason;                       ///< of an input: why nothing may be written over it
};

/// As long as it lives, a file counts as a project that this process has open. Made before the file is
/// opened. Any thread.
class OpenProjectFile
{
public:
    explicit OpenProjectFile(const std::filesystem::path &file);
    ~OpenProjectFile();
    OpenProjectFile(const OpenProjectFile &) = delete;
    OpenProjectFile &operator=(const OpenProjectFile &) = delete;

private:
    std::list<ProtectedFile>::iterator m_entry;
};

/// Asked before a file that a person or a project names is opened to be read. what: for the message. Errors:
/// NotFound; Io where it may not be read; InvalidInput where it is a folder, a pipe, a socket or a device,
/// for which a reader could wait for ever, or a project that this process has open, or what SQLite keeps
/// beside it. (To close a descriptor of a file drops all locks of the process on it, SQLite's too: POSIX,
/// fcntl(2).) Doesn't open it. Any thread.
Result<void> checkMayBeRead(const std::filesystem::path &file, const Message &what);

/// As long as it lives, files count as inputs: what is made of them must not replace them. One thread;
/// the list is shared by all.
class InputFiles
{
public:
    InputFiles(); ///< of the same call
    /// reason: why nothing may be written over them.
    explicit InputFiles(Message reason) : m_reason(std::move(reason)) {}
    ~InputFiles();
    InputFiles(const InputFiles &) = delete;
    InputFiles &operator=(const InputFiles &) = delete;

    void add(const std::filesystem::path &file);

private:
    const Message m_reason;
    std::vector<std::list<ProtectedFile>::iterator> m_entries;
};

/// All of them. While it lives no project is opened or closed by this process: only then may a file be opened
/// of which it isn't certain that it is no open project. (To close a descriptor of a file drops all locks of
/// the process on it, SQLite's too.)
class ProtectedFiles
{
public:
    ProtectedFiles();
    const std::list<ProtectedFile> &projects() const;
    const std::list<ProtectedFile> &inputs() const;
    bool isOpenProject(const FileIdentity &file) const;
    /// The project, or what SQLite keeps beside it.
    bool isPartOfOpenProject(const FileIdentity &file) const;

private:
    std::unique_lock<std::mutex> m_lock;
};

/// Where a file that may not exist yet would be written, all links followed, those that lead nowhere too.
struct ResolvedPath
{
    std::filesystem::path real; ///< its folder exists
    /// how it was called: the path given, and what each link said; absolute
    std::vector<std::filesystem::path> named;
};

/// Errors: WrongCall without a file name, NotFound without its folder, Io with the system's reason. Any
/// thread.
Result<ResolvedPath> resolved(const std::filesystem::path &file);

} // namespace odo
