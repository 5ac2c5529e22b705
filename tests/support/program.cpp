// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>

namespace odo::test {

namespace {

constexpr int longestRunMs = 600'000;

} // namespace

QJsonObject ProgramRun::json() const
{
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(out, &problem);
    return problem.error == QJsonParseError::NoError ? document.object() : QJsonObject();
}

ProgramRun runProgram(const QStringList &arguments)
{
    return runCommand(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
}

ProgramRun runCommand(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.start(program, arguments);
    ProgramRun run;
    if (!process.waitForFinished(longestRunMs)) {
        run.err = "did not start or finish: " + process.errorString().toUtf8();
        process.kill();
        process.waitForFinished();
        return run;
    }
    run.exitStatus = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    run.out = process.readAllStandardOutput();
    run.err = process.readAllStandardError();
    return run;
}

QByteArray fileHash(const QString &file)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return {};
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(&in);
    return hash.result();
}

} // namespace odo::test
