// SPDX-License-Identifier: GPL-3.0-or-later
// A project's tie to the hub as the window has it, with a real PostgreSQL: what is changed is sent by itself,
// whatever becomes of the server and the network, and the window never waits.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/school_repository.h"
#include "tests/school/bad_network.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/school/hub_bench.h"
#include "tests/ui/support/busy_watch.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {
constexpr int longMs = 60'000;
/// A call that waits for the server takes seconds; a busy computer may take this thread away for less.
constexpr qint64 longestStandstillMs = 1000;
} // namespace

class TestHubExchange : public QObject
{
    Q_OBJECT
    HubBench m_bench;
    std::unique_ptr<Project> m_project;

    bool isSent(const HubExchange &exchange) const
    {
        return !exchange.isRunning() && exchange.state().link && exchange.state().pending == 0;
    }
    void connectByItself(HubExchange &exchange, const char *login = "bench1")
    {
        exchange.setProject(m_project.get());
        exchange.connectTo(m_bench.address(login), {});
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
    }
    void note(const char *words, const char *trial = "run 1")
    {
        const auto found = m_project->trials().find(trial);
        QVERIFY(found);
        QVERIFY(m_project->trials().setNotes(found->id, words));
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_bench.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
    }
    void init()
    {
        m_bench.clear();
        m_project = m_bench.project("bench.odo", 3);
    }
    void cleanup() { m_project.reset(); }

