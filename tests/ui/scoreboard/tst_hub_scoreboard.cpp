// SPDX-License-Identifier: GPL-3.0-or-later
// The standings of a hub, with a real PostgreSQL: the same as those of the project that published them, by
// any login, soon, and whatever becomes of the server.
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/school/school_sync.h"
#include "core/workflow/track/stored_verdicts.h"
#include "tests/school/postgres_server.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/scoreboard/board_listener.h"
#include "tests/ui/support/slalom_lesson.h"
#include "ui/scoreboard/scoreboard.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

using namespace odo;
using namespace odo::test;

class TestHubScoreboard : public QObject
{
    Q_OBJECT
    PostgresServer m_server;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    QNetworkAccessManager m_network;

    HubAddress hub(const char *login, const char *database = "school") const
    {
        return *HubAddress::parse(
            m_server.url(QString::fromLatin1(login), QString::fromLatin1(database)).toStdString());
    }
    static ScoreboardSettings anyPort(const StandingsChoice &choice)
    {
        ScoreboardSettings settings;
        settings.choice = choice;
        settings.port = 0;
        return settings;
    }
    std::unique_ptr<Scoreboard> hubBoard(const char *login, const StandingsChoice &choice = {}) const
    {
        auto board = Scoreboard::start(hub(login), anyPort(choice));
        if (!board)
            qWarning("%s", board.error().message().c_str());
        return board ? std::move(*board) : nullptr;
    }
    std::unique_ptr<Scoreboard> projectBoard(const StandingsChoice &choice = {}) const
    {
        return std::move(*Scoreboard::start(*Project::open(m_project->file(), Project::Access::ReadOnly),
                                            anyPort(choice)));
    }
    void publish()
    {
        const auto sent = publishToSchool(*m_project, WithRecordings::No, {});
        QVERIFY2(sent, sent ? "" : sent.error().message().c_str());
    }
    /// What a board shows once it has the same teams as the project's, without what only one of them has.
    QJsonObject shown(Scoreboard &board)
    {
        Listener listener(m_network, board.url());
        if (!QTest::qWaitFor([&] { return !listener.newest().isEmpty(); }, 10'000 * slowness))
            return {};
        QJsonObject state = listener.newest();
        for (const char *own : {"map", "mapWords"})
            state.remove(QLatin1String(own));
        return state;
    }
    static QString note(const Listener &listener)
    {
        return listener.newest()[QStringLiteral("notes")].toArray().at(0).toString();
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_server.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
        const auto made = initialiseHub(hub("postgres"));
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_server.sql(QStringLiteral("CREATE ROLE bench1 LOGIN IN ROLE bench; "
                                    "CREATE ROLE wall LOGIN IN ROLE viewer; CREATE ROLE stranger LOGIN"));
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_server.sql(QStringLiteral("DELETE FROM odograph.document"));
        m_project = makeSlalomLesson(m_folder->path().toStdString());
        const auto connected = connectToSchool(*m_project, hub("bench1"), {});
        QVERIFY2(connected, connected ? "" : connected.error().message().c_str());
    }
    void cleanup() { m_project.reset(); }

    /// Ranks that are shared and those that are not, classes, doubtful and bad runs, and another course.
    void theStandingsAreThoseOfTheProject_data()
    {
        QTest::addColumn<QString>("className");
        QTest::addColumn<QString>("metric");
        QTest::newRow("all") << QString() << QString();
        QTest::newRow("a class") << QStringLiteral("9B") << QString();
        QTest::newRow("another metric") << QString() << QStringLiteral("gate_time");
    }
    void theStandingsAreThoseOfTheProject()
    {
        QFETCH(QString, className);
        QFETCH(QString, metric);
        QVERIFY(m_project->teams().add({0, "Wasp", "8A"}));
        double seconds = 8;
        for (const char *team : {"Falcon", "Heron", "Otter", "Wasp", "Falcon", "Heron", "Wasp", "Otter"})
            addSlalomRun(*m_project, team, seconds += 0.07);
        QVERIFY(withdrawAcceptance(*m_project, "Run 3"));
        const StandingsChoice choice{className.toStdString(), "", metric.toStdString()};
        publish();
        compareBoards(choice);
        // and with what changes without the trials: an acceptance, a scoring, another course
        QVERIFY(withdrawAcceptance(*m_project, "Run 5"));
        publish();
        compareBoards(choice);
        const auto task = m_project->tasks().find("Slalom");
        QVERIFY(m_project->tasks().setScoring(task->id, {{"gate_time", 5, 12, 10}}));
        publish();
        compareBoards(choice);
        TaskRecord changed = *task;
        changed.task.gates = {{"start", GateRole::Start, {0, 0}, {0, 1}}};
        QVERIFY(m_project->tasks().change(changed));
        publish();
        compareBoards({choice.className, "", "gate_time"});
    }

    /// Of the best run, to whom the role shows its track.
    void theMapIsForThoseWhoMayReadTracks()
    {
        addSlalomRun(*m_project, "Falcon", 8);
        publish();
        for (const auto &[login, isMap] : {std::pair{"bench1", true}, std::pair{"wall", false}}) {
            const auto board = hubBoard(login);
            QVERIFY(board);
            Listener listener(m_network, board->url());
            QTRY_COMPARE(listener.teams(), 1);
            QCOMPARE(listener.newest().contains(QStringLiteral("map")), isMap);
            const std::unique_ptr<QNetworkReply> map(
                m_network.get(QNetworkRequest(QUrl(board->url() + QStringLiteral("map")))));
            QVERIFY(QSignalSpy(map.get(), &QNetworkReply::finished).wait());
            QCOMPARE(map->readAll().startsWith("<svg"), isMap);
        }
    }

    /// Which may come with the first run.
    void aTaskWithoutResultsIsEmpty()
    {
        const auto board = hubBoard("wall", {"7C", "Sprint", ""});
        QVERIFY(board);
        const QJsonObject state = shown(*board);
        QCOMPARE(state[QStringLiteral("task")].toString(), QStringLiteral("Sprint"));
        QCOMPARE(state[QStringLiteral("empty")].toString(), QStringLiteral("No team has a result yet."));
    }

    /// A team with a pseudonym is shown by it, whoever asks.
    void pseudonymsStandForTeams()
    {
        TeamRecord team = *m_project->teams().find("Falcon");
        team.pseudonym = "Blue";
        QVERIFY(m_project->teams().set(team));
        addSlalomRun(*m_project, "Falcon", 8);
        publish();
        const auto board = hubBoard("bench1");
        QVERIFY(board);
        const QByteArray state = QJsonDocument(shown(*board)).toJson();
        QVERIFY2(state.contains("Blue") && !state.contains("Falcon"), state.constData());
    }

    void whatIsPublishedIsShownWithinASecond()
    {
        const auto board = hubBoard("wall");
        QVERIFY(board);
        Listener listener(m_network, board->url());
        QTRY_VERIFY(!listener.newest().isEmpty());
        for (int run = 0; run < 5; ++run) {
            addSlalomRun(*m_project, run % 2 == 0 ? "Falcon" : "Heron", 9 - run);
            const qsizetype before = listener.got.size();
            publish();
            QElapsedTimer timer;
            timer.start();
            QTRY_VERIFY(listener.got.size() > before && listener.got.endsWith("\n\n"));
            qInfo("shown %lld ms after it was published", static_cast<long long>(timer.elapsed()));
            QVERIFY(timer.elapsed() < 1000 * slowness);
        }
        QTRY_COMPARE(listener.teams(), 2);
    }

    void aServerThatIsRestartedIsWaitedFor()
    {
        addSlalomRun(*m_project, "Falcon", 9);
        publish();
        const auto board = hubBoard("wall");
        QVERIFY(board);
        Listener listener(m_network, board->url());
        QTRY_COMPARE(listener.teams(), 1);
        m_server.stop();
        QTRY_VERIFY2(note(listener).contains(QStringLiteral("it cannot be reached")),
                     qPrintable(note(listener)));
        QVERIFY(!note(listener).contains(m_server.folder())); // which is not for everyone
        QCOMPARE(listener.teams(), 1);
        QVERIFY(m_server.start().isEmpty());
        QTRY_COMPARE(note(listener), QString());
        addSlalomRun(*m_project, "Heron", 8);
        publish();
        QTRY_COMPARE(listener.teams(), 2);
    }

    /// The page is served, and says so, while a query hangs; and the board can be ended.
    void aServerThatHangsHoldsUpNobody()
    {
        addSlalomRun(*m_project, "Falcon", 9);
        publish();
        auto board = hubBoard("wall");
        QVERIFY(board);
        Listener listener(m_network, board->url());
        QTRY_COMPARE(listener.teams(), 1);
        const auto process = pid_t(
            m_server.sql(QStringLiteral("SELECT pid FROM pg_stat_activity WHERE usename = 'wall'")).toInt());
        QVERIFY(process > 1);
        QCOMPARE(::kill(process, SIGSTOP), 0);
        QTRY_VERIFY_WITH_TIMEOUT(note(listener).contains(QStringLiteral("it cannot be reached")), 20'000);
        QElapsedTimer timer;
        timer.start();
        const std::unique_ptr<QNetworkReply> page(m_network.get(QNetworkRequest(QUrl(board->url()))));
        QVERIFY(QSignalSpy(page.get(), &QNetworkReply::finished).wait());
        QVERIFY(timer.elapsed() < 1000 * slowness);
        QCOMPARE(::kill(process, SIGCONT), 0);
        QTRY_COMPARE(note(listener), QString());
        QCOMPARE(::kill(process, SIGSTOP), 0);
        board.reset();
        ::kill(process, SIGCONT);
    }

    void whatIsNoHubIsRefused()
    {
        const auto refusal = [](const HubAddress &address) {
            const auto board = Scoreboard::start(address, anyPort({}));
            return board ? Error{} : board.error();
        };
        HubAddress nowhere = hub("wall");
        nowhere.host = "/nonexistent";
        const Error away = refusal(nowhere);
        QCOMPARE(away.code, ErrorCode::Unavailable);
        QVERIFY2(away.message().find("/nonexistent/school") != std::string::npos &&
                     away.message().find("~/.pgpass") != std::string::npos &&
                     away.message().find('\n') == std::string::npos,
                 away.message().c_str());
        QCOMPARE(refusal(hub("nobody")).code, ErrorCode::Unavailable);
        QCOMPARE(refusal(hub("postgres", "postgres")).code, ErrorCode::NotFound); // no hub
        QCOMPARE(refusal(hub("stranger")).code, ErrorCode::InvalidInput);         // no role
    }

private:
    void compareBoards(const StandingsChoice &choice)
    {
        const auto ours = projectBoard(choice), theirs = hubBoard("wall", choice);
        QVERIFY(ours && theirs);
        const QJsonObject expected = shown(*ours), found = shown(*theirs);
        QVERIFY(!expected.isEmpty());
        QVERIFY2(found == expected,
                 QJsonDocument(QJsonArray{expected, found}).toJson(QJsonDocument::Indented).constData());
    }
};

ODOGRAPH_TEST(TestHubScoreboard, QCoreApplication)
#include "tst_hub_scoreboard.moc"
