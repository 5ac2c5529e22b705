// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDateTime>
#include <QJsonArray>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// `odograph trial` on the command line: fields, bin and copies of imported tracks.
class TestTrialChanges : public QObject, CallingTest
{
    Q_OBJECT

    QJsonObject set(const QStringList &arguments) const
    {
        const ProgramRun done =
            runProgram(QStringList{u"trial"_s, u"set"_s, m_project} + arguments + QStringList{u"--json"_s});
        if (done.exitStatus != 0)
            qWarning("%s", done.err.constData());
        return done.json();
    }
    QStringList listed() const
    {
        QStringList names;
        const QJsonArray trials = good("list %P --json").json()[u"trials"_s].toArray();
        for (const QJsonValue &trial : trials)
            names << trial[u"name"_s].toString();
        names.sort();
        return names;
    }

    static double metric(const QJsonObject &shown, const char *name)
    {
        const QJsonArray metrics = shown[u"robots"_s].toObject()[u"red"_s].toObject()[u"metrics"_s].toArray();
        for (const QJsonValue &one : metrics)
            if (one[u"name"_s].toString() == QLatin1String(name))
                return one[u"value"_s].toDouble();
        return -1;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(good("new %P").exitStatus, 0);
        QByteArray track("t_s,x_mm,y_mm\n");
        for (int i = 0; i < 100; ++i)
            track += QByteArray::number(i / 25.0) + ',' + QByteArray::number(20 * i) + ",0\n";
        write("track.csv", track);
        write("task.json", "{\"template\": \"straight_line\"}");
        QCOMPARE(good("task add %P Sprint %/task.json").exitStatus, 0);
        QCOMPARE(good("robot add %P blue").exitStatus, 0);
        for (const char *name : {"one", "two"})
            QCOMPARE(run(QStringLiteral("import %P --trial %1 --track red=%/track.csv --team Falcon")
                             .arg(QLatin1String(name)))
                         .exitStatus,
                     0);
        QCOMPARE(good("trial set %P two --team Owl --class 10A").exitStatus, 0);
        QCOMPARE(good("trial set %P one --class 9B").exitStatus, 0);
    }

    void allFieldsAreSetAndPrinted()
    {
        const QJsonObject json =
            set({u"one"_s, u"--name"_s, u"final run"_s, u"--team"_s, u"Heron"_s, u"--class"_s, u"9B"_s,
                 u"--date"_s, u"2025-03-04T05:06:07Z"_s, u"--task"_s, u"Sprint"_s, u"--robot"_s, u"red"_s,
                 u"--robot"_s, u"blue"_s, u"--note"_s, u"wet floor"_s});
        QCOMPARE(json[u"trial"_s].toString(), u"final run"_s);
        QCOMPARE(json[u"team"_s].toString(), u"Heron"_s);
        QCOMPARE(json[u"class"_s].toString(), u"9B"_s);
        QCOMPARE(json[u"task"_s].toString(), u"Sprint"_s);
        QCOMPARE(json[u"notes"_s].toString(), u"wet floor"_s);
        QCOMPARE(json[u"robots"_s].toArray(), (QJsonArray{u"red"_s, u"blue"_s}));
        QCOMPARE(QDateTime::fromString(json[u"date"_s].toString(), Qt::ISODate),
                 QDateTime(QDate(2025, 3, 4), QTime(5, 6, 7), Qt::UTC).toLocalTime());
        const QJsonObject shown = runProgram({u"show"_s, m_project, u"final run"_s, u"--json"_s}).json();
        QCOMPARE(shown[u"notes"_s].toString(), u"wet floor"_s);
        QVERIFY(runProgram({u"trial"_s, u"set"_s, m_project, u"final run"_s, u"--name"_s, u"one"_s})
                    .out.contains("  robots  red, blue\n"));
        QCOMPARE(good("trial set %P one --team Falcon --robot red").exitStatus, 0);
    }

    void variablesComeAndGo()
    {
        QJsonObject json = set({u"one"_s, u"--var"_s, u"surface=carpet"_s, u"--var"_s, u"battery=7.4"_s});
        QCOMPARE(json[u"variables"_s].toObject(),
                 (QJsonObject{{u"battery"_s, 7.4}, {u"surface"_s, u"carpet"_s}}));
        QVERIFY(good("table %P -o -").out.contains(",verdict,var_battery,var_surface,"));
        json = set({u"one"_s, u"--var"_s, u"surface="_s});
        QCOMPARE(json[u"variables"_s].toObject(), (QJsonObject{{u"battery"_s, 7.4}}));
        const QJsonObject shown = runProgram({u"show"_s, m_project, u"one"_s, u"--json"_s}).json();
        QCOMPARE(shown[u"variables"_s], json[u"variables"_s]);
    }

