// SPDX-License-Identifier: GPL-3.0-or-later
// The command line with a real PostgreSQL: from an empty server to a trial on another bench, roles,
// conflicts, and what hostile rows do.
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/school/school_sync.h"
#include "tests/school/postgres_server.h"
#include "tests/support/calling_test.h"
#include "tests/support/noise_clip.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

using namespace odo;
using odo::test::PostgresServer;
using odo::test::ProgramRun;
using odo::test::runProgram;

/// A word of a call.
struct Word : QString
{
    Word(const char *text) : QString(QString::fromUtf8(text)) {}
    Word(const QString &text) : QString(text) {}
};

static QStringList listOf(std::initializer_list<Word> words)
{
    QStringList list;
    for (const Word &word : words)
        list << word;
    return list;
}

class TestSchoolHub : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_server.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
        const ProgramRun made = call({"school", "init", url("postgres")});
        QVERIFY2(made.exitStatus == 0, made.err.constData());
        m_server.sql(
            QStringLiteral("CREATE ROLE bench1 LOGIN IN ROLE bench; CREATE ROLE bench2 LOGIN IN ROLE bench; "
                           "CREATE ROLE anna LOGIN IN ROLE teacher; CREATE ROLE wall LOGIN IN ROLE viewer; "
                           "CREATE ROLE stranger LOGIN; "
                           "CREATE ROLE secret LOGIN PASSWORD 'hunter2' IN ROLE bench"));
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_server.sql(QStringLiteral("DELETE FROM odograph.document; DELETE FROM odograph.older_document"));
    }

    void initialisingTwiceChangesNothing()
    {
        const ProgramRun again = call({"school", "init", url("postgres"), "--json"});
        QCOMPARE(again.exitStatus, 0);
        QCOMPARE(again.json().value(QStringLiteral("schema_version")).toInt(), 3);
    }

    void aTrialGetsFromOneBenchToTheTeacher()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        const QJsonObject before = json({"school", "status", bench, "--json"});
        QCOMPARE(before.value(QStringLiteral("role")).toString(), QStringLiteral("bench"));
        QCOMPARE(before.value(QStringLiteral("schema_version")).toInt(), 3);
        QVERIFY(before.value(QStringLiteral("last_sync")).isNull());
        QVERIFY(before.value(QStringLiteral("pending")).toInt() >= 1);
        const QJsonObject sent = json({"school", "publish", bench, "--json"});
        QCOMPARE(sent.keys(), listOf({"conflicts", "media_bytes", "pending", "received", "sent"}));
        QCOMPARE(sent.value(QStringLiteral("pending")).toInt(), 0);
        QVERIFY(sent.value(QStringLiteral("sent")).toInt() >= 1);
        QCOMPARE(json({"school", "publish", bench, "--json"}).value(QStringLiteral("sent")).toInt(), 0);
        QVERIFY(!json({"school", "status", bench, "--json"}).value(QStringLiteral("last_sync")).isNull());

        const QJsonObject received = json({"school", "pull", teacher, "--json"});
        QCOMPARE(received.value(QStringLiteral("received")).toInt(),
                 sent.value(QStringLiteral("sent")).toInt());
        QCOMPARE(received.value(QStringLiteral("pending")).toInt(), 0);
        QCOMPARE(json({"school", "pull", teacher, "--json"}).value(QStringLiteral("received")).toInt(), 0);
        const QJsonObject here = json({"show", bench, "Run 1", "--json"}),
                          there = json({"show", teacher, "Run 1", "--json"});
        QCOMPARE(there.value(QStringLiteral("robots")), here.value(QStringLiteral("robots")));
        QCOMPARE(json({"list", teacher, "--json"}).value(QStringLiteral("trials")).toArray().size(), 1);
        const ProgramRun checked = call({"check", teacher, "--json"});
        QVERIFY2(checked.exitStatus == 0, checked.out.constData());
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.result")), QStringLiteral("1"));
        QVERIFY(call({"school", "disconnect", bench}).exitStatus == 0);
        QCOMPARE(call({"school", "status", bench}).exitStatus, 1);
    }

    void connectingAgainSendsNothingTwice()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        connect(bench, "bench1");
        json({"school", "publish", bench, "--json"});
        QCOMPARE(call({"school", "disconnect", bench}).exitStatus, 0);
        connect(bench, "bench1");
        const QJsonObject again = json({"school", "publish", bench, "--json"});
        QVERIFY(again.value(QStringLiteral("conflicts")).toArray().isEmpty());
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.document WHERE kind='trial'")),
                 QStringLiteral("1"));
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.older_document")),
                 QStringLiteral("0"));
    }

    void theLaterChangeWinsAndTheOtherIsKept()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        json({"school", "publish", bench, "--json"});
        json({"school", "pull", teacher, "--json"});
        QCOMPARE(call({"trial", "set", teacher, "Run 1", "--note", "by the teacher"}).exitStatus, 0);
        QCOMPARE(call({"trial", "set", bench, "Run 1", "--note", "by the bench"}).exitStatus, 0);
        QVERIFY(json({"school", "publish", teacher, "--json"})
                    .value(QStringLiteral("conflicts"))
                    .toArray()
                    .isEmpty());
        const QJsonArray conflicts =
            json({"school", "publish", bench, "--json"}).value(QStringLiteral("conflicts")).toArray();
        QCOMPARE(conflicts.size(), 1);
        const QJsonObject conflict = conflicts.at(0).toObject();
        QCOMPARE(conflict.value(QStringLiteral("in_force")).toString(), QStringLiteral("ours"));
        QCOMPARE(notes(conflict, "ours"), QStringLiteral("by the bench"));
        QCOMPARE(notes(conflict, "theirs"), QStringLiteral("by the teacher"));
        json({"school", "pull", teacher, "--json"});
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.older_document")),
                 QStringLiteral("2"));
        QCOMPARE(open(teacher)->trials().find("Run 1")->notes, "by the bench");
    }

    void pullingLeavesWhatIsNotPublishedYet()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        json({"school", "publish", bench, "--json"});
        json({"school", "pull", teacher, "--json"});
        call({"trial", "set", bench, "Run 1", "--note", "by the bench"});
        json({"school", "publish", bench, "--json"});
        call({"trial", "set", teacher, "Run 1", "--note", "by the teacher"});
        const QJsonObject pulled = json({"school", "pull", teacher, "--json"});
        QCOMPARE(pulled.value(QStringLiteral("conflicts")).toArray().size(), 1);
        QCOMPARE(open(teacher)->trials().find("Run 1")->notes, "by the teacher");
        const QJsonObject sent = json({"school", "publish", teacher, "--json"});
        QCOMPARE(sent.value(QStringLiteral("conflicts")).toArray().size(), 1);
    }

    void aRemovedTrialGoesIntoTheBinElsewhere()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        json({"school", "publish", bench, "--json"});
        json({"school", "pull", teacher, "--json"});
        {
            const auto project = open(bench);
            const RecordId trial = project->trials().find("Run 1")->id;
            QVERIFY(project->trials().setBinned(trial, true) && project->trials().removeForGood(trial));
        }
        json({"school", "publish", bench, "--json"});
        json({"school", "pull", teacher, "--json"});
        QVERIFY(open(teacher)->trials().find("Run 1")->binned.has_value());
    }

    void aBenchHasItsOwnTrialsOnly()
    {
        const QString first = benchProject("first.odo", "Run 1"), second = newProject("second.odo");
        {
            const auto project = open(first);
            QVERIFY(project->teams().add({0, "Falken", "8b", "", {"Anna Müller"}}));
        }
        connect(first, "bench1");
        connect(second, "bench2");
        json({"school", "publish", first, "--json"});
        const QString uuid =
            m_server.sql(QStringLiteral("SELECT uuid FROM odograph.document WHERE kind='trial'"));
        // as if it had a recording
        m_server.sql(
            QStringLiteral("INSERT INTO odograph.recording VALUES ('%1', 'bench1', '\\x01')").arg(uuid));
        const auto as = [&](const char *login, const char *statement) {
            return m_server.sql(QString::fromLatin1(statement), QString::fromLatin1(login));
        };
        QCOMPARE(as("bench1", "SELECT count(*) FROM odograph.recording"), QStringLiteral("1"));
        QCOMPARE(as("anna", "SELECT count(*) FROM odograph.recording"), QStringLiteral("1"));
        QCOMPARE(as("bench2", "SELECT count(*) FROM odograph.recording"), QStringLiteral("0"));
        as("bench2", "UPDATE odograph.document SET name='mine'");
        as("bench2", "UPDATE odograph.result SET team='mine'");
        as("bench2", "DELETE FROM odograph.result");
        as("bench2", "UPDATE odograph.recording SET body='\\x02'");
        QVERIFY(as("bench2", "DELETE FROM odograph.document").contains(QLatin1String("permission denied")));
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.document WHERE name='mine'")),
                 QStringLiteral("0"));
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.result WHERE team<>'mine'")),
                 QStringLiteral("1"));
        // through the program: its change is refused and reported
        json({"school", "pull", second, "--json"});
        call({"trial", "set", second, "Run 1", "--note", "by another bench"});
        const QJsonObject sent = json({"school", "publish", second, "--json"});
        QCOMPARE(sent.value(QStringLiteral("conflicts"))
                     .toArray()
                     .at(0)
                     .toObject()
                     .value(QStringLiteral("in_force")),
                 QStringLiteral("theirs"));
        json({"school", "pull", second, "--json"});
        QCOMPARE(open(second)->trials().find("Run 1")->notes, "");
    }

    void recordingsTravelThroughTheMediaFolder()
    {
        const QString clip = m_folder->filePath(QStringLiteral("clip.mp4")),
                      media = m_folder->filePath(QStringLiteral("media"));
        const QString bench = newProject("bench.odo"), teacher = newProject("teacher.odo"),
                      other = newProject("other.odo");
        QVERIFY(odo::test::writeNoiseClip(clip.toStdString(), 1));
        const ProgramRun imported = call(
            {"import", bench, "--trial", "Run 1", "--video", QStringLiteral("A=") + clip, "--sync", "none"});
        QVERIFY2(imported.exitStatus == 0, imported.err.constData());
        QCOMPARE(call({"school", "connect", bench, url("bench1")}).exitStatus, 0);
        const ProgramRun without = call({"school", "publish", bench, "--recordings"});
        QCOMPARE(without.exitStatus, 1);
        QVERIFY(without.err.contains("--media"));
        for (const auto &[project, login] :
             {std::pair{bench, "bench1"}, std::pair{teacher, "anna"}, std::pair{other, "bench2"}})
            QCOMPARE(call({"school", "connect", project, url(login), "--media", media}).exitStatus, 0);
        const QJsonObject sent = json({"school", "publish", bench, "--recordings", "--json"});
        QVERIFY(sent.value(QStringLiteral("media_bytes")).toDouble() > 0);
        QCOMPARE(json({"school", "publish", bench, "--recordings", "--json"})
                     .value(QStringLiteral("media_bytes"))
                     .toDouble(),
                 0.0);

        json({"school", "pull", teacher, "--json"});
        const QJsonObject results = json({"show", teacher, "Run 1", "--json"});
        QCOMPARE(results.value(QStringLiteral("recordings_at")).toString(), QStringLiteral("bench1"));
        QVERIFY(results.value(QStringLiteral("views")).toObject().isEmpty());
        QCOMPARE(call({"check", teacher}).exitStatus, 0);
        QVERIFY(json({"school", "pull", teacher, "--recordings", "--json"})
                    .value(QStringLiteral("media_bytes"))
                    .toDouble() > 0);
        const QJsonObject whole = json({"show", teacher, "Run 1", "--json"});
        const QJsonObject view =
            whole.value(QStringLiteral("views")).toObject().value(QStringLiteral("A")).toObject();
        QCOMPARE(view.value(QStringLiteral("sha256")).toString().toLatin1(),
                 odo::test::fileHash(clip).toHex());
        QVERIFY(!whole.contains(QStringLiteral("recordings_at")));
        const ProgramRun checked = call({"check", teacher});
        QVERIFY2(checked.exitStatus == 0, checked.out.constData());

        // another bench has no right to them
        json({"school", "pull", other, "--recordings", "--json"});
        QVERIFY(json({"show", other, "Run 1", "--json"}).value(QStringLiteral("views")).toObject().isEmpty());
    }

    void aDamagedRecordingIsLeftOut()
    {
        const QString clip = m_folder->filePath(QStringLiteral("clip.mp4")),
                      media = m_folder->filePath(QStringLiteral("media"));
        const QString bench = newProject("bench.odo"), teacher = newProject("teacher.odo");
        QVERIFY(odo::test::writeNoiseClip(clip.toStdString(), 1));
        call({"import", bench, "--trial", "Run 1", "--video", QStringLiteral("A=") + clip, "--sync", "none"});
        for (const auto &[project, login] : {std::pair{bench, "bench1"}, std::pair{teacher, "anna"}})
            QCOMPARE(call({"school", "connect", project, url(login), "--media", media}).exitStatus, 0);
        json({"school", "publish", bench, "--recordings", "--json"});
        QDirIterator all(media, QDir::Files, QDirIterator::Subdirectories);
        QVERIFY(all.hasNext());
        QFile stored(all.next());
        QVERIFY(stored.open(QIODevice::ReadWrite) && stored.seek(stored.size() / 2) && stored.putChar('!'));
        stored.close();
        const ProgramRun pulled = call({"school", "pull", teacher, "--recordings", "--json"});
        QCOMPARE(pulled.exitStatus, 0);
        QVERIFY2(pulled.err.contains("bench 'bench1' has it as"), pulled.err.constData());
        QVERIFY(
            json({"show", teacher, "Run 1", "--json"}).value(QStringLiteral("views")).toObject().isEmpty());
    }

    void aViewerReadsResultsWithoutNames()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        connect(bench, "bench1");
        json({"school", "publish", bench, "--json"});
        const auto as = [&](const QString &statement) {
            return m_server.sql(statement, QStringLiteral("wall"));
        };
        QCOMPARE(as(QStringLiteral("SELECT count(*) FROM odograph.metric WHERE name='duration'")),
                 QStringLiteral("1"));
        for (const char *denied :
             {"SELECT team FROM odograph.result", "SELECT name FROM odograph.result",
              "SELECT * FROM odograph.document", "SELECT * FROM odograph.older_document",
              "SELECT * FROM odograph.recording", "INSERT INTO odograph.metric SELECT * FROM odograph.metric",
              "DELETE FROM odograph.metric", "UPDATE odograph.metric SET value=0",
              "SELECT odograph.publish(gen_random_uuid(), 'team', 'x', gen_random_uuid(), 0, '', '', NULL, "
              "'[]', false)"})
            QVERIFY2(as(QString::fromLatin1(denied)).contains(QLatin1String("permission denied")), denied);
        QVERIFY(m_server.sql(QStringLiteral("SELECT * FROM odograph.metric"), QStringLiteral("stranger"))
                    .contains(QLatin1String("permission denied")));
        const QString viewer = newProject("viewer.odo");
        connect(viewer, "wall");
        const ProgramRun sent = call({"school", "pull", viewer});
        QCOMPARE(sent.exitStatus, 1);
        QCOMPARE(sent.err.count('\n'), 1);
        QVERIFY(sent.err.contains("the login may not do that"));
    }

    void runsAreListed()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        connect(bench, "bench1");
        json({"school", "publish", bench, "--json"});
        const auto listed = [&](const char *login, const char *search) {
            return json({"school", "list", url(login), "--search", search, "--metric", "duration", "--json"})
                .value(QStringLiteral("runs"))
                .toArray();
        };
        QCOMPARE(listed("bench1", "walk").size(), 0);
        const QJsonArray found = listed("bench1", "RUN 1");
        QCOMPARE(found.size(), 1);
        const QJsonObject run = found.at(0).toObject();
        QCOMPARE(run.keys(), listOf({"bench", "class", "date", "duration_s", "robot", "sigma", "standing",
                                     "task", "team", "trial", "unit", "uuid", "value"}));
        QCOMPARE(run.value(QStringLiteral("trial")).toString(), QStringLiteral("Run 1"));
        QCOMPARE(run.value(QStringLiteral("robot")).toString(), QStringLiteral("red"));
        QCOMPARE(run.value(QStringLiteral("bench")).toString(), QStringLiteral("bench1"));
        QCOMPARE(run.value(QStringLiteral("unit")).toString(), QStringLiteral("s"));
        QCOMPARE(listed("wall", "run 1").size(), 0); // a name that viewers may not read
        const auto of = [&](const char *login) {
            return json({"school", "list", url("bench1"), "--bench", login, "--json"})
                .value(QStringLiteral("runs"))
                .toArray()
                .size();
        };
        QCOMPARE(of("bench1"), 1);
        QCOMPARE(of("bench2"), 0);
        const ProgramRun words = call({"school", "list", url("wall")});
        QVERIFY2(words.exitStatus == 0 && words.out.startsWith("1 run\n"), words.out + words.err);
        QVERIFY(!words.out.contains("Run 1"));
    }

    /// By its own login, with its password, as psql takes it.
    void theStandingsAreServedToAViewer()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        connect(bench, "bench1");
        json({"school", "publish", bench, "--json"});
        const auto served = [&](const QString &address) {
            QProcess program;
            program.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                          listOf({"scoreboard", address, "--port", "0", "--json"}));
            QByteArray out;
            while (!out.endsWith("}\n") && program.waitForReadyRead(20'000))
                out += program.readAllStandardOutput();
            program.terminate();
            program.waitForFinished(20'000);
            return std::pair(program.exitCode(), QJsonDocument::fromJson(out).object());
        };
        const auto [status, answer] = served(url("wall"));
        QCOMPARE(status, 143);
        QVERIFY(answer.value(QStringLiteral("port")).toInt() > 0);
        QCOMPARE(answer.keys(), listOf({"address", "class", "metric", "port", "task", "url"}));
        QCOMPARE(served(url("secret")).first, 1);
        qputenv("PGPASSWORD", "hunter2");
        QCOMPARE(served(url("secret")).first, 143);
        qunsetenv("PGPASSWORD");
    }

    void noTableIsForThePublic()
    {
        QCOMPARE(m_server.sql(QStringLiteral(
                     "SELECT count(*) FROM pg_class c JOIN pg_namespace n ON n.oid=relnamespace, "
                     "aclexplode(coalesce(relacl, acldefault('r', relowner))) a WHERE nspname='odograph' "
                     "AND a.grantee=0")),
                 QStringLiteral("0"));
        QCOMPARE(m_server.sql(
                     QStringLiteral("SELECT string_agg(relname, ' ' ORDER BY relname) FROM pg_class c JOIN "
                                    "pg_namespace n ON n.oid=relnamespace WHERE nspname='odograph' AND "
                                    "relkind='r' AND NOT relrowsecurity")),
                 QStringLiteral("hub_version"));
    }

    void namesAreNoStatements()
    {
        const QString bench = benchProject("bench.odo", "Run'); DROP TABLE odograph.document; --");
        {
            const auto project = open(bench);
            QVERIFY(project->teams().add({0, "\\'; DELETE FROM odograph.document; $$", "8b\" OR 1=1"}));
        }
        const QString teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        QCOMPARE(json({"school", "publish", bench, "--json"}).value(QStringLiteral("pending")).toInt(), 0);
        json({"school", "pull", teacher, "--json"});
        QVERIFY(open(teacher)->trials().find("Run'); DROP TABLE odograph.document; --"));
        QVERIFY(open(teacher)->teams().find("\\'; DELETE FROM odograph.document; $$"));
    }

    void hostileRowsAreLeftOut()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        connect(teacher, "anna");
        for (const char *body : {"'\\x'", "'\\xff'", "'\\xa0'", "decode(repeat('61', 10000000), 'hex')",
                                 "decode('a1646e616d6507', 'hex')"})
            m_server.sql(
                QStringLiteral("INSERT INTO odograph.document (uuid, kind, name, bench, owner, sha256, body) "
                               "VALUES (gen_random_uuid(), 'trial', E'bad\\n\\u202e', gen_random_uuid(), "
                               "'bench1', repeat('0', 64), %1)")
                    .arg(QLatin1String(body)));
        json({"school", "publish", bench, "--json"});
        const ProgramRun pulled = call({"school", "pull", teacher, "--json"});
        QCOMPARE(pulled.exitStatus, 0);
        QCOMPARE(pulled.err.count('\n'), 5);
        QVERIFY(open(teacher)->trials().find("Run 1"));
        QCOMPARE(open(teacher)->trials().all()->size(), 1u);
        QVERIFY(m_server
                    .sql(QStringLiteral(
                        "INSERT INTO odograph.document (uuid, kind, name, bench, sha256, body) VALUES "
                        "(gen_random_uuid(), 'trial', repeat('x', 10000000), gen_random_uuid(), "
                        "repeat('0', 64), '')"))
                    .contains(QLatin1String("violates check constraint")));
    }

    void aPasswordIsNeverWritten()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        const QString refused =
            QStringLiteral("postgresql://secret:hunter2@/school?host=%1").arg(m_server.folder());
        const ProgramRun withPassword = call({"school", "connect", bench, refused});
        QCOMPARE(withPassword.exitStatus, 2);
        QVERIFY(!withPassword.err.contains("hunter2") && withPassword.err.contains(".pgpass"));
        const ProgramRun without = call({"school", "connect", bench, url("secret")});
        QCOMPARE(without.exitStatus, 1);
        qputenv("PGPASSWORD", "hunter3");
        const ProgramRun wrong = call({"school", "connect", bench, url("secret")});
        QCOMPARE(wrong.exitStatus, 1);
        QVERIFY(!wrong.err.contains("hunter3") && wrong.err.count('\n') == 1);
        qputenv("PGPASSWORD", "hunter2");
        const ProgramRun right = call({"school", "connect", bench, url("secret")});
        QVERIFY2(right.exitStatus == 0, right.err.constData());
        QCOMPARE(call({"school", "publish", bench}).exitStatus, 0);
        qunsetenv("PGPASSWORD");
        QDir folder(m_folder->path());
        for (const QString &name : folder.entryList(QDir::Files)) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(!file.readAll().contains("hunter"), qPrintable(name));
        }
    }

    void aHubThatIsAwayChangesNothing()
    {
        const QString bench = benchProject("bench.odo", "Run 1");
        connect(bench, "bench1");
        m_server.stop();
        const int pending =
            json({"school", "status", bench, "--json"}).value(QStringLiteral("pending")).toInt();
        QCOMPARE(call({"trial", "set", bench, "Run 1", "--note", "offline"}).exitStatus, 0);
        const ProgramRun sent = call({"school", "publish", bench});
        QCOMPARE(sent.exitStatus, 1);
        QCOMPARE(sent.err.count('\n'), 1);
        QCOMPARE(json({"school", "status", bench, "--json"}).value(QStringLiteral("pending")).toInt(),
                 pending);
        QVERIFY(m_server.start().isEmpty());
    }

    /// As docs/school.md says, into a server of its own, with the logins; then both go on.
    void backupAndRestore()
    {
        const QString bench = benchProject("bench.odo", "Run 1"), teacher = newProject("teacher.odo");
        connect(bench, "bench1");
        json({"school", "publish", bench, "--json"});
        const QString roles = m_server.folder() + QStringLiteral("/data/roles.sql"),
                      dump = m_server.folder() + QStringLiteral("/data/school.dump");
        QVERIFY(m_server.runTool(QStringLiteral("pg_dumpall"),
                                 listOf({"-U", "postgres", "--roles-only", "-f", roles})));
        QVERIFY(m_server.runTool(QStringLiteral("pg_dump"),
                                 listOf({"-U", "postgres", "-Fc", "-f", dump, "school"})));
        PostgresServer restored;
        QCOMPARE(restored.start(), QString());
        // the role postgres is there already, which is all that this may complain about
        QVERIFY(restored.runTool(QStringLiteral("psql"),
                                 listOf({"-X", "-q", "-U", "postgres", "-d", "postgres", "-f", roles})));
        QVERIFY(restored.runTool(QStringLiteral("createdb"), listOf({"-U", "postgres", "school"})));
        QVERIFY(
            restored.runTool(QStringLiteral("pg_restore"), listOf({"-U", "postgres", "-d", "school", dump})));
        for (const char *table : {"document", "result", "metric", "result_state", "hub_version"}) {
            const QString rows =
                QStringLiteral("SELECT md5(string_agg(t::text, '|' ORDER BY t::text)) FROM odograph.%1 t")
                    .arg(QLatin1String(table));
            QCOMPARE(restored.sql(rows), m_server.sql(rows));
        }
        QCOMPARE(restored.sql(QStringLiteral("SELECT count(*) FROM odograph.metric"), QStringLiteral("wall")),
                 m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.metric")));
        QVERIFY(restored.sql(QStringLiteral("SELECT count(*) FROM odograph.document"), QStringLiteral("wall"))
                    .contains(QLatin1String("permission denied")));

        const auto connectTo = [&](const QString &project, const char *login) {
            return call({"school", "connect", project, restored.url(QString::fromLatin1(login))}).exitStatus;
        };
        QCOMPARE(connectTo(teacher, "anna"), 0);
        json({"school", "pull", teacher, "--json"});
        QVERIFY(open(teacher)->trials().find("Run 1"));
        // and it goes on there: the bench only has to connect to it
        QCOMPARE(connectTo(bench, "bench1"), 0);
        call({"trial", "set", bench, "Run 1", "--note", "after the restore"});
        const QJsonObject sent = json({"school", "publish", bench, "--json"});
        QVERIFY(sent.value(QStringLiteral("conflicts")).toArray().isEmpty());
        QCOMPARE(sent.value(QStringLiteral("pending")).toInt(), 0);
        json({"school", "pull", teacher, "--json"});
        QCOMPARE(open(teacher)->trials().find("Run 1")->notes, "after the restore");
        QCOMPARE(restored.sql(QStringLiteral("SELECT count(*) FROM odograph.document WHERE kind='trial'")),
                 QStringLiteral("1"));
    }

    void wrongCallsChangeNothing_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::newRow("no verb") << listOf({"school", "send", "%P"}) << 2;
        QTest::newRow("no address") << listOf({"school", "connect", "%P", "nowhere"}) << 2;
        QTest::newRow("no project") << listOf({"school", "status", "/nonexistent.odo"}) << 1;
        QTest::newRow("a search too short")
            << listOf({"school", "list", "postgresql://wall@/school?host=%S", "--search", "ab"}) << 2;
        QTest::newRow("of another verb") << listOf({"school", "publish", "%P", "--class", "9B"}) << 2;
        QTest::newRow("not connected") << listOf({"school", "publish", "%P"}) << 1;
        QTest::newRow("not connected, pull") << listOf({"school", "pull", "%P"}) << 1;
        QTest::newRow("not connected, disconnect") << listOf({"school", "disconnect", "%P"}) << 1;
        QTest::newRow("no hub there")
            << listOf({"school", "connect", "%P", "postgresql://postgres@/postgres?host=%S"}) << 1;
        QTest::newRow("no role") << listOf(
                                        {"school", "connect", "%P", "postgresql://stranger@/school?host=%S"})
                                 << 1;
        QTest::newRow("may not") << listOf({"school", "init", "postgresql://stranger@/other?host=%S"}) << 1;
    }

    void wrongCallsChangeNothing()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        const QString project = newProject("plain.odo");
        const QByteArray before = odo::test::fileHash(project);
        for (QString &argument : arguments)
            argument.replace(QStringLiteral("%P"), project).replace(QStringLiteral("%S"), m_server.folder());
        const ProgramRun failed = runProgram(arguments);
        QCOMPARE(failed.exitStatus, status);
        QCOMPARE(failed.err.count('\n'), 1);
        QVERIFY(failed.err.startsWith("odograph: "));
        QCOMPARE(odo::test::fileHash(project), before);
    }

