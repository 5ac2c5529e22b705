// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace odo::test {

/// What one call of the program gave.
struct ProgramRun
{
    int exitStatus = -1;
    QByteArray out, err;

    /// Standard output read as the one JSON object that --json promises; empty when it is not that.
    QJsonObject json() const;
};

/// Runs any program to its end, for at most ten minutes.
ProgramRun runCommand(const QString &program, const QStringList &arguments);

/// Runs the built odograph (ODOGRAPH_PROGRAM) likewise.
ProgramRun runProgram(const QStringList &arguments);

struct MeasuredRun
{
    int exitStatus = -1;
    double megabytes = 0; ///< most memory that was resident at once
    double seconds = 0;
};

/// Runs it to its end, its words thrown away.
MeasuredRun runMeasured(const QStringList &arguments);

/// SHA-256 of a file's content; empty when it cannot be read.
QByteArray fileHash(const QString &file);

} // namespace odo::test