    void datesOfIso8601_data()
    {
        QTest::addColumn<QString>("date");
        QTest::addColumn<QDateTime>("moment");
        const QDate day(2025, 3, 4);
        QTest::newRow("day") << u"2025-03-04"_s << day.startOfDay();
        QTest::newRow("minute") << u"2025-03-04T05:06"_s << QDateTime(day, QTime(5, 6));
        QTest::newRow("blank") << u"2025-03-04 05:06:07"_s << QDateTime(day, QTime(5, 6, 7));
        QTest::newRow("UTC") << u"2025-03-04T05:06:07Z"_s << QDateTime(day, QTime(5, 6, 7), Qt::UTC);
        QTest::newRow("zone") << u"2025-03-04T05:06:07+02:00"_s << QDateTime(day, QTime(3, 6, 7), Qt::UTC);
    }
    void datesOfIso8601()
    {
        QFETCH(QString, date);
        QFETCH(QDateTime, moment);
        const QJsonObject json = set({u"one"_s, u"--date"_s, date});
        QCOMPARE(QDateTime::fromString(json[u"date"_s].toString(), Qt::ISODate), moment.toLocalTime());
    }

    /// 4 s at 0.5 m/s, of which the second is meant.
    void aRange()
    {
        const QJsonObject whole = good("show %P two --json").json();
        QCOMPARE(whole[u"range"_s], (QJsonObject{{u"from_s"_s, 0.0}, {u"to_s"_s, 3.96}}));
        const QJsonObject json = set({u"two"_s, u"--range"_s, u"1,2"_s});
        QCOMPARE(json[u"range"_s], (QJsonObject{{u"from_s"_s, 1.0}, {u"to_s"_s, 2.0}}));
        const ProgramRun shown = good("show %P two");
        QVERIFY2(shown.out.contains("Range: 1.000 s to 2.000 s of 3.960 s; all results are of this part.\n"),
                 shown.out.constData());
        const QJsonObject part = good("show %P two --json").json();
        QCOMPARE(part[u"range"_s], (QJsonObject{{u"from_s"_s, 1.0}, {u"to_s"_s, 2.0}}));
        QVERIFY(std::abs(metric(part, "duration") - 1) < 1e-6);
        QVERIFY(std::abs(metric(part, "path_length") - 0.5) < 0.01);

        const QList<QByteArray> rows = good("export %P two -o -").out.trimmed().split('\n');
        QCOMPARE(rows.size(), 27); // the header, and 1 s at 25 a second, both ends included
        QVERIFY(rows[1].startsWith("1,") && rows.last().startsWith("2,"));
        const QByteArray tables = good("table %P -o - --metrics path_length").out;
        QVERIFY2(tables.contains("Range: 1.000 s to 2.000 s of 3.960 s"), tables.constData());
        QVERIFY(good("compare %P one two").out.contains("two: Range: 1.000 s to 2.000 s of 3.960 s"));
        QCOMPARE(good("track %P two --again --json").json()[u"range"_s], part[u"range"_s]);
        QCOMPARE(good("show %P two --json").json()[u"robots"_s].toObject()[u"red"_s].toObject()[u"metrics"_s],
                 part[u"robots"_s].toObject()[u"red"_s].toObject()[u"metrics"_s]);
        QVERIFY(good("check %P --json").json()[u"ok"_s].toBool());

        QCOMPARE(good("trial set %P two --range motion").exitStatus, 0); // it moves from beginning to end
        QCOMPARE(good("show %P two --json").json()[u"range"_s], whole[u"range"_s]);
        QCOMPARE(good("trial set %P two --range none").exitStatus, 0);
        const QJsonObject again = good("show %P two --json").json();
        QCOMPARE(again[u"robots"_s].toObject()[u"red"_s].toObject()[u"metrics"_s],
                 whole[u"robots"_s].toObject()[u"red"_s].toObject()[u"metrics"_s]);
        QVERIFY(good("check %P --json").json()[u"ok"_s].toBool());
    }

    void theBin()
    {
        QVERIFY(good("trial remove %P two --json").json()[u"in_bin"_s].toBool());
        QVERIFY(good("trial restore %P two --json").json()[u"in_bin"_s] == QJsonValue(false));
    }

