// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QStringList>
#include <span>

namespace odo {

/// The subcommands of docs/cli.md; each takes the arguments after its name, prints its answer on standard
/// output, and returns what prevented it.
using Subcommand = Result<void> (*)(const QStringList &arguments, const CancelToken &cancel);

Result<void> runAdvise(const QStringList &arguments, const CancelToken &cancel);
Result<void> runNew(const QStringList &arguments, const CancelToken &cancel);
Result<void> runDemo(const QStringList &arguments, const CancelToken &cancel);
Result<void> runRobot(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCamera(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCameras(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCalibrate(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCalibratePair(const QStringList &arguments, const CancelToken &cancel);
Result<void> runIntrinsics(const QStringList &arguments, const CancelToken &cancel);
Result<void> runLayout(const QStringList &arguments, const CancelToken &cancel);
Result<void> runLocate(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCheckPosition(const QStringList &arguments, const CancelToken &cancel);
Result<void> runRegister(const QStringList &arguments, const CancelToken &cancel);
Result<void> runReprocess(const QStringList &arguments, const CancelToken &cancel);
Result<void> runRevisions(const QStringList &arguments, const CancelToken &cancel);
Result<void> runBackup(const QStringList &arguments, const CancelToken &cancel);
Result<void> runTask(const QStringList &arguments, const CancelToken &cancel);
Result<void> runTrial(const QStringList &arguments, const CancelToken &cancel);
Result<void> runEvaluate(const QStringList &arguments, const CancelToken &cancel);
Result<void> runImport(const QStringList &arguments, const CancelToken &cancel);
Result<void> runRecord(const QStringList &arguments, const CancelToken &cancel);
Result<void> runTrack(const QStringList &arguments, const CancelToken &cancel);
Result<void> runFlag(const QStringList &arguments, const CancelToken &cancel);
Result<void> runList(const QStringList &arguments, const CancelToken &cancel);
Result<void> runShow(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCompare(const QStringList &arguments, const CancelToken &cancel);
Result<void> runReport(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCertificate(const QStringList &arguments, const CancelToken &cancel);
Result<void> runTable(const QStringList &arguments, const CancelToken &cancel);
Result<void> runExport(const QStringList &arguments, const CancelToken &cancel);
Result<void> runSchool(const QStringList &arguments, const CancelToken &cancel);
Result<void> runScoreboard(const QStringList &arguments, const CancelToken &cancel);
Result<void> runSnapshot(const QStringList &arguments, const CancelToken &cancel);
Result<void> runTarget(const QStringList &arguments, const CancelToken &cancel);
Result<void> runCheck(const QStringList &arguments, const CancelToken &cancel);

struct NamedCommand
{
    const char *name;
    const char *summary;
    Subcommand run;
    bool needsWindow; ///< paints or opens one
};

/// All of them, in the order of the help.
std::span<const NamedCommand> allCommands();

} // namespace odo
