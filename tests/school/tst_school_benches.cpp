// SPDX-License-Identifier: GPL-3.0-or-later
// Many benches, each a program of its own, publish at once while the server is restarted and benches are
// killed: at the end the hub has each trial once, as its bench has it. ODOGRAPH_BENCHES: how many, with
// twenty trials each.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/school_documents.h"
#include "core/school/school_sync.h"
#include "tests/school/bench_trials.h"
#include "tests/school/postgres_server.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QFile>
#include <QMap>
#include <QProcess>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;

using odo::test::addBenchTrials;
using odo::test::PostgresServer;
using odo::test::whyNot;

namespace {

constexpr int trialsOfABench = 20;

/// One bench: its project, and the program that publishes it, again until it has ended well.
struct Bench
{
    QString project;
    std::unique_ptr<QProcess> program;
    bool isDone = false;
    int starts = 0;
};

int benchCount()
{
    const int given = qEnvironmentVariableIntValue("ODOGRAPH_BENCHES");
    return given > 0 ? given : 6;
}

} // namespace

class TestSchoolBenches : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_server.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
        const auto made = initialiseHub(addressOf(QStringLiteral("postgres")));
        QVERIFY2(made, whyNot(made).c_str());
        for (int i = 0; i < benchCount(); ++i) {
            const QString login = QStringLiteral("bench%1").arg(i);
            m_server.sql(QStringLiteral("CREATE ROLE %1 LOGIN IN ROLE bench").arg(login));
            Bench bench;
            bench.project = m_folder.filePath(login + QStringLiteral(".odo"));
            const auto project = Project::create(bench.project.toStdString(), login.toStdString());
            QVERIFY(project);
            const auto filled = addBenchTrials(**project, i, trialsOfABench);
            QVERIFY2(filled, whyNot(filled).c_str());
            const auto connected = connectToSchool(**project, addressOf(login), {});
            QVERIFY2(connected, whyNot(connected).c_str());
            m_benches.push_back(std::move(bench));
        }
    }

    void eachTrialArrivesOnce()
    {
        std::mt19937 random(5);
        const int most = benchCount(), kills = most * 2 / 5, restarts = 5;
        int killed = 0, restarted = 0;
        QElapsedTimer clock;
        clock.start();
        while (!allDone()) {
            QVERIFY2(clock.elapsed() < 280'000, "it took more than five minutes");
            startThoseThatEnded();
            const int arrived =
                m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.document")).toInt();
            // spread over the time in which they publish
            const int all = most * trialsOfABench;
            if (restarted < restarts && arrived >= restarted * all / (restarts + 1)) {
                m_server.restart(restarted % 2 == 0);
                ++restarted;
            }
            for (int i = 0; killed < kills && killed * all / kills <= arrived && i < 4; ++i) {
                Bench &bench = m_benches[random() % m_benches.size()];
                if (!bench.program || bench.program->state() != QProcess::Running)
                    continue;
                bench.program->kill();
                bench.program->waitForFinished(10'000);
                ++killed;
            }
            QTest::qWait(20);
        }
        QCOMPARE(restarted, restarts);
        int starts = 0;
        for (const Bench &bench : m_benches)
            starts += bench.starts;
        qInfo("%d benches, %d trials, %d restarts, %d kills, %d starts: %.1f s", most, most * trialsOfABench,
              restarted, killed, starts, double(clock.elapsed()) / 1000);
        compareAll();
    }

private:
    HubAddress addressOf(const QString &login) const
    {
        return *HubAddress::parse(m_server.url(login).toStdString());
    }

    bool allDone() const { return std::ranges::all_of(m_benches, &Bench::isDone); }

    void startThoseThatEnded()
    {
        for (Bench &bench : m_benches) {
            if (bench.isDone || (bench.program && bench.program->state() != QProcess::NotRunning))
                continue;
            if (bench.program && bench.program->exitStatus() == QProcess::NormalExit &&
                bench.program->exitCode() == 0) {
                bench.isDone = true;
                continue;
            }
            bench.program = std::make_unique<QProcess>();
            bench.program->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                                 {QStringLiteral("school"), QStringLiteral("publish"), bench.project});
            ++bench.starts;
        }
        QCoreApplication::processEvents();
    }

    void compareAll() const
    {
        QMap<QString, QString> atTheHub; // UUID to hash
        const QString rows = m_server.sql(
            QStringLiteral("SELECT uuid || ' ' || sha256 FROM odograph.document WHERE kind='trial'"));
        for (const QString &row : rows.split(u'\n', Qt::SkipEmptyParts))
            atTheHub.insert(row.section(u' ', 0, 0), row.section(u' ', 1));
        QCOMPARE(atTheHub.size(), qsizetype(m_benches.size()) * trialsOfABench);
        for (const Bench &bench : m_benches) {
            const auto project = *Project::open(bench.project.toStdString(), Project::Access::ReadWrite);
            SchoolRepository &school = project->school();
            QCOMPARE(school.pending().value(), 0);
            const auto trials = *project->trials().names();
            for (const TrialName &trial : trials) {
                const auto identity = *school.identity(SchoolKind::Trial, trial.id);
                const auto document = *makeSchoolDocument(*project, SchoolKind::Trial, trial.id);
                QCOMPARE(atTheHub.value(QString::fromStdString(identity.uuid)),
                         QString::fromStdString(document.sha256));
            }
        }
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.older_document")),
                 QStringLiteral("0"));
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.result")),
                 QString::number(atTheHub.size()));
        // what the hub has is what its hash says
        QCOMPARE(m_server.sql(QStringLiteral("SELECT count(*) FROM odograph.document WHERE "
                                             "encode(sha256(body), 'hex') <> sha256")),
                 QStringLiteral("0"));
    }

    PostgresServer m_server;
    QTemporaryDir m_folder;
    std::vector<Bench> m_benches;
};

ODOGRAPH_TEST(TestSchoolBenches, QCoreApplication)
#include "tst_school_benches.moc"
