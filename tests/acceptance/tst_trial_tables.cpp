// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTest>
#include <sys/stat.h>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// Tables of trials and exports of several, on the command line: of a whole track, one with a short gap
/// (doubtful) and one with a long gap (bad).
class TestTrialTables : public QObject, CallingTest
{
    Q_OBJECT

    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QJsonObject rowOf(const QJsonObject &json, const QString &trial) const
    {
        for (const QJsonValue &row : json[u"trials"_s].toArray())
            if (row[u"trial"_s].toString() == trial)
                return row.toObject();
        return {};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(good("new %P").exitStatus, 0);
        write("whole.csv", gappedTrack(0));
        write("short.csv", gappedTrack(2));
        write("long.csv", gappedTrack(5.5));
        for (const char *name : {"whole", "short", "long"})
            QCOMPARE(run(QStringLiteral("import %P --trial %1 --track red=%/%1.csv --team T%1")
                             .arg(QLatin1String(name)))
                         .exitStatus,
                     0);
        QCOMPARE(good("trial set %P whole --class 9B").exitStatus, 0);
    }

    void valuesAreThoseOfShow()
    {
        const QJsonObject json = good("table %P --json").json();
        QCOMPARE(json[u"trials"_s].toArray().size(), 3);
        for (const QString &trial : {u"whole"_s, u"short"_s, u"long"_s}) {
            const QJsonObject row = rowOf(json, trial);
            const QJsonObject shown = runProgram({u"show"_s, m_project, trial, u"--json"_s}).json();
            QCOMPARE(row[u"verdict"_s][u"level"_s], shown[u"verdict"_s][u"level"_s]);
            const QJsonArray metrics = shown[u"robots"_s][u"red"_s][u"metrics"_s].toArray();
            QVERIFY(!metrics.isEmpty());
            for (const QJsonValue &metric : metrics) {
                const QJsonValue cell = row[u"metrics"_s][metric[u"name"_s].toString()];
                QCOMPARE(cell[u"value"_s], metric[u"value"_s]);
                QCOMPARE(cell[u"sigma"_s], metric[u"sigma"_s]);
                QCOMPARE(cell[u"unit"_s], metric[u"unit"_s]);
                QCOMPARE(cell[u"at_least"_s].toBool(), metric[u"at_least"_s].toBool());
            }
        }
        QVERIFY(rowOf(json, u"long"_s)[u"metrics"_s][u"path_length"_s][u"at_least"_s].toBool());
    }

    void csvGoesToAFileOrStandardOutput()
    {
        const ProgramRun printed = good("table %P --metrics max_speed,path_length -o -");
        QVERIFY2(printed.out.startsWith("trial,team,class,task,robot,date,verdict,max_speed_m_s,"
                                        "sigma_max_speed_m_s,path_length_m,sigma_path_length_m,at_least,"
                                        "remarks\n"),
                 printed.out);
        QVERIFY(printed.out.contains(",doubtful,") && printed.out.contains(",bad,"));
        QCOMPARE(good("table %P --metrics max_speed,path_length -o %/t.csv").out.count('\n'), 1);
        QCOMPARE(read("t.csv"), printed.out);
        QCOMPARE(good("table %P --metrics max_speed -o %/t.csv --csv-style continental").exitStatus, 0);
        QVERIFY(read("t.csv").startsWith("\xef\xbb\xbftrial;team;"));
        const QJsonObject json = good("table %P --class 9B -o %/t.csv --json").json();
        QCOMPARE(json[u"trials"_s].toArray().size(), 1);
        QVERIFY(json[u"file"_s].toString().endsWith(u"t.csv"_s));
        QVERIFY(QFile::remove(path("t.csv")));
    }

