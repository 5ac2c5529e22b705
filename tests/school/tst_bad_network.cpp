// SPDX-License-Identifier: GPL-3.0-or-later
// Publishing through a network that delays, stalls and cuts connections: a call goes on or ends with one
// line, and after some of them the hub has each trial once.
#include "core/school/school_sync.h"
#include "tests/school/bad_network.h"
#include "tests/school/bench_trials.h"
#include "tests/school/postgres_server.h"
#include "tests/support/registered_test.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;

class TestBadNetwork : public QObject
{
    Q_OBJECT
    static constexpr int trials = 8;
    PostgresServer m_server;
    std::unique_ptr<BadNetwork> m_network;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_project;

    struct Call
    {
        int status = -1;
        QByteArray err;
    };
    /// While this thread is the network.
    Call publish() const
    {
        QProcess program;
        program.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                      {QStringLiteral("school"), QStringLiteral("publish"), m_project});
        if (!QTest::qWaitFor([&] { return program.state() == QProcess::NotRunning; }, 120'000)) {
            program.kill();
            program.waitForFinished();
            return {-1, "it did not end"};
        }
        return {program.exitCode(), program.readAllStandardError()};
    }
    int number(const char *statement) const { return m_server.sql(QString::fromLatin1(statement)).toInt(); }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_server.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
        const auto made =
            initialiseHub(*HubAddress::parse(m_server.url(QStringLiteral("postgres")).toStdString()));
        QVERIFY2(made, whyNot(made).c_str());
        m_server.sql(QStringLiteral("CREATE ROLE bench1 LOGIN IN ROLE bench"));
        m_network = std::make_unique<BadNetwork>(m_server.folder() + QStringLiteral("/.s.PGSQL.5432"));
        QVERIFY(m_network->isListening());
    }
    void init()
    {
        m_network->next = nullptr;
        m_server.sql(QStringLiteral("DELETE FROM odograph.document"));
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = m_folder->filePath(QStringLiteral("bench.odo"));
        const auto project = Project::create(m_project.toStdString(), "Bench");
        QVERIFY(project);
        const auto filled = addBenchTrials(**project, 1, trials);
        QVERIFY2(filled, whyNot(filled).c_str());
        // by the good way, for this thread cannot be the network meanwhile
        const auto connected = connectToSchool(
            **project, *HubAddress::parse(m_server.url(QStringLiteral("bench1")).toStdString()), {});
        QVERIFY2(connected, whyNot(connected).c_str());
        SchoolRepository &school = (*project)->school();
        auto link = **school.link();
        link.url = QStringLiteral("postgresql://bench1@127.0.0.1:%1/school")
                       .arg(m_network->serverPort())
                       .toStdString();
        QVERIFY(school.connect(link));
    }

    void everythingArrivesOnce_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 3; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void everythingArrivesOnce()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        int failures = 0;
        m_network->befallen = 0;
        m_network->next = [&] {
            Fault fault;
            fault.kind = Fault::Kind(1 + random() % 3);
            fault.afterBytes = qint64(20'000 + random() % 60'000);
            fault.delay = std::chrono::milliseconds(random() % 4);
            return fault;
        };
        for (;;) {
            const Call call = publish();
            if (call.status == 0)
                break;
            QCOMPARE(call.status, 1);
            QVERIFY2(call.err.startsWith("odograph: ") && call.err.count('\n') == 1, call.err.constData());
            QVERIFY(++failures < 30);
        }
        qInfo("%d faults, %d calls that failed", m_network->befallen, failures);
        QVERIFY(m_network->befallen > 3);
        eachTrialIsThereOnce();
    }

    /// The hub has a trial, and the bench does not know.
    void anAnswerThatIsLostMakesNoSecondTrial()
    {
        m_network->befallen = 0;
        m_network->next = [] { return Fault{Fault::Kind::None, 0, {}, "COMMIT"}; };
        const Call call = publish();
        QVERIFY2(call.status == 0, call.err.constData());
        QVERIFY(m_network->befallen > 3);
        eachTrialIsThereOnce();
    }

    /// Ends, with one line, and keeps everything for a later call.
    void aNetworkThatAlwaysCutsIsNamed()
    {
        m_network->next = [] { return Fault{Fault::Kind::Cut, 0, {}, {}}; };
        const Call call = publish();
        QCOMPARE(call.status, 1);
        QVERIFY2(call.err.startsWith("odograph: school hub '127.0.0.1/school': ") &&
                     call.err.count('\n') == 1,
                 call.err.constData());
        m_network->next = nullptr;
        QCOMPARE(publish().status, 0);
        QCOMPARE(number("SELECT count(*) FROM odograph.document WHERE kind = 'trial'"), trials);
    }

private:
    void eachTrialIsThereOnce()
    {
        const auto project = *Project::open(m_project.toStdString(), Project::Access::ReadOnly);
        QCOMPARE(project->school().pending().value(), 0);
        QCOMPARE(number("SELECT count(*) FROM odograph.document WHERE kind = 'trial'"), trials);
        QCOMPARE(number("SELECT count(DISTINCT name) FROM odograph.document WHERE kind = 'trial'"), trials);
        QCOMPARE(number("SELECT count(*) FROM odograph.result"), trials);
        QCOMPARE(number("SELECT count(*) FROM odograph.older_document"), 0);
        QCOMPARE(number("SELECT count(*) FROM odograph.document WHERE encode(sha256(body), 'hex') <> sha256"),
                 0);
    }
};

ODOGRAPH_TEST(TestBadNetwork, QCoreApplication)
#include "tst_bad_network.moc"
