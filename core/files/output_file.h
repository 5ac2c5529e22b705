// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/file_kind.h"
#include "core/files/temporary.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
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
struct OutputLocation
{
    std::filesystem::path real; ///< without links
    bool exists = false;
    FileKind kind = FileKind::Empty; ///< of the file that exists
    unsigned permissions = 0;        ///< of the file that exists
};

/// Checks whether an output may be written. Refuses what must never be lost (WrongCall), whatever the choice
/// about existing files, through links and under all of its names: projects that this process has open, other
/// projects and databases, their logs, locks and backups, whatever is in a project's media folder, inputs
/// (InputFiles), folders, devices and the like, and names that end in .odo for what is no project. Other
/// errors: AlreadyExists, NotFound (no such folder), ReadOnly, Io. kind: of what is written; nothing: not
/// known yet, so the kind of an existing file doesn't count. Any thread; reads at most kindBytes.
Result<OutputLocation> checkOutput(const OutputTarget &target, std::optional<FileKind> kind);

/// Checks whether a project may be created there: not under the name of another one's log, lock or backup,
/// nor in its media folder (WrongCall), nor where a log or journal is left that SQLite would apply to it
/// (AlreadyExists). Whether something has that name already, or its folder is missing, is not asked. what:
/// for the message. Any thread.
Result<void> checkNewProject(const std::filesystem::path &file, const Message &what);

/// The one way by which a file is written for a person: checked against what must never be overwritten
/// (checkOutput), written beside its target under an unpredictable name, and given its name only when
/// all its bytes are on the disk. Under the name there is the old file or the whole new one; what is not
/// committed leaves nothing. One thread.
class OutputFile
{
public:
    /// kind: of what will be written. Errors: those of checkOutput and TemporaryFile.
    static Result<std::unique_ptr<OutputFile>> open(const OutputTarget &target, FileKind kind);

    /// Where to write to: a descriptor, or the file's name for libraries that open it themselves.
    int descriptor() const { return m_temporary->handle().number(); }
    std::filesystem::path temporary() const { return m_temporary->path(); }
    Result<void> write(std::string_view bytes);
    /// Once, when all is written. The target is checked again: meanwhile something may have got its name.
    Result<void> commit();
    /// For those who write themselves: that it failed, with the system's own words.
    tl::unexpected<Error> failure(std::string because) const;

private:
    OutputFile(OutputTarget target, FileKind kind, std::unique_ptr<TemporaryFile> temporary);

    const OutputTarget m_target;
    const FileKind m_kind;
    std::unique_ptr<TemporaryFile> m_temporary;
};

/// Takes the next piece of what is written.
using OutputSink = std::function<Result<void>(std::string_view piece)>;

/// Writes all that `write` gives to the sink, piece by piece. The kind is that of the first piece. What
/// `write` gives as an error is passed on, and nothing is written.
Result<void> writeOutput(const OutputTarget &target,
                         const std::function<Result<void>(const OutputSink &)> &write);
/// Writes all of it. The kind is that of the bytes.
Result<void> writeOutput(const OutputTarget &target, std::string_view bytes);

} // namespace odo
