// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/json_schema.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <sqlite3.h>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// Finished tracks on the command line: imported, shown, compared, exported and checked like runs of our own.
class TestImportTracks : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    QString m_project;

    QString path(const char *name) const { return m_folder.filePath(QString::fromUtf8(name)); }
    void write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(content), content.size());
    }
    /// Round a circle of 0.5 m at `speed`, 50 positions a second, as TUM.
    static QByteArray circle(double speedMps)
    {
        QByteArray text;
        for (int i = 0; i < 200; ++i) {
            const double angle = 2 * speedMps * i / 50;
            text += QByteArray::number(i / 50.0, 'f', 6) + ' ' +
                    QByteArray::number(0.5 * std::cos(angle), 'f', 9) + ' ' +
                    QByteArray::number(0.5 * std::sin(angle), 'f', 9) + " 0 0 0 0 1\n";
        }
        return text;
    }
    ProgramRun good(QStringList arguments) const
    {
        ProgramRun done = runProgram(arguments);
        if (done.exitStatus != 0)
            qWarning("%s: %s", qPrintable(arguments.join(u' ')), done.err.constData());
        return done;
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = path("class.odo");
        QCOMPARE(good({u"new"_s, m_project}).exitStatus, 0);
        write("slow.tum", circle(0.8));
        write("fast.tum", circle(1));
        QCOMPARE(good({u"import"_s, m_project, u"--trial"_s, u"slow"_s, u"--track"_s,
                       u"red="_s + path("slow.tum"), u"--team"_s, u"Falcon"_s})
                     .exitStatus,
                 0);
    }
    void answers()
    {
        const ProgramRun done = good({u"import"_s, m_project, u"--trial"_s, u"fast"_s, u"--track"_s,
                                      u"red="_s + path("fast.tum"), u"--json"_s});
        QCOMPARE(done.exitStatus, 0);
        const QJsonObject robot = done.json()[u"robots"_s][u"red"_s].toObject();
        QCOMPARE(robot[u"samples"_s].toInt(), 200);
        // 1 m/s for 3.98 s; smoothing bends the ends a little.
        QVERIFY(std::abs(robot[u"path_length_m"_s].toDouble() - 3.98) < 0.02);
        QVERIFY(std::abs(robot[u"mean_speed_m_s"_s].toDouble() - 1) < 0.01);
        const QJsonObject imported = robot[u"imported"_s].toObject();
        QCOMPARE(imported[u"format"_s].toString(), u"tum"_s);
        QCOMPARE(imported[u"file"_s].toString(), u"fast.tum"_s);
        QCOMPARE(imported[u"sha256"_s].toString(), QString::fromLatin1(fileHash(path("fast.tum")).toHex()));
        QVERIFY(imported[u"reading"_s].toString().endsWith(
            u" mm, estimated from the track; errors that change slowly are not included"_s));

        const QJsonObject shown = good({u"show"_s, m_project, u"fast"_s, u"--json"_s}).json();
        QCOMPARE(shown[u"robots"_s][u"red"_s][u"provenance"_s][u"imported"_s].toObject(), imported);
        QVERIFY(shown[u"views"_s].toObject().isEmpty());
        QVERIFY(
            good({u"show"_s, m_project, u"fast"_s}).out.contains("imported from fast.tum (tum, SHA-256 "));
        QCOMPARE(good({u"list"_s, m_project, u"--json"_s}).json()[u"trials"_s].toArray().size(), 2);
        QCOMPARE(good({u"check"_s, m_project, u"--json"_s}).json()[u"ok"_s], QJsonValue(true));
        const QJsonObject compared =
            good({u"compare"_s, m_project, u"slow"_s, u"fast"_s, u"--json"_s}).json();
        // A quarter faster: over 3.18 m the faster one is 0.8 s ahead in the end.
        QVERIFY(std::abs(compared[u"delta_t_s"_s].toArray().last().toDouble() +
                         compared[u"distance_m"_s].toArray().last().toDouble() * 0.25) < 0.05);
        QCOMPARE(good({u"track"_s, m_project, u"fast"_s, u"--again"_s}).exitStatus, 0);
        QCOMPARE(good({u"flag"_s, m_project, u"fast"_s, u"--frame"_s, u"100"_s, u"--spike"_s}).exitStatus, 0);
        QCOMPARE(good({u"reprocess"_s, m_project, u"fast"_s}).exitStatus, 0);
        QCOMPARE(good({u"snapshot"_s, m_project, u"fast"_s, u"-o"_s, path("review.png")}).exitStatus, 0);
        QCOMPARE(good({u"snapshot"_s, m_project, u"fast"_s, u"--mode"_s, u"compare"_s, u"-o"_s,
                       path("compare.png")})
                     .exitStatus,
                 0);
        QCOMPARE(good({u"snapshot"_s, m_project, u"fast"_s, u"--mode"_s, u"history"_s, u"-o"_s,
                       path("history.png")})
                     .exitStatus,
                 0);
    }
    void whatGapsMakeALowerBoundIsSaid()
    {
        QByteArrayList rows = circle(0.7).split('\n');
        rows.remove(40, 125); // 2.5 s
        write("gap.tum", rows.join('\n'));
        const QStringList call{u"import"_s,   m_project,    u"--trial"_s,
                               u"gap json"_s, u"--track"_s, u"red="_s + path("gap.tum"),
                               u"--json"_s};
        const QJsonObject robot = good(call).json()[u"robots"_s][u"red"_s].toObject();
        QVERIFY(robot[u"at_least"_s].toArray().contains(u"path_length_m"_s));
        QVERIFY(!robot[u"at_least"_s].toArray().contains(u"mean_speed_m_s"_s));
        const ProgramRun text = good(
            {u"import"_s, m_project, u"--trial"_s, u"gap text"_s, u"--track"_s, u"red="_s + path("gap.tum")});
        QVERIFY2(text.out.contains("path at least "), text.out.constData());
    }
    void roundTrips_data()
    {
        QTest::addColumn<QStringList>("how");
        QTest::newRow("analysis") << QStringList{u"--format"_s, u"csv"_s};
        QTest::newRow("international") << QStringList{u"--csv-style"_s, u"international"_s};
        QTest::newRow("continental") << QStringList{u"--csv-style"_s, u"continental"_s};
        QTest::newRow("TUM") << QStringList{u"--format"_s, u"tum"_s};
        QTest::newRow("Tracker") << QStringList{u"--format"_s, u"tracker"_s};
    }
    void roundTrips()
    {
        QFETCH(QStringList, how);
        const QString file = path("out.txt"), trial = QString::fromLatin1(QTest::currentDataTag());
        QCOMPARE(good(QStringList{u"export"_s, m_project, u"slow"_s, u"-o"_s, file} + how).exitStatus, 0);
        const ProgramRun done =
            good({u"import"_s, m_project, u"--trial"_s, trial, u"--track"_s, u"red="_s + file, u"--json"_s});
        QCOMPARE(done.exitStatus, 0);
        QCOMPARE(done.json()[u"robots"_s][u"red"_s][u"samples"_s].toInt(), 200);
    }
    void jsonFitsItsSchema()
    {
        QCOMPARE(
            good({u"export"_s, m_project, u"slow"_s, u"-o"_s, path("out.json"), u"--format"_s, u"json"_s})
                .exitStatus,
            0);
        QFile file(path("out.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(JsonSchema(u"docs/trial.schema.json"_s).problemsOf(document), QStringList());
        QCOMPARE(document[u"robots"_s][0][u"analysis"_s][u"imported"_s][u"file"_s].toString(), u"slow.tum"_s);
    }
    void mistakes_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("not increasing") << QByteArray("t_s,x_mm,y_mm\n1,0,0\n0,0,0\n")
                                        << QByteArray(":3: its time is earlier than in the line before; sort "
                                                      "the lines by time, with each time only once\n");
        QTest::newRow("9 columns") << QByteArray("0 0 0 0 0 0 0 1 1\n")
                                   << QByteArray(":1: it has 9 entries instead of the 8 of TUM; write ");
        QTest::newRow("empty")
            << QByteArray()
            << QByteArray(
                   ":1: the file is empty; begin the file with the line t_s,x_mm,y_mm, or write lines of ");
    }
    void mistakes()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, words);
        write("bad.txt", text);
        const QByteArray before = fileHash(m_project);
        const ProgramRun done = runProgram(
            {u"import"_s, m_project, u"--trial"_s, u"bad"_s, u"--track"_s, u"red="_s + path("bad.txt")});
        QCOMPARE(done.exitStatus, 1);
        QVERIFY2(done.err.startsWith("odograph: " + path("bad.txt").toUtf8() + words), done.err.constData());
        QCOMPARE(done.err.count('\n'), 1);
        QCOMPARE(fileHash(m_project), before);
    }
    void wrongCalls()
    {
        for (const QStringList &call :
             {QStringList{u"--track"_s, u"red="_s + path("slow.tum")},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, path("slow.tum")},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"), u"--rate"_s,
                          u"1e9"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"), u"--unit"_s,
                          u"yd"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"), u"--sigma"_s,
                          u"0mm"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"), u"--axes"_s,
                          u"zz"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"),
                          u"--min-confidence"_s, u"-1"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--video"_s, u"A=a.mp4"_s, u"--time-unit"_s, u"ms"_s},
              QStringList{u"--trial"_s, u"x"_s, u"--track"_s, u"red="_s + path("slow.tum"), u"--video"_s,
                          u"A=a.mp4"_s}}) {
            const ProgramRun done = runProgram(QStringList{u"import"_s, m_project} + call);
            QCOMPARE(done.exitStatus, 2);
            QCOMPARE(done.err.count('\n'), 1);
        }
        const ProgramRun track = runProgram({u"track"_s, m_project, u"slow"_s});
        QCOMPARE(track.exitStatus, 1);
        QVERIFY(track.err.startsWith(
            "odograph: trial 'slow': its tracks were imported, so it has no video to track; "));
    }
    /// What a table leaves open is refused with the option that answers it; standard input is read like a
    /// file.
    void openQuestions()
    {
        QByteArray text = "t,x,y\n";
        for (int i = 0; i < 200; ++i)
            text += QByteArray::number(i * 20) + ',' + QByteArray::number(80 * std::cos(i / 50.0), 'f', 3) +
                    ',' + QByteArray::number(80 * std::sin(i / 50.0), 'f', 3) + '\n';
        write("open.csv", text);
        const QStringList call{u"import"_s, m_project,    u"--trial"_s,
                               u"open"_s,   u"--track"_s, u"red="_s + path("open.csv")};
        ProgramRun done = runProgram(call);
        QCOMPARE(done.exitStatus, 1);
        QVERIFY2(done.err.endsWith("; give their unit, likely --time-unit ms (s, ms, us, ns, min, h, d or "
                                   "frame)\n"),
                 done.err.constData());
        done = runProgram(call + QStringList{u"--time-unit"_s, u"ms"_s});
        QCOMPARE(done.exitStatus, 1);
        QVERIFY2(
            done.err.endsWith("in metres the robot would drive at 80 m/s; give their unit, likely --unit cm "
                              "(m, cm, mm, in, ft or px)\n"),
            done.err.constData());
        const QStringList told{u"--time-unit"_s, u"ms"_s,  u"--unit"_s, u"cm"_s,
                               u"--sigma"_s,     u"5mm"_s, u"--json"_s};
        done = good(call + told);
        QCOMPARE(done.exitStatus, 0);
        QJsonObject robot = done.json()[u"robots"_s][u"red"_s].toObject();
        QVERIFY(std::abs(robot[u"path_length_m"_s].toDouble() - 3.184) < 0.02);
        QVERIFY(robot[u"imported"_s][u"reading"_s].toString().contains(u"accurate to 5.00 mm, as given"_s));
        const QStringList piped{u"-c"_s,
                                u"\"$0\" \"$@\" < '%1'"_s.arg(path("open.csv")),
                                qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                                u"import"_s,
                                m_project,
                                u"--trial"_s,
                                u"piped"_s,
                                u"--track"_s,
                                u"red=-"_s};
        done = runCommand(u"sh"_s, piped + told);
        QVERIFY2(done.exitStatus == 0, done.err.constData());
        QCOMPARE(done.json()[u"robots"_s][u"red"_s][u"path_length_m"_s], robot[u"path_length_m"_s]);
        QCOMPARE(done.json()[u"robots"_s][u"red"_s][u"imported"_s][u"file"_s].toString(),
                 u"standard input"_s);
    }
    void hostileNames()
    {
        const QString name = QStringLiteral("=../<b>") + QString(20, u'n');
        QCOMPARE(good({u"import"_s, m_project, u"--trial"_s, name, u"--track"_s, u"@r="_s + path("slow.tum")})
                     .exitStatus,
                 0);
        QVERIFY(good({u"list"_s, m_project}).out.contains(name.toUtf8()));
        for (const QString &refused : {QString(10000, u'n'), QStringLiteral("turned \u202E around")}) {
            const ProgramRun done = runProgram(
                {u"import"_s, m_project, u"--trial"_s, refused, u"--track"_s, u"red="_s + path("slow.tum")});
            QCOMPARE(done.exitStatus, 1);
            QCOMPARE(done.err.count('\n'), 1);
            QVERIFY(!done.err.contains("\u202E"));
        }
    }
    /// A metric that somebody has changed with a database program: found by both checks, told wherever it is
    /// shown.
    void aForgedMetricIsTold()
    {
        const auto change = [this](const char *factor) {
            sqlite3 *database = nullptr;
            QCOMPARE(sqlite3_open(m_project.toUtf8().constData(), &database), SQLITE_OK);
            const QByteArray sql = QByteArray("UPDATE metric SET value=value*") + factor +
                                   " WHERE name='duration' AND analysis_id IN (SELECT analysis.id FROM "
                                   "analysis JOIN trial ON trial.id=trial_id WHERE trial.name='slow')";
            QCOMPARE(sqlite3_exec(database, sql.constData(), nullptr, nullptr, nullptr), SQLITE_OK);
            sqlite3_close(database);
        };
        const QString notice =
            u"robot 'red' in trial 'slow': its results differ from those of its "
            u"analysis: they were changed in the file; run odograph check, or reanalyse the trial"_s;
        const auto warnings = [&] {
            return good({u"show"_s, m_project, u"slow"_s, u"--json"_s})
                .json()[u"warnings"_s]
                .toVariant()
                .toStringList();
        };
        QCOMPARE(good({u"check"_s, m_project, u"--quick"_s}).out, QByteArray("No problems found.\n"));
        QVERIFY(!warnings().contains(notice));
        change("0.5");
        for (const QStringList &check : {QStringList{u"check"_s, m_project, u"--json"_s},
                                         QStringList{u"check"_s, m_project, u"--quick"_s, u"--json"_s}}) {
            const ProgramRun done = runProgram(check);
            QCOMPARE(done.exitStatus, 1);
            const QJsonArray problems = done.json()[u"problems"_s].toArray();
            QCOMPARE(problems.size(), 2);
            QCOMPARE(
                problems[0][u"what"_s].toString(),
                u"the stored metrics, spikes or settings of robot 'red' differ from those of its analysis"_s);
            QCOMPARE(problems[0][u"where"_s].toString(), u"trial 'slow'"_s);
            QVERIFY(problems[1][u"what"_s].toString().startsWith(
                u"metric 'duration' of robot 'red' is stored as 1.9"_s));
            QVERIFY(problems[1][u"what"_s].toString().contains(u" s, its positions give 3.9"_s));
        }
        QVERIFY2(warnings().contains(notice), qPrintable(warnings().join(u'\n')));
        QVERIFY(good({u"show"_s, m_project, u"slow"_s}).err.contains(notice.toUtf8()));
        QCOMPARE(good({u"reprocess"_s, m_project, u"slow"_s, u"--keep"_s}).exitStatus, 0);
        QVERIFY(warnings().isEmpty());
        QCOMPARE(good({u"check"_s, m_project, u"--quick"_s}).out, QByteArray("No problems found.\n"));
    }
};

ODOGRAPH_TEST(TestImportTracks, QCoreApplication)
#include "tst_import_tracks.moc"
