// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_guard.h"

#include <QCommandLineOption>
#include <QList>

namespace odo {

class CommandCall;
class Project;

/// "--force", of every command that writes a file.
QCommandLineOption forceOption();
/// "-o FILE" and "--force".
QList<QCommandLineOption> outputOptions(const QString &description);

/// Where a command is to write, checked before the work is done: WrongCall for what must never be overwritten, and for a file of another kind
/// without --force (checkOutput). project: whose recordings must stay, wherever they are.
Result<OutputTarget> outputOf(const CommandCall &call, const std::string &file, std::optional<FileKind> kind, Project *project);

} // namespace odo
