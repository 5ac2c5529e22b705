// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/program.h"

#include <QTemporaryDir>

namespace odo::test {

/// A finished track as CSV: 10 s at 0.5 m/s along X, 25 positions a second, without those of a gap that
/// begins after 4 s.
QByteArray gappedTrack(double gapS);

/// The base of a test that calls the program in a folder of its own. In a call "%/" stands for the folder,
/// "%P" for the project class.odo in it.
class CallingTest
{
protected:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    void write(const char *name, const QByteArray &content) const;

    QStringList filled(const QString &line) const;
    ProgramRun run(const QString &line) const { return runProgram(filled(line)); }
    ProgramRun run(const char *line) const { return run(QString::fromUtf8(line)); }
    /// As run; prints what went wrong.
    ProgramRun good(const char *line) const;

    /// A test function whose data are bad calls: its columns, its rows, and itself. A call must end with the
    /// status, say in one line what is wrong (with these words) and what to do, and leave the folder and the
    /// project as they were.
    static void beginBadCalls();
    static void addBadCall(const char *line, int status, const char *words);
    void badCallFailsInOneLine() const;

    QTemporaryDir m_folder;
    const QString m_project = path("class.odo");
};

} // namespace odo::test
