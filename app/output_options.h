// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "ui/report/trial_report.h"

#include <QCommandLineOption>
#include <QList>

namespace odo {

class CommandCall;
class Project;

/// "--force", of every command that writes a file.
QCommandLineOption forceOption();
/// "-o FILE" and "--force".
QList<QCommandLineOption> outputOptions(const QString &description);

/// Where a command is to write, checked before the work is done: WrongCall for what must never be
/// overwritten, and for a file of another kind without --force (checkOutput). project: whose recordings must
/// stay, wherever they are.
Result<OutputTarget> outputOf(const CommandCall &call, const std::string &file, std::optional<FileKind> kind,
                              Project *project);

/// --language, for commands that write what people read: reports, pictures, videos. What a command answers
/// stays English.
QCommandLineOption languageOption();
/// Installs it (language.h). WrongCall where it is not known.
Result<void> applyLanguage(const CommandCall &call);

/// --paper, --school, --logo, --remark, --method, --language: what all commands that write a report are told.
QList<QCommandLineOption> reportOptionSyntax();
/// Installs the language. WrongCall for a paper or language that is not known; Io for a logo that cannot be
/// read.
Result<ReportOptions> readReportOptions(const CommandCall &call);

} // namespace odo