private:
    QString url(const char *login) const { return m_server.url(QString::fromLatin1(login)); }

    static ProgramRun call(std::initializer_list<Word> words) { return runProgram(listOf(words)); }

    static QJsonObject json(std::initializer_list<Word> words)
    {
        const ProgramRun run = call(words);
        if (run.exitStatus != 0 || run.json().isEmpty())
            qWarning("%s: %s%s", qPrintable(listOf(words).join(u' ')), run.out.constData(),
                     run.err.constData());
        return run.json();
    }

    static QString notes(const QJsonObject &conflict, const char *whose)
    {
        return conflict.value(QLatin1String(whose)).toObject().value(QStringLiteral("notes")).toString();
    }

    QString newProject(const char *name) const
    {
        QString file = m_folder->filePath(QString::fromLatin1(name));
        if (call({"new", file}).exitStatus != 0)
            qWarning("no project %s", name);
        return file;
    }

    /// With one trial, an imported track.
    QString benchProject(const char *name, const Word &trial) const
    {
        const QString project = newProject(name), track = m_folder->filePath(QStringLiteral("track.csv"));
        QFile file(track);
        if (file.open(QIODevice::WriteOnly))
            file.write(odo::test::gappedTrack(0));
        file.close();
        const ProgramRun imported =
            call({"import", project, "--trial", trial, "--track", QStringLiteral("red=") + track});
        if (imported.exitStatus != 0)
            qWarning("%s", imported.err.constData());
        return project;
    }

    static std::unique_ptr<Project> open(const QString &file)
    {
        return std::move(*Project::open(file.toStdString(), Project::Access::ReadWrite));
    }

    void connect(const QString &project, const char *login) const
    {
        const ProgramRun connected = call({"school", "connect", project, url(login)});
        QVERIFY2(connected.exitStatus == 0, connected.err.constData());
    }

    PostgresServer m_server;
    std::unique_ptr<QTemporaryDir> m_folder;
};

ODOGRAPH_TEST(TestSchoolHub, QCoreApplication)
#include "tst_school_hub.moc"
