// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/repositories.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/scoreboard/board_listener.h"
#include "tests/ui/support/slalom_lesson.h"
#include "ui/scoreboard/scoreboard.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestScoreboard : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project; ///< as another program has it open
    std::unique_ptr<Scoreboard> m_board;
    QNetworkAccessManager m_network;

    Result<std::unique_ptr<Scoreboard>> start(const StandingsChoice &choice = {})
    {
        ScoreboardSettings settings;
        settings.choice = choice;
        settings.port = 0;
        return Scoreboard::start(*Project::open(m_project->file(), Project::Access::ReadOnly), settings);
    }
    std::unique_ptr<QNetworkReply> got(const char *path, const QByteArray &method = "GET")
    {
        QNetworkRequest request(QUrl(m_board->url() + QLatin1String(path)));
        std::unique_ptr<QNetworkReply> reply(m_network.sendCustomRequest(request, method));
        QSignalSpy(reply.get(), &QNetworkReply::finished).wait();
        return reply;
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = makeSlalomLesson(m_folder->path().toStdString());
        auto board = start();
        QVERIFY2(board, board ? "" : board.error().message().c_str());
        m_board = std::move(*board);
    }
    void cleanup()
    {
        m_board.reset();
        m_project.reset();
    }

    void everyPartOfThePageIsServed_data()
    {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("page") << QByteArray("") << QByteArray("text/html") << QByteArray("<table");
        QTest::newRow("style") << QByteArray("scoreboard.css") << QByteArray("text/css")
                               << QByteArray("prefers-color-scheme:dark");
        QTest::newRow("script") << QByteArray("scoreboard.js") << QByteArray("text/javascript")
                                << QByteArray("EventSource");
        QTest::newRow("icon") << QByteArray("icon.svg") << QByteArray("image/svg+xml") << QByteArray("<svg");
    }
    void everyPartOfThePageIsServed()
    {
        QFETCH(QByteArray, path);
        QFETCH(QByteArray, type);
        QFETCH(QByteArray, words);
        const auto reply = got(path);
        QCOMPARE(reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt(), 200);
        QVERIFY(reply->header(QNetworkRequest::ContentTypeHeader).toByteArray().startsWith(type));
        QVERIFY(reply->rawHeader("Content-Security-Policy").contains("default-src 'none'"));
        const QByteArray body = reply->readAll();
        QVERIFY(body.contains(words));
        for (const char *outside :
             {"http:", "https:", "@import", "url(", "eval(", "innerHTML", " style=\"", " onclick"})
            QVERIFY2(path == "icon.svg" || !body.contains(outside), outside);
    }

    void otherRequestsAreRefused()
    {
        QCOMPARE(got("no")->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt(), 404);
        QCOMPARE(got("../etc/passwd")->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt(), 404);
        for (const char *method : {"POST", "PUT", "DELETE", "HEAD", "OPTIONS", "TRACE"})
            QCOMPARE(got("", method)->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt(), 405);
    }

    /// What another program stores is on the page within a second.
    void aNewRunIsShownWithinASecond()
    {
        Listener listener(m_network, m_board->url());
        QTRY_VERIFY(!listener.newest().isEmpty());
        QCOMPARE(listener.teams(), 0);
        for (int run = 0; run < 5; ++run) {
            const qsizetype before = listener.got.size();
            QElapsedTimer timer;
            timer.start();
            addSlalomRun(*m_project, run % 2 == 0 ? "Falcon" : "Heron", 9 - run);
            const qint64 storedMs = timer.restart();
            QTRY_VERIFY(listener.got.size() > before && listener.got.endsWith("\n\n"));
            qInfo("stored in %lld ms, shown after %lld ms", static_cast<long long>(storedMs),
                  static_cast<long long>(timer.elapsed()));
            QVERIFY(timer.elapsed() < 1000 * slowness);
        }
        QCOMPARE(listener.teams(), 2);
        QCOMPARE(got("map")->readAll().left(4), QByteArray("<svg"));
    }

    /// It only reads, so others never wait for it, and what does not concern it sends nothing.
    void nobodyWaitsForIt()
    {
        addSlalomRun(*m_project, "Falcon", 9);
        Listener listener(m_network, m_board->url());
        QTRY_COMPARE(listener.teams(), 1);
        const QByteArray before = listener.got;
        QElapsedTimer timer;
        for (int i = 0; i < 50; ++i) {
            timer.start();
            QVERIFY(m_project->setTitle("Title " + std::to_string(i)));
            QVERIFY(timer.elapsed() < 500 * slowness);
            QCoreApplication::processEvents();
        }
        QVERIFY(m_project->emptyLog());
        addSlalomRun(*m_project, "Heron", 9);
        QTRY_COMPARE(listener.teams(), 2);
        QCOMPARE(listener.got.count("data: "), before.count("data: ") + 1);
    }

    void theRunThatIsGoingOnIsShown()
    {
        TrialRecord trial;
        trial.name = "now";
        trial.team = m_project->teams().find("Otter")->id;
        trial.task = "Slalom";
        trial.date = std::chrono::time_point_cast<Instant::duration>(std::chrono::system_clock::now());
        auto lock = RecordingLock::take(m_project->mediaFolder());
        QVERIFY(lock);
        QVERIFY(m_project->trials().begin(trial, {}));
        Listener listener(m_network, m_board->url());
        const auto running = [&listener] { return listener.newest()[QStringLiteral("running")].toObject(); };
        QTRY_COMPARE(running()[QStringLiteral("team")].toString(), QStringLiteral("Otter"));
        QVERIFY(running()[QStringLiteral("seconds")].toDouble() < 60);
        lock->reset(); // the recorder was killed: nothing is stored
        QTRY_VERIFY(running().isEmpty());
    }

    void aClassThatGoesIsReported()
    {
        auto board = start({"9B", "Slalom", ""});
        QVERIFY(board);
        m_board = std::move(*board);
        addSlalomRun(*m_project, "Falcon", 9);
        Listener listener(m_network, m_board->url());
        QTRY_COMPARE(listener.teams(), 1);
        const auto task = m_project->tasks().find("Slalom");
        QVERIFY(m_project->tasks().rename(task->id, "Zigzag"));
        const auto note = [&listener] {
            return listener.newest()[QStringLiteral("notes")].toArray().at(0).toString();
        };
        QTRY_VERIFY2(note().contains(QStringLiteral("Slalom")), qPrintable(note()));
        QVERIFY(m_project->tasks().rename(task->id, "Slalom"));
        QTRY_COMPARE(note(), QString());
    }

    void aProjectThatIsGoneEndsIt()
    {
        QSignalSpy ended(m_board.get(), &Scoreboard::ended);
        QVERIFY(QFile::remove(QString::fromStdString(m_project->file().string())));
        QTRY_COMPARE(ended.count(), 1);
        const auto error = ended.front().front().value<Error>();
        QVERIFY(error.message().find("it was moved or deleted") != std::string::npos);
    }

    void whatIsChosenMustBeThere()
    {
        QCOMPARE(start({"7C", "", ""}).error().code, ErrorCode::NotFound);
        QCOMPARE(start({"", "Sprint", ""}).error().code, ErrorCode::NotFound);
    }

    void itListensOnThisComputerAlone()
    {
        QVERIFY(m_board->address().isLoopback());
        QCOMPARE(m_board->url(), QStringLiteral("http://127.0.0.1:%1/").arg(m_board->port()));
    }
};

ODOGRAPH_TEST(TestScoreboard, QCoreApplication)
#include "tst_scoreboard.moc"