    void copies()
    {
        const QJsonObject json = good("trial copy %P two --json").json();
        QCOMPARE(json[u"trial"_s].toString(), u"two copy"_s);
        QCOMPARE(json[u"team"_s].toString(), u"Owl"_s);
        QVERIFY(good("trial copy %P two --name third").out.startsWith("Trial two copied to third."));
        QCOMPARE(listed(), (QStringList{u"one"_s, u"third"_s, u"two"_s, u"two copy"_s}));
        QCOMPARE(good("track %P third --again").exitStatus, 0);
        for (const char *name : {"third", "two"})
            QCOMPARE(run(QStringLiteral("show %P %1 --json").arg(QLatin1String(name)))
                         .json()[u"robots"_s][u"red"_s][u"metrics"_s],
                     good("show %P two --json").json()[u"robots"_s][u"red"_s][u"metrics"_s]);
        QCOMPARE(good("check %P").exitStatus, 0);
    }

    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        addBadCall("trial set %P one", 2, "nothing to change was given");
        addBadCall("trial set %P nobody --note x", 1, "nobody");
        addBadCall("trial set %P one --name two", 1, "already has a trial of that name");
        addBadCall("trial set %P one --name two --json", 1, "already has a trial of that name");
        addBadCall("trial set %P one --team Owl", 1, "it belongs to class 10A, not to class 9B");
        addBadCall("trial set %P one --class 10A", 1, "it belongs to class 9B, not to class 10A");
        addBadCall("trial set %P one --task Slalom", 1, "Slalom");
        addBadCall("trial set %P one --robot green", 1, "green");
        addBadCall("trial set %P one --var surface", 2, "--var 'surface' is not KEY=VALUE");
        addBadCall("trial set %P one --var =carpet", 2, "--var '=carpet' is not KEY=VALUE");
        addBadCall("trial set %P one --sync auto", 1, "it does not have two views");
        addBadCall("trial set %P one --date yesterday", 2, "--date 'yesterday' is not an ISO 8601 date");
        addBadCall("trial set %P one --date 2025-02-30", 2, "--date '2025-02-30' is not an ISO 8601 date");
        addBadCall("trial set %P one --date 2025-03-04T25:00", 2, "is not an ISO 8601 date");
        addBadCall("trial set %P one --date 1850-01-01", 2, "is not an ISO 8601 date since 1970");
        addBadCall("trial set %P one --date 2999-01-01", 2, "its new date is in the future");
        addBadCall("trial set %P one --date 2999-01-01 --name new --team New", 2, "in the future");
        addBadCall("trial set %P one --note x --task Slalom --team New", 1, "Slalom");
        addBadCall("trial set %P one --range 2", 2, "--range '2' is not FROM,TO in seconds");
        addBadCall("trial set %P one --range a,b", 2, "--range 'a,b' is not FROM,TO in seconds");
        addBadCall("trial set %P one --range 1,nan", 2, "is not FROM,TO in seconds");
        addBadCall("trial set %P one --range 1,2,3", 2, "is not FROM,TO in seconds");
        addBadCall("trial set %P one --range 3,1", 2, "its start 3.000 s is not before its end 1.000 s");
        addBadCall("trial set %P one --range 1,1", 2, "its start 1.000 s is not before its end 1.000 s");
        addBadCall("trial set %P one --range 1,9", 1, "1.000 s to 9.000 s is not within the trial's time");
        addBadCall("trial set %P one --range=-1,2", 1, "-1.000 s to 2.000 s is not within the trial's time");
        addBadCall("trial set %P one --range 1.01,1.03", 1, "it contains no sample of robot 'red'");
        addBadCall("trial set %P one --range 3,1 --team New", 2, "is not before its end");
        addBadCall("trial remove %P one --range none", 2, "--range goes with set, not with remove");
        addBadCall("trial restore %P one", 1, "it is not in the bin; use it as it is");
        addBadCall("trial remove %P nobody", 1, "nobody");
        addBadCall("trial remove %P one --team Owl", 2, "--team goes with set, not with remove");
        addBadCall("trial copy %P nobody", 1, "nobody");
        addBadCall("trial copy %P one --name two", 1, "already has a trial of that name");
        addBadCall("trial accept %P one --name x --reason y", 2, "--name goes with set");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }

    void whatIsInTheBinIsSaid()
    {
        QCOMPARE(good("trial remove %P two").exitStatus, 0);
        const ProgramRun again = run("trial remove %P two");
        QCOMPARE(again.exitStatus, 1);
        QVERIFY2(again.err.startsWith("odograph: trial 'two': it is in the bin already; "), again.err);
        QCOMPARE(good("trial restore %P two").out, QByteArray("Trial two is restored from the bin.\n"));
    }
};

ODOGRAPH_TEST(TestTrialChanges, QCoreApplication)
#include "tst_trial_changes.moc"