    void workbooks()
    {
        QCOMPARE(good("table %P -o %/t.xlsx").exitStatus, 0);
        QVERIFY(read("t.xlsx").startsWith("PK"));
        QCOMPARE(good("table %P --team Twhole -o %/t.xlsx").exitStatus, 0); // replaces it
        write("t.xlsx", "Dear Anna,\n");
        const ProgramRun refused = run("table %P -o %/t.xlsx");
        QCOMPARE(refused.exitStatus, 2);
        QCOMPARE(read("t.xlsx"), QByteArray("Dear Anna,\n"));
        QCOMPARE(good("table %P -o %/t.xlsx --force").exitStatus, 0);
        QVERIFY(QFile::remove(path("t.xlsx")));
    }

    void severalTrialsGoToAFolder()
    {
        const QJsonObject json = good("export %P whole short whole -o %/out --json").json();
        QCOMPARE(json[u"files"_s].toArray().size(), 2);
        QCOMPARE(QDir(path("out")).entryList(QDir::Files), (QStringList{u"short.csv"_s, u"whole.csv"_s}));
        const ProgramRun printed = good("export %P whole -o -");
        QCOMPARE(read("out/whole.csv"), printed.out);
        QCOMPARE(good("export %P whole short -o %/out --columns t_s,flags").exitStatus, 0); // replaces them
        QVERIFY(read("out/whole.csv").startsWith("t_s,flags\n0,"));
        QCOMPARE(good("export %P long -o %/out/ --format json").exitStatus, 0);
        QVERIFY(QFile::exists(path("out/long.json")));
        QVERIFY(QDir(path("out")).removeRecursively());
    }

    void filesOfEqualNamesDiffer()
    {
        QCOMPARE(runProgram({u"trial"_s, u"copy"_s, m_project, u"whole"_s, u"--name"_s, u"a/b"_s}).exitStatus,
                 0);
        QCOMPARE(runProgram({u"trial"_s, u"copy"_s, m_project, u"whole"_s, u"--name"_s, u"a:b"_s}).exitStatus,
                 0);
        for (const QString &name : {u"a/b"_s, u"a:b"_s})
            QCOMPARE(runProgram({u"track"_s, m_project, name, u"--again"_s}).exitStatus, 0);
        QCOMPARE(runProgram({u"export"_s, m_project, u"a/b"_s, u"a:b"_s, u"-o"_s, path("out")}).exitStatus,
                 0);
        QCOMPARE(QDir(path("out")).entryList(QDir::Files), (QStringList{u"a-b 2.csv"_s, u"a-b.csv"_s}));
        QVERIFY(QDir(path("out")).removeRecursively());
    }

    void ownMetricsByFormulas()
    {
        const QList<QByteArray> lines =
            good("table %P --metrics max_speed --formula e=max_speed^2 -o -").out.split('\n');
        QVERIFY2(lines[0].endsWith(",max_speed_m_s,sigma_max_speed_m_s,e,sigma_e,at_least,remarks"),
                 lines[0].constData());
        const QList<QByteArray> heads = lines[0].split(','), cells = lines[1].split(',');
        const double speed = cells[heads.indexOf("max_speed_m_s")].toDouble();
        const double sigma = cells[heads.indexOf("sigma_max_speed_m_s")].toDouble();
        QVERIFY(speed > 0);
        QVERIFY(std::abs(cells[heads.indexOf("e")].toDouble() - speed * speed) < 1e-9);
        QVERIFY(std::abs(cells[heads.indexOf("sigma_e")].toDouble() - 2 * speed * sigma) < 1e-9);
    }

    void columnsAreChosen()
    {
        const QList<QByteArray> lines = good("export %P whole -o - --columns y_mm,t_s").out.split('\n');
        QCOMPARE(lines.first(), QByteArray("y_mm,t_s"));
        QVERIFY(lines[1].endsWith(",0"));
    }

