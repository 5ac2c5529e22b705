// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <sqlite3.h>

using namespace odo;
using namespace odo::test;
using namespace Qt::Literals::StringLiterals;

/// The program with projects that another program filled with nonsense, and on a computer that has run out of
/// something: no crash, no hang, one line with a true reason. ODOGRAPH_ALL_FAULTS tries everything, else a
/// sample.
class TestHostileContent : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_sound;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    static constexpr bool isSanitized = true; // they map terabytes
#else
    static constexpr bool isSanitized = false;
#endif
    static bool isAll()
    {
        return qEnvironmentVariableIsSet("ODOGRAPH_ALL_FAULTS");
    }
    QString path(const QString &name) const
    {
        return m_folder.filePath(name);
    }

    /// A copy of the sound project changed by some SQL.
    QString changed(const QByteArray &sql) const
    {
        const QString file = path(u"changed.odo"_s);
        for (const char *side : {"", "-wal", "-shm"})
            QFile::remove(file + QLatin1String(side));
        QFile::copy(m_sound, file);
        sqlite3 *database = nullptr;
        char *problem = nullptr;
        if (sqlite3_open(file.toUtf8().constData(), &database) != SQLITE_OK ||
            sqlite3_exec(database, sql.constData(), nullptr, nullptr, &problem) != SQLITE_OK)
            qFatal("%s: %s", sql.constData(), problem);
        sqlite3_close(database);
        return file;
    }

    /// The program with limits of bash's ulimit: "-v 300000".
    static ProgramRun limited(const QString &limits, const QStringList &arguments)
    {
        const QStringList call{u"-c"_s, limits + u"\nexec \"$0\" \"$@\""_s,
                               qEnvironmentVariable("ODOGRAPH_PROGRAM")};
        return runCommand(u"bash"_s, call + arguments);
    }

    /// What is wrong with how a call ended; empty when nothing is.
    static QString problemOf(ProgramRun run)
    {
        run.err.replace("libpng error: insufficient memory\n", ""); // which it writes by itself
        if (run.exitStatus != 0 && run.exitStatus != 1)
            return u"exit status %1, "_s.arg(run.exitStatus) + QString::fromUtf8(run.err.left(300));
        if (run.exitStatus == 1 && (run.err.count('\n') != 1 || !run.err.startsWith("odograph: ") ||
                                    run.err.size() > 1500 || run.err.contains("nknown error")))
            return u"no line: "_s + QString::fromUtf8(run.err.left(300));
        if (run.out.contains('\x1b') || run.err.contains('\x1b') || run.out.contains("\u202e"))
            return u"a control character is passed on"_s;
        return {};
    }

    QList<QStringList> calls(const QString &project) const
    {
        const QString trial = u"Trial 1"_s;
        QList<QStringList> calls{{u"list"_s, project},
                                 {u"show"_s, project, trial},
                                 {u"export"_s, project, trial, u"-o"_s, path(u"out.csv"_s)},
                                 {u"report"_s, project, trial, u"-o"_s, path(u"out.pdf"_s)},
                                 {u"layout"_s, u"show"_s, project, u"floor"_s},
                                 {u"task"_s, u"list"_s, project},
                                 {u"compare"_s, project, trial, u"Trial 2"_s},
                                 {u"check"_s, project}};
        for (const auto &mode : {u"review"_s, u"compare"_s, u"history"_s, u"testbed"_s})
            calls.append({u"snapshot"_s, project, trial, u"-o"_s, path(u"out.png"_s), u"--mode"_s, mode});
        return calls;
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file.has_value());
        m_sound = QString::fromStdString(file->string());
    }

    void whatAProjectHoldsIsBounded_data()
    {
        QTest::addColumn<QByteArray>("sql");
        const auto row = [](const char *name, bool isSample, const char *sql) {
            if (isSample || isAll())
                QTest::newRow(name) << QByteArray(sql);
        };
        row("a path of 6000 letters", true, "UPDATE recording SET path=hex(zeroblob(3000)) WHERE id=1");
        row("notes of one word", true, "UPDATE trial SET notes=hex(zeroblob(500000))");
        row("notes of a million words", true,
            "UPDATE trial SET notes=replace(hex(zeroblob(500000)),'00','note ')");
        row("notes of overrides and lines", false,
            "UPDATE trial SET notes=replace(hex(zeroblob(500000)),'00',char(8238)||char(10))");
        row("a robot's name of 5 MB", true, "UPDATE robot SET name=hex(zeroblob(2500000)) WHERE id=1");
        row("a marker far away", true, "UPDATE marker SET x_m=1e300");
        row("control characters", true, "UPDATE team SET name=char(27)||'[2J'||char(8238)||id");
        row("400 views", true,
            "WITH RECURSIVE n(i) AS (SELECT 2 UNION ALL SELECT i+1 FROM n WHERE i<400) INSERT INTO recording "
            "(trial_id, camera_id, position, path, "
            "sha256, bytes, width_px, height_px, frames_per_second, start_offset_s) SELECT trial_id, "
            "camera_id, n.i, path, sha256, bytes, width_px, "
            "height_px, frames_per_second, start_offset_s FROM recording, n WHERE recording.id=1");
        row("cameras' names", false, "UPDATE camera SET name=hex(zeroblob(2500000))||id");
        row("tasks' names", false, "UPDATE task SET name=hex(zeroblob(500000))||id");
        row("gates' names", false, "UPDATE gate SET name=hex(zeroblob(500000))||position");
        row("gates far away", true, "UPDATE gate SET from_x_m=1e300");
        row("cameras far away", false, "UPDATE registration SET x_m=1e300");
        row("a lens", false, "UPDATE lens SET fx_px=1e300");
        row("figures", false, "UPDATE metric SET value=1e300");
        row("units", false, "UPDATE metric SET unit=hex(zeroblob(500000))");
        row("verdicts", false, "UPDATE registration SET verdict=hex(zeroblob(500000))");
        row("reasons", false, "UPDATE spike SET reason=hex(zeroblob(500000))");
        row("frame rates", false, "UPDATE recording SET frames_per_second=1e300");
        row("frame sizes", false, "UPDATE recording SET width_px=2000000000, height_px=2000000000");
        row("durations", false, "UPDATE trial SET duration_s=1e300");
        row("dates", false, "UPDATE trial SET date_ms=9223372036854775807");
        row("offsets", false, "UPDATE recording SET start_offset_s=1e300");
        row("clock rates", false, "UPDATE recording SET clock_rate=1e300");
        row("the title", false, "UPDATE property SET value=hex(zeroblob(2500000)) WHERE name='title'");
        row("robots' sizes", false, "UPDATE robot SET height_m=1e300, length_m=9e999, width_m=1e300");
        row("limits of speed", false, "UPDATE task SET max_speed_m_s=1e300");
        row("bridged gaps", false,
            "UPDATE analysis SET longest_bridged_gap_ns=9223372036854775807, max_speed_m_s=1e300");
        const QByteArray count =
            "WITH RECURSIVE n(i) AS (SELECT 1000 UNION ALL SELECT i+1 FROM n WHERE i<50000) ";
        row("many markers", false,
            (count + "INSERT INTO marker SELECT 1, i, 'M'||i, i*0.01, 0 FROM n").constData());
        row("many tags", false, (count + "INSERT INTO trial_tag SELECT 1, 'tag'||i FROM n").constData());
        row("many members", false,
            (count + "INSERT INTO team_member SELECT 1, i, 'member'||i FROM n").constData());
        row("many spikes", false,
            (count + "INSERT INTO spike SELECT (SELECT MAX(id) FROM analysis), i, 0, i*1000, 1, 'r' FROM n")
                .constData());
    }
    void whatAProjectHoldsIsBounded()
    {
        QFETCH(QByteArray, sql);
        const qint64 longestMs = 10'000; // on a busy machine; alone each takes two at most
        for (const QStringList &call : calls(changed(sql))) {
            QElapsedTimer clock;
            clock.start();
            // of addresses; what is used is less than half
            const ProgramRun run = limited(isSanitized ? QString() : u"ulimit -v 1500000"_s, call);
            const QString problem = problemOf(run);
            QVERIFY2(problem.isEmpty(), qPrintable(call.join(u' ') + u": "_s + problem));
            QVERIFY2(clock.elapsed() < longestMs,
                     qPrintable(call.join(u' ') + u": %1 ms"_s.arg(clock.elapsed())));
            QVERIFY2(call.front() != u"list" || run.exitStatus == 0, run.err.constData());
        }
    }

    void whatIsTooMuchIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("axes") << QStringList{u"layout"_s, u"transform"_s,   u"%P"_s,
                                             u"floor"_s,  u"--origin-at"_s, u"1e300,0"_s}
                              << QByteArray("is not within a floor of 1 km");
        QTest::newRow("rate") << QStringList{u"import"_s,  u"%P"_s,      u"--trial"_s, u"x"_s,
                                             u"--video"_s, u"A=a.mp4"_s, u"--rate"_s,  u"1e9"_s}
                              << QByteArray("from 0.1 to 100,000");
        QTest::newRow("height") << QStringList{u"robot"_s,    u"add"_s,     u"%P"_s,       u"x"_s,
                                               u"--colour"_s, u"#d72328"_s, u"--height"_s, u"1e300"_s}
                                << QByteArray("up to 1 km");
        QTest::newRow("size") << QStringList{u"robot"_s,    u"add"_s,     u"%P"_s,     u"x"_s,
                                             u"--colour"_s, u"#d72328"_s, u"--size"_s, u"20000x20000"_s}
                              << QByteArray("it is larger than 10 m");
        QTest::newRow("name of nothing")
            << QStringList{u"robot"_s, u"add"_s, u"%P"_s, u"\u200b"_s, u"--colour"_s, u"#d72328"_s}
            << QByteArray("U+200B");
        QTest::newRow("an escape") << QStringList{u"robot"_s,     u"add"_s,      u"%P"_s,
                                                  u"\u001b[2J"_s, u"--colour"_s, u"#d72328"_s}
                                   << QByteArray("control character");
        QTest::newRow("long path") << QStringList{u"list"_s, QString(5000, u'A') + u".odo"_s}
                                   << QByteArray("File name too long");
        QTest::newRow("long project")
            << QStringList{u"new"_s, QString(300, u'A') + u".odo"_s} << QByteArray("its name");
        QTest::newRow("a loop of links")
            << QStringList{u"list"_s, u"%/loop.odo"_s} << QByteArray("Too many levels of symbolic links");
    }
    void whatIsTooMuchIsRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, words);
        QFile::link(path(u"loop.odo"_s), path(u"loop.odo"_s));
        const QString project = changed("SELECT 1");
        const QByteArray before = fileHash(project);
        for (QString &each : arguments)
            each.replace(u"%P"_s, project).replace(u"%/"_s, m_folder.path() + u'/');
        const ProgramRun run = runProgram(arguments);
        QVERIFY2(run.exitStatus == 1 || run.exitStatus == 2, run.err.constData());
        QVERIFY2(run.err.count('\n') == 1 && run.err.contains(words) && !run.err.contains('\x1b'),
                 run.err.constData());
        QCOMPARE(fileHash(project), before);
    }

    void aWorkingDirectoryThatIsGone()
    {
        for (const QStringList &call : {QStringList{u"list"_s, u"a.odo"_s}, QStringList{u"new"_s, u"a.odo"_s},
                                        QStringList{u"check"_s, u"../a.odo"_s}}) {
            const ProgramRun run =
                limited(u"mkdir '%1' && cd '%1' && rmdir '%1'"_s.arg(path(u"gone"_s)), call);
            QVERIFY2(run.exitStatus == 1 && problemOf(run).isEmpty(), run.err.constData());
        }
    }

    void senselessScales()
    {
        for (const char *factor : {"nan", "inf", "0", "-1", "1e300", "x"}) {
            const ProgramRun run =
                limited(u"export QT_SCALE_FACTOR=%1 QT_FONT_DPI=%1 QT_SCREEN_SCALE_FACTORS=%1"_s.arg(
                            QLatin1String(factor)),
                        {u"snapshot"_s, m_sound, u"Trial 1"_s, u"-o"_s, path(u"out.png"_s), u"--size"_s,
                         u"800x600"_s});
            QVERIFY2(run.exitStatus == 0, (QByteArray(factor) + ": " + run.err).constData());
        }
    }

    /// Megabytes of addresses, in steps of 20 or of 160.
    void littleMemory()
    {
        if (isSanitized)
            QSKIP("not under a sanitizer");
        const int step = isAll() ? 20 : 160;
        for (const QStringList &call : calls(m_sound)) {
            for (int megabytes = 100; megabytes <= 900; megabytes += step) {
                const ProgramRun run = limited(u"ulimit -v %1; ulimit -c 0"_s.arg(megabytes * 1024), call);
                if (run.exitStatus == 127 && run.err.contains("loading shared libraries"))
                    continue; // the system's loader, before the program begins
                const QString problem = problemOf(run);
                QVERIFY2(problem.isEmpty(),
                         qPrintable(call.join(u' ') + u" with %1 MB: "_s.arg(megabytes) + problem));
            }
        }
    }

    void fewFiles()
    {
        for (const QStringList &call : calls(m_sound)) {
            for (int files = 4; files <= 40; files += isAll() ? 1 : 6) {
                const ProgramRun run = limited(u"ulimit -n %1; ulimit -c 0"_s.arg(files), call);
                if (run.exitStatus == 127 && run.err.contains("loading shared libraries"))
                    continue;
                const QString problem = problemOf(run);
                QVERIFY2(problem.isEmpty(),
                         qPrintable(call.join(u' ') + u" with %1 files: "_s.arg(files) + problem));
                QVERIFY2(run.exitStatus == 0 || run.err.toLower().contains("too many") ||
                             run.err.contains("problems found"),
                         qPrintable(call.join(u' ') + u" with %1 files: "_s.arg(files) +
                                    QString::fromUtf8(run.err)));
            }
        }
    }
};

ODOGRAPH_TEST(TestHostileContent, QCoreApplication)
#include "tst_hostile_content.moc"
