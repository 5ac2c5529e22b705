// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/files/file_kind.h"
#include "core/files/output_file.h"

#include <QTemporaryDir>
#include <memory>
#include <optional>

namespace odo {

/// What a command takes in place of a file to write: standard output.
inline const QString standardOutput = QStringLiteral("-");

/// Advice, where something could not be kept there on its way from standard input or to standard output.
Message freeTemporarySpace();

/// From now on nothing may be written over the project's recordings, wherever they are.
Result<void> protectRecordings(const CommandCall &call, Project &project);

/// Where a command writes its one file. Standard output gets it when it is whole, so a command that fails
/// prints nothing of it.
class CommandOutput
{
public:
    /// Checked before the work is done: WrongCall for what must never be overwritten, for a file of another
    /// kind without --force (checkOutput), and for standard output together with --json. project: whose
    /// recordings must stay, wherever they are. printedEnding: of a name, where the format follows from it.
    static Result<CommandOutput> of(const CommandCall &call, const QString &file,
                                    std::optional<FileKind> kind, Project *project,
                                    const QString &printedEnding = {});

    const OutputTarget &target() const { return m_target; } ///< to be written to
    bool isPrinted() const { return m_folder != nullptr; }
    /// After the file was written: prints it, or else answers the call.
    Result<void> finish(const CommandCall &call, const QJsonObject &json, const QString &text) const;

private:
    OutputTarget m_target;
    std::unique_ptr<QTemporaryDir> m_folder; ///< of what is going to be printed
};

} // namespace odo
