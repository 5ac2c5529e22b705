// SPDX-License-Identifier: GPL-3.0-or-later
// What odograph check does about files that are lost or belong to nothing.
#include "tests/support/calling_test.h"
#include "tests/support/noise_clip.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestCheckRepairs : public QObject, CallingTest
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(writeNoiseClip(path("clip.mkv").toStdString(), 1).has_value());
        QCOMPARE(good("new %P").exitStatus, 0);
        QCOMPARE(good("import %P --trial run --video A=%/clip.mkv").exitStatus, 0);
        QCOMPARE(good("check %P").out, QByteArray("No problems found.\n"));
    }

    void strayFilesAreNamedAdoptedAndRemoved()
    {
        QVERIFY(QFile::copy(path("clip.mkv"), path("class.media/lap_A.mkv")));
        write("class.media/broken_A.mkv", "no video");
        write("class.media/notes.txt", "a teacher's");
        const ProgramRun named = run("check %P");
        QCOMPARE(named.exitStatus, 1);
        QVERIFY2(named.out.contains(
                     "lap_A.mkv: no trial, lens calibration or floor registration uses this file; "),
                 named.out);
        QVERIFY2(named.err.contains("3 problems found"), named.err);
        const ProgramRun adopted = run("check %P --adopt --json");
        QCOMPARE(adopted.exitStatus, 1); // the others are still there
        QCOMPARE(adopted.json().value(QStringLiteral("adopted")).toArray(),
                 QJsonArray{QStringLiteral("recovered: lap")});
        QCOMPARE(adopted.json().value(QStringLiteral("problems")).toArray().size(), 2);
        const ProgramRun removed = run("check %P --remove-strays");
        QVERIFY2(removed.out.contains("broken_A.mkv removed\n") && removed.out.contains("notes.txt stays\n"),
                 removed.out);
        QVERIFY(!QFile::exists(path("class.media/broken_A.mkv")));
        QCOMPARE(removed.exitStatus, 1);
        QVERIFY(QFile::remove(path("class.media/notes.txt")));
        QCOMPARE(good("check %P").out, QByteArray("No problems found.\n"));
        QVERIFY(QFile::exists(path("class.media/lap_A.mkv")) && QFile::exists(path("class.media/run_A.mkv")));
    }

    void lostVideosAreFoundByTheirContent()
    {
        QVERIFY(QDir().mkpath(path("stick")));
        QVERIFY(QFile::rename(path("class.media/run_A.mkv"), path("stick/other.mkv")));
        const ProgramRun lost = run("check %P");
        QVERIFY2(lost.out.contains("--find FOLDER"), lost.out);
        const ProgramRun beside = run("check %P --find %/class.media");
        QCOMPARE(beside.exitStatus, 0); // lap_A.mkv is the same video
        QVERIFY2(beside.out.contains("Lost videos found by their content: 1 of 1"), beside.out);
        QVERIFY(QFile::remove(path("class.media/lap_A.mkv")));
        QCOMPARE(run("check %P --find %/class.media").exitStatus, 1);
        const ProgramRun found = good("check %P --find %/stick --json");
        QCOMPARE(found.exitStatus, 0);
        QCOMPARE(found.json().value(QStringLiteral("found")).toInt(), 2);
    }
};

ODOGRAPH_TEST(TestCheckRepairs, QCoreApplication)
#include "tst_check_repairs.moc"
