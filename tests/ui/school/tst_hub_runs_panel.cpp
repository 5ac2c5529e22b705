// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of all benches in the window, with a real PostgreSQL.
#include "core/project/school_repository.h"
#include "tests/school/bad_network.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/school/hub_bench.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/school/hub_runs_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int longMs = 60'000;
constexpr qint64 longestStandstillMs = 1000;

QString cell(const HubRunsPanel &panel, int row, int column)
{
    return panel.findChild<QTableView *>()->model()->index(row, column).data().toString();
}
int rows(const HubRunsPanel &panel)
{
    return panel.findChild<QTableView *>()->model()->rowCount();
}

} // namespace

class TestHubRunsPanel : public QObject
{
    Q_OBJECT
    HubBench m_bench;

    /// So many runs, one a day, of two teams.
    void fill(int runs) const
    {
        m_bench.server.sql(
            QStringLiteral(
                "SET session_replication_role = replica; "
                "INSERT INTO odograph.document (uuid, kind, name, bench, owner, revision, sha256, body) "
                "SELECT md5('t' || i)::uuid, 'trial', 'Run ' || i, md5('b')::uuid, 'bench2', "
                "nextval('odograph.revision'), repeat('0', 64), '\\x00' FROM generate_series(1, %1) i; "
                "INSERT INTO odograph.result (trial, robot, owner, name, team, shown_team, class, task, "
                "held, "
                "duration_s) SELECT md5('t' || i)::uuid, 'Red', 'bench2', 'Run ' || i, 'x', "
                "CASE WHEN i % 2 = 0 THEN 'Falcon' ELSE 'Heron' END, '9B', 'Slalom', "
                "timestamptz '2026-01-01' + i * interval '1 day', 10 FROM generate_series(1, %1) i")
                .arg(runs));
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_bench.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
    }
    void init() { m_bench.clear(); }

    void theNewestComeFirstAndMoreOnScrolling()
    {
        fill(600);
        HubRunsPanel panel;
        panel.setHub(m_bench.address("bench1"));
        QElapsedTimer opening;
        opening.start();
        panel.show();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 250, longMs);
        qInfo("the first page took %lld ms", opening.elapsed());
        QVERIFY(opening.elapsed() < 1000 * slowness);
        QCOMPARE(cell(panel, 0, 1), QStringLiteral("Run 600"));
        QCOMPARE(cell(panel, 0, 2), QStringLiteral("bench2"));
        QCOMPARE(cell(panel, 0, 3), QStringLiteral("Falcon"));
        QCOMPARE(cell(panel, 1, 1), QStringLiteral("Run 599"));
        auto *table = panel.findChild<QTableView *>();
        for (const int expected : {500, 600}) {
            table->scrollToBottom();
            QTRY_COMPARE_WITH_TIMEOUT(rows(panel), expected, longMs);
        }
        QCOMPARE(cell(panel, 599, 1), QStringLiteral("Run 1"));
        QTRY_VERIFY(panel.isSettled());
        QVERIFY(!table->model()->canFetchMore({}));
    }

    void theSearchFindsTrialsAndTeams()
    {
        fill(40);
        HubRunsPanel panel;
        panel.setHub(m_bench.address("bench1"));
        panel.show();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 40, longMs);
        auto *search = panel.findChild<QLineEdit *>();
        search->setText(QStringLiteral("heron"));
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 20, longMs);
        QCOMPARE(cell(panel, 0, 3), QStringLiteral("Heron"));
        search->setText(QStringLiteral("run 17"));
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 1, longMs);
        search->setText(QStringLiteral("nobody"));
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 0, longMs);
        search->clear();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 40, longMs);
    }

    void aBenchCanBeChosen()
    {
        fill(300);
        const auto project = m_bench.project("bench.odo", 2);
        QVERIFY(connectToSchool(*project, m_bench.address("bench1"), {}));
        QVERIFY(publishToSchool(*project, WithRecordings::No, {}));
        HubRunsPanel panel;
        panel.setHub(m_bench.address("bench1"));
        panel.show();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 250, longMs);
        auto *bench = panel.findChild<QComboBox *>();
        QVERIFY(bench->isVisible());
        QCOMPARE(bench->count(), 3);
        bench->setCurrentIndex(bench->findData(QStringLiteral("bench1")));
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 2, longMs);
        QCOMPARE(cell(panel, 0, 2), QStringLiteral("bench1"));
        bench->setCurrentIndex(bench->findData(QStringLiteral("bench2")));
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 250, longMs);
        panel.findChild<QTableView *>()->scrollToBottom();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 300, longMs);
        QCOMPARE(bench->currentText(), QStringLiteral("bench2"));
    }

    void aServerThatIsAwayIsNamedAndAskedAgain()
    {
        fill(3);
        HubRunsPanel panel;
        panel.setHub(m_bench.address("bench1"));
        m_bench.server.stop();
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isSettled() && says(panel, "Check the address"), longMs);
        QCOMPARE(m_bench.server.start(), QString());
        panel.hide();
        panel.show();
        QTRY_COMPARE_WITH_TIMEOUT(rows(panel), 3, longMs);
    }

    /// It is closed while it waits.
    void aSilentServerKeepsNobodyWaiting()
    {
        BadNetwork network(m_bench.server.folder() + QStringLiteral("/.s.PGSQL.5432"));
        network.next = [] { return Fault{Fault::Kind::Silence, 2'000, {}, {}}; };
        StandstillWatch standstill;
        auto panel = std::make_unique<HubRunsPanel>();
        panel->setHub(
            *HubAddress::parse(QStringLiteral("postgresql://bench1@127.0.0.1:%1/school?sslmode=disable")
                                   .arg(network.serverPort())
                                   .toStdString()));
        panel->show();
        QTRY_VERIFY_WITH_TIMEOUT(network.befallen > 0, longMs);
        QVERIFY(!panel->isSettled());
        panel.reset();
        QTest::qWait(1); // the watch sees it
        QVERIFY2(standstill.longestMs() < longestStandstillMs * slowness,
                 qPrintable(QString::number(standstill.longestMs())));
    }
};

ODOGRAPH_TEST(TestHubRunsPanel, QApplication)
#include "tst_hub_runs_panel.moc"
