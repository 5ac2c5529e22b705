// SPDX-License-Identifier: GPL-3.0-or-later
// The program crashes while it records: a report is left, and what was recorded is kept.
#include "core/base/crash_report.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <sys/resource.h>

using namespace odo;
using namespace odo::test;

class TestCrash : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aCrashWhileRecordingLosesNothing()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers report crashes themselves");
#endif
        const QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("p.odo"));
        qputenv("XDG_STATE_HOME", folder.filePath(QStringLiteral("state")).toUtf8());
        QCOMPARE(runProgram({QStringLiteral("new"), project}).exitStatus, 0);
        QProcess program;
        program.setChildProcessModifier([] {
            const rlimit none{0, 0};
            setrlimit(RLIMIT_CORE, &none);
        });
        program.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                      {QStringLiteral("record"), project, QStringLiteral("--trial"), QStringLiteral("run"),
                       QStringLiteral("--camera"), QStringLiteral("A=sim:A"), QStringLiteral("--seconds"),
                       QStringLiteral("600")});
        QVERIFY(program.waitForStarted());
        const QString video = folder.filePath(QStringLiteral("p.media/run_A.mkv"));
        QVERIFY(QTest::qWaitFor(
            [&] { return QFileInfo(video).size() > 3'000'000 || program.state() == QProcess::NotRunning; },
            60'000));
        ::kill(static_cast<pid_t>(program.processId()), SIGSEGV);
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        const std::vector<CrashReport> reports =
            newCrashReports(folder.filePath(QStringLiteral("state/odograph")).toStdString());
        QCOMPARE(reports.size(), std::size_t(1));
        QCOMPARE(reports[0].signal, std::string("SIGSEGV"));
        QCOMPARE(reports[0].project, std::filesystem::path(project.toStdString()));
        const ProgramRun kept = runProgram({QStringLiteral("record"), project, QStringLiteral("--recover")});
        QVERIFY2(kept.exitStatus == 0 && kept.err.contains("trial 'run': its recording was cut off"),
                 (kept.out + kept.err).constData());
        const QJsonArray trials = runProgram({QStringLiteral("list"), project, QStringLiteral("--json")})
                                      .json()[QStringLiteral("trials")]
                                      .toArray();
        QCOMPARE(trials.size(), 1);
        QVERIFY(trials[0].toObject()[QStringLiteral("duration_s")].toDouble() > 0);
        QCOMPARE(runProgram({QStringLiteral("check"), project}).exitStatus, 0);
    }
};

ODOGRAPH_TEST(TestCrash, QCoreApplication)
#include "tst_crash.moc"
