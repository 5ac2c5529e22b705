// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// `odograph backup`, and what `show` says of zones and smoothing, of an imported track.
class TestBackupCommand : public QObject, CallingTest
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(good("new %P").exitStatus, 0);
        // 4 s along X at 0.5 m/s, with 0.1 mm to and fro
        QByteArray track("t_s,x_mm,y_mm\n");
        for (int i = 0; i < 200; ++i)
            track += QByteArray::number(i / 50.0) + ',' + QByteArray::number(10 * i + 0.1 * (i % 2)) + ",0\n";
        write("track.csv", track);
        write("task.json",
              R"({"zones": [{"name": "Middle", "rule": "stay_outside",
                             "corners_mm": [[500, -200], [1500, -200], [1500, 200], [500, 200]]}]})");
        QCOMPARE(good("task add %P Zones %/task.json").exitStatus, 0);
        QCOMPARE(good("import %P --trial one --track red=%/track.csv --task Zones").exitStatus, 0);
    }

    void oneIsMadeShownAndRestored()
    {
        QVERIFY(good("backup list %P").out.contains("none yet"));
        const QJsonObject made = good("backup make %P --keep 30 --json").json();
        const QString file = made[u"file"_s].toString(), name = QFileInfo(file).fileName();
        QVERIFY2(file.contains(u"class.backups/class.odo.bak-20"_s), qPrintable(file));
        QVERIFY(QFile::exists(file));
        QCOMPARE(made[u"removed"_s].toInt(), 0);
        QCOMPARE(made[u"bytes"_s].toInteger(), QFileInfo(file).size());
        QCOMPARE(good("import %P --trial two --track red=%/track.csv").exitStatus, 0);
        const QJsonArray listed = good("backup list %P --json").json()[u"backups"_s].toArray();
        QCOMPARE(listed.size(), 1);
        QCOMPARE(listed[0][u"file"_s].toString(), file);
        QVERIFY(!listed[0][u"before_update"_s].toBool());
        const QJsonObject shown = good(("backup show %P " + name.toUtf8() + " --json").constData()).json();
        QCOMPARE(shown[u"trials"_s].toInt(), 1);
        QCOMPARE(shown[u"trials_lost"_s].toArray(), QJsonArray{u"two"_s});
        QVERIFY(shown[u"trials_back"_s].toArray().isEmpty());
        QVERIFY(!shown[u"changes_lost"_s].toArray().isEmpty());
        QCOMPARE(shown[u"videos_missing"_s].toInt(), 0);
        const QJsonObject restored =
            good(("backup restore %P " + name.toUtf8() + " --json").constData()).json();
        QVERIFY(QFile::exists(restored[u"kept"_s].toString()));
        QCOMPARE(good("list %P --json").json()[u"trials"_s].toArray().size(), 1);
        QCOMPARE(good("check %P").exitStatus, 0);
        // and back again
        const QByteArray kept = QFileInfo(restored[u"kept"_s].toString()).fileName().toUtf8();
        QVERIFY(good(("backup show %P " + kept).constData())
                    .out.contains("with trial two, which the project no longer has"));
        QCOMPARE(good(("backup restore %P " + kept).constData()).exitStatus, 0);
        QCOMPARE(good("list %P --json").json()[u"trials"_s].toArray().size(), 2);
    }

    void wrongCallsAreNamed()
    {
        const ProgramRun none = run("backup restore %P class.odo.bak-1");
        QCOMPARE(none.exitStatus, 1);
        QVERIFY2(none.err.contains("the project has none of that name"), none.err);
        QCOMPARE(run("backup make %P --keep 0").exitStatus, 2);
        QCOMPARE(run("backup make %P --keep many").exitStatus, 2);
        QCOMPARE(run("backup show %P").exitStatus, 2);
        QCOMPARE(run("backup erase %P").exitStatus, 2);
        QCOMPARE(run("backup make %/nothing.odo").exitStatus, 1);
    }

    void showSaysHowLongItWasInAZone()
    {
        const QJsonObject robot = good("show %P one --json").json()[u"robots"_s][u"red"_s].toObject();
        const QJsonArray zones = robot[u"zones"_s].toArray();
        QCOMPARE(zones.size(), 1);
        const QJsonObject zone = zones[0].toObject();
        QCOMPARE(zone[u"name"_s].toString(), u"Middle"_s);
        QVERIFY(std::abs(zone[u"inside_s"_s].toDouble() - 2) < 0.01); // 1 m at 0.5 m/s
        QVERIFY(std::abs(zone[u"latency_s"_s].toDouble() - 1) < 0.01);
        QCOMPARE(zone[u"entries"_s].toInt(), 1);
        QVERIFY(zone[u"inside_sigma_s"_s].toDouble() > 0);
        QVERIFY2(good("show %P one").out.contains("zone Middle: inside for 2.0"), good("show %P one").out);
        const QJsonObject smoothing = robot[u"smoothing"_s].toObject();
        QCOMPARE(smoothing[u"residuals"_s].toArray().size(), 40);
        QVERIFY(smoothing[u"cutoff_hz"_s].toDouble() > 0);
        QVERIFY(good("show %P one --json").json()[u"sync_passport"_s][u"views"_s].toObject().isEmpty());
    }
};

ODOGRAPH_TEST(TestBackupCommand, QCoreApplication)
#include "tst_backup_command.moc"
