// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/report/trial_report.h"

#include <QCommandLineOption>
#include <QList>

namespace odo {

class CommandCall;

/// --paper, --school, --logo, --remark, --method, --language: what all commands that write a report are told.
QList<QCommandLineOption> reportOptionSyntax();
/// Installs the language. WrongCall for a paper or language that is not known; Io for a logo that cannot be read.
Result<ReportOptions> readReportOptions(const CommandCall &call);

} // namespace odo
