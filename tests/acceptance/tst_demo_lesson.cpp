// SPDX-License-Identifier: GPL-3.0-or-later
// The demo lesson is made by the program. The tests that begin with it take a copy
// (tests/support/demo_lesson.h).
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace odo::test;

class TestDemoLesson : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isMadeWithoutAQuestion()
    {
        QTemporaryDir own;
        const QString kept = qEnvironmentVariable("ODOGRAPH_DEMO_LESSON");
        const QString folder = kept.isEmpty() ? own.filePath(QStringLiteral("lesson")) : kept;
        QVERIFY(QDir(folder).removeRecursively()); // of an earlier run
        const ProgramRun run = runProgram({QStringLiteral("demo"), folder, QStringLiteral("--json")});
        QVERIFY2(run.exitStatus == 0, run.err);
        const QFileInfo project(run.json().value(QStringLiteral("project")).toString());
        QVERIFY(project.exists());
        QCOMPARE(project.absolutePath(), QFileInfo(folder).absoluteFilePath());
        QCOMPARE(QDir(folder).entryList({QStringLiteral("*.odo*")}), QStringList(QStringLiteral("demo.odo")));
    }
};

ODOGRAPH_TEST(TestDemoLesson, QCoreApplication)
#include "tst_demo_lesson.moc"