    void badCallsFailInOneLine_data()
    {
        write("file.txt", "Dear Anna,\n");
        QVERIFY(QDir(m_folder.path()).mkpath(u"folder"_s));
        QVERIFY(QDir(m_folder.path()).mkpath(u"folder.csv"_s));
        QVERIFY(QDir(m_folder.path()).mkpath(u"class.media"_s));
        QVERIFY(QFile::link(m_project, path("linked.csv")));
        QCOMPARE(::mkfifo(QFile::encodeName(path("fifo.xlsx")).constData(), 0600), 0);
        beginBadCalls();
        addBadCall("table %P -o %/linked.csv --force", 2, "it is the project itself");
        addBadCall("table %P -o %/class.media/t.xlsx --force", 2, "media folder");
        addBadCall("table %P -o %/folder.csv --force", 2, "folder");
        addBadCall("table %P -o %/fifo.xlsx --force", 2, "pipe");
        addBadCall("table %P", 2, "-o is missing");
        addBadCall("table %P -o %/t.ods", 2, "neither a .csv nor an .xlsx file");
        addBadCall("table %P -o %P", 2, "neither a .csv nor an .xlsx file");
        addBadCall("table %P -o %/folder", 2, "neither a .csv nor an .xlsx file");
        addBadCall("table %P -o - --json", 2, "--json");
        addBadCall("table %P -o %/t.csv --class 7A", 1, "the project has no such class");
        addBadCall("table %P -o %/t.csv --task Slalom", 1, "Slalom");
        addBadCall("table %P -o %/t.csv --team Owl", 1, "Owl");
        addBadCall("table %P -o %/t.csv --metrics beauty", 1, "no trial of the project has it");
        addBadCall("table %P -o %/t.csv --metrics ,", 2, "--metrics names no metric");
        addBadCall("table %P -o %/t.csv --csv-style wild", 2, "--csv-style");
        addBadCall("table %P -o %/t.xlsx --csv-style analysis", 2, "--csv-style goes with a CSV file");
        addBadCall("table %P -o %/nowhere/t.xlsx", 1, "nowhere");
        addBadCall("table %/nobody.odo -o %/t.csv", 1, "nobody");
        addBadCall("export %P whole short -o -", 2, "take one trial");
        addBadCall("export %P whole short -o %/out --format video", 2, "take one trial");
        addBadCall("export %P whole short -o %/file.txt", 2, "it is not a folder");
        addBadCall("export %P whole short -o %P", 2, "it is not a folder");
        addBadCall("export %P whole short -o %/class.media/out", 2, "media folder");
        addBadCall("export %P whole short -o %/nowhere/out", 1, "nowhere");
        addBadCall("export %P whole nobody -o %/out", 1, "nobody");
        addBadCall("export %P whole short -o %/out --robot blue", 1, "blue");
        addBadCall("export %P whole -o %/out.csv --columns t_s,beauty", 2, "beauty");
        addBadCall("export %P whole -o %/out.csv --columns t_s,t_s", 2, "it is named twice");
        addBadCall("table %P -o %/t.csv --formula energy", 2, "--formula is like");
        addBadCall("table %P -o %/t.csv --formula e=weight*2", 1,
                   "no trial has a metric or variable 'weight'");
        addBadCall("table %P -o %/t.csv --formula e=2**3", 1, "is not expected at character 3");
        addBadCall("export %P whole -o %/out.csv --unit ft", 2, "--unit is mm, cm, m or in");
        addBadCall("export %P whole -o %/out.tum --unit m --format tum", 2, "--unit goes with");
        addBadCall("export %P whole -o %/out.csv --axes robot", 2, "--axes is floor or start");
        addBadCall("export %P whole -o %/out.json --axes start --format json", 2, "axes of the floor");
        addBadCall("export %P whole -o %/out.csv --columns t_s --format tum", 2, "--columns goes with");
        addBadCall("export %P whole -o %/folder", 2, "folder");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }
};

ODOGRAPH_TEST(TestTrialTables, QCoreApplication)
#include "tst_trial_tables.moc"
