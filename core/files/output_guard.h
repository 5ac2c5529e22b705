// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/file_kind.h"

#include <filesystem>
#include <optional>
#include <type_traits>

namespace odo {

/// What is done where the file that is to be written exists.
enum class Existing {
    Refuse,          ///< AlreadyExists
    ReplaceSameKind, ///< by content; an empty file too
    ReplaceAny,      ///< a person was asked, or said --force
};

/// Where something is written for a person.
struct OutputTarget
{
    OutputTarget() = default;
    template <class Path>
        requires std::is_convertible_v<Path, std::filesystem::path>
    OutputTarget(const Path &where, Existing what = Existing::ReplaceSameKind) : file(where), existing(what)
    {
    }

    std::filesystem::path file;
    Existing existing = Existing::ReplaceSameKind;
    bool isOwnMedia = false; ///< a new file in the media folder of a project, which no output may go to
};

/// The file that an output would take the place of, or become.
struct OutputPlace
{
    std::filesystem::path real; ///< without links
    bool exists = false;
    FileKind kind = FileKind::Empty; ///< of the file that exists
    unsigned permissions = 0;        ///< of the file that exists
};

/// Looks whether an output may be written. What must never be lost is refused (WrongCall), whatever is said about existing files, through
/// links and under all of its names: projects that this process has open, other projects and databases, their logs, locks and backups, whatever is in
/// a project's media folder, inputs (InputFiles), folders, devices and the like, and names that end in .odo for what is no project. Other errors: AlreadyExists, NotFound (no such folder), ReadOnly, Io.
/// kind: of what is written; nothing: not known yet, so the kind of an existing file doesn't count. Any thread; reads at most kindBytes.
Result<OutputPlace> checkOutput(const OutputTarget &target, std::optional<FileKind> kind);

/// Looks whether a project may be made there: not under the name of another one's log, lock or backup, nor in its media folder (WrongCall),
/// nor where a log or journal is left that SQLite would apply to it (AlreadyExists). Whether something has that name already, or its folder is missing, is not asked. what: for the message. Any thread.
Result<void> checkNewProject(const std::filesystem::path &file, const std::string &what);

} // namespace odo