    void whatIsChangedIsSentByItself()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        QCOMPARE(exchange.state().link->role, "bench");
        QVERIFY(exchange.state().link->lastSync);
        QCOMPARE(hubStateWords(exchange.state()), QStringLiteral("Hub: all sent"));
        QCOMPARE(m_bench.number("SELECT count(*) FROM odograph.document WHERE kind='trial'"), 3);
        const int before = m_bench.number("SELECT max(revision) FROM odograph.document");
        note("by hand");
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.number("SELECT max(revision) FROM odograph.document") > before,
                                  true, longMs);
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
    }

    void nothingIsSentWhileThereIsOtherWork()
    {
        HubExchange exchange(quickPace());
        bool isFree = false;
        int asked = 0;
        exchange.setMayPublish([&] {
            ++asked;
            return isFree;
        });
        exchange.setProject(m_project.get());
        exchange.connectTo(m_bench.address("bench1"), {});
        QTRY_VERIFY_WITH_TIMEOUT(asked > 5, longMs);
        QCOMPARE(m_bench.number("SELECT count(*) FROM odograph.document"), 0);
        QVERIFY(hubStateWords(exchange.state()).endsWith(QStringLiteral("pending")));
        isFree = true;
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
    }

    void aServerThatIsAwayGetsItLater()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        m_bench.server.stop();
        note("while it is away");
        QTRY_VERIFY_WITH_TIMEOUT(exchange.state().isAway() && !exchange.isRunning(), longMs);
        QCOMPARE(hubStateWords(exchange.state()), QStringLiteral("Hub: 1 pending, server away"));
        QCOMPARE(m_bench.server.start(), QString());
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
        QCOMPARE(hubStateWords(exchange.state()), QStringLiteral("Hub: all sent"));
    }

    /// The connection stands, and nothing comes any more: libpq itself would wait for ever.
    void theWindowNeverWaitsForASilentServer()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        BadNetwork network(m_bench.server.folder() + QStringLiteral("/.s.PGSQL.5432"));
        auto link = **m_project->school().link();
        link.url = QStringLiteral("postgresql://bench1@127.0.0.1:%1/school?sslmode=disable")
                       .arg(network.serverPort())
                       .toStdString();
        network.next = [] { return Fault{Fault::Kind::Silence, 3'000, {}, {}}; };
        QVERIFY(m_project->school().connect(link));
        BusyWatch busy;
        StandstillWatch standstill;
        note("never arrives");
        QTRY_VERIFY_WITH_TIMEOUT(network.befallen > 0, longMs);
        QVERIFY(exchange.isRunning());
        // a person waits for it in vain, changes something meanwhile, and gives up
        note("changed meanwhile");
        QTRY_COMPARE_WITH_TIMEOUT(exchange.state().words, QStringLiteral("Waiting for the server…"), longMs);
        QTRY_COMPARE_WITH_TIMEOUT(hubStateWords(exchange.state()),
                                  QStringLiteral("Hub: 3 pending, no answer yet"), longMs);
        exchange.cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exchange.isRunning(), longMs);
        QVERIFY(exchange.state().pending > 0);
        // and the project is closed in the middle of another attempt
        exchange.publish(WithRecordings::No);
        const int before = network.befallen;
        QTRY_VERIFY_WITH_TIMEOUT(network.befallen > before, longMs);
        QVERIFY(exchange.isRunning());
        QElapsedTimer closing;
        closing.start();
        exchange.setProject(nullptr);
        qInfo("closing took %lld ms, the longest standstill %lld ms, the longest work %.0f ms",
              closing.elapsed(), standstill.longestMs(), busy.longestMs());
        QVERIFY(closing.elapsed() < longestStandstillMs * slowness);
        QVERIFY2(standstill.longestMs() < longestStandstillMs * slowness,
                 qPrintable(QString::number(standstill.longestMs())));
        QVERIFY2(busy.longestMs() < longestAllowedMs(), qPrintable(QString::number(busy.longestMs())));
        // all arrives when the network is good again
        network.next = nullptr;
        exchange.setProject(m_project.get());
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
        QCOMPARE(m_bench.number("SELECT count(*) FROM odograph.document WHERE kind='trial'"), 3);
    }

    void thePasswordIsAskedForAndWrittenNowhere()
    {
        HubExchange exchange(quickPace());
        exchange.setProject(m_project.get());
        exchange.connectTo(m_bench.address("secret"), {});
        QTRY_VERIFY_WITH_TIMEOUT(exchange.state().isPasswordWanted, longMs);
        QVERIFY(!exchange.state().link);
        exchange.setPassword(m_bench.address("secret"), QStringLiteral("hunter3"));
        exchange.connectTo(m_bench.address("secret"), {});
        QTRY_VERIFY_WITH_TIMEOUT(exchange.state().isPasswordWanted, longMs);
        QVERIFY(!exchange.state().words.contains(QLatin1String("hunter")));
        exchange.setPassword(m_bench.address("secret"), QStringLiteral("hunter2"));
        exchange.connectTo(m_bench.address("secret"), {});
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
        note("sent with it, too");
        QTRY_VERIFY_WITH_TIMEOUT(exchange.state().pending > 0, longMs);
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
        exchange.setProject(nullptr);
        const QDir folder(QString::fromStdString(m_project->file().parent_path().string()));
        for (const QString &name : folder.entryList(QDir::Files)) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(!file.readAll().contains("hunter"), qPrintable(name));
        }
    }

    void bothValuesOfAConflictAreThere()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        exchange.setProject(nullptr);
        // at another bench: a teacher, who may change it
        const auto other = m_bench.project("other.odo", 0);
        QVERIFY(connectToSchool(*other, m_bench.address("anna"), {}));
        QVERIFY(pullFromSchool(*other, WithRecordings::No, {}));
        QVERIFY(other->trials().setNotes(other->trials().find("run 2")->id, "the teacher's"));
        QVERIFY(publishToSchool(*other, WithRecordings::No, {}));
        note("the bench's", "run 2");
        QSignalSpy conflicts(&exchange, &HubExchange::conflictsFound);
        exchange.setProject(m_project.get());
        QTRY_COMPARE_WITH_TIMEOUT(conflicts.size(), 1, longMs);
        QTRY_VERIFY_WITH_TIMEOUT(isSent(exchange), longMs);
        QCOMPARE(exchange.conflicts().size(), std::size_t(1));
        const SchoolConflict &conflict = exchange.conflicts().front();
        QCOMPARE(conflict.ours[QStringLiteral("notes")].toString(), QStringLiteral("the bench's"));
        QCOMPARE(conflict.theirs[QStringLiteral("notes")].toString(), QStringLiteral("the teacher's"));
        exchange.forgetConflicts();
        QVERIFY(exchange.conflicts().empty());
    }

    void whatOthersPublishedIsReceived()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        const auto other = m_bench.project("other.odo", 0);
        QVERIFY(connectToSchool(*other, m_bench.address("bench2"), {}));
        QVERIFY(other->teams().add({0, "Heron", {}}));
        QVERIFY(publishToSchool(*other, WithRecordings::No, {}));
        QSignalSpy received(&exchange, &HubExchange::received);
        exchange.pull(WithRecordings::No);
        QTRY_COMPARE_WITH_TIMEOUT(received.size(), 1, longMs);
        QVERIFY(m_project->teams().find("Heron"));
        QTRY_VERIFY2_WITH_TIMEOUT(exchange.state().words.contains(QLatin1String("1 item")),
                                  qPrintable(exchange.state().words), longMs);
    }

    /// One line, and no further attempt at once.
    void whatTheHubRefusesIsSaid()
    {
        HubExchange exchange(quickPace());
        exchange.setProject(m_project.get());
        exchange.connectTo(m_bench.address("stranger"), {});
        QTRY_VERIFY_WITH_TIMEOUT(exchange.state().problem && !exchange.isRunning(), longMs);
        QVERIFY(!exchange.state().isAway() && !exchange.state().isPasswordWanted);
        QVERIFY(!exchange.state().link);
        QCOMPARE(hubStateWords(exchange.state()), QString());
    }

    void aProjectToBeReadIsLeftAlone()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        note("for later");
        exchange.setProject(m_project.get(), true);
        exchange.publish(WithRecordings::No);
        QVERIFY(!exchange.isRunning());
        QCOMPARE(hubStateWords(exchange.state()), QStringLiteral("Hub: 1 pending"));
    }

    void disconnectingKeepsTheTrials()
    {
        HubExchange exchange(quickPace());
        connectByItself(exchange);
        QVERIFY(exchange.disconnectFromHub());
        QVERIFY(!exchange.state().link);
        QCOMPARE(hubStateWords(exchange.state()), QString());
        QCOMPARE(m_project->trials().all()->size(), std::size_t(3));
    }
};

ODOGRAPH_TEST(TestHubExchange, QApplication)
#include "tst_hub_exchange.moc"
