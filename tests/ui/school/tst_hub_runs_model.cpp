// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/school/internal/hub_runs_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

using namespace odo;

class TestHubRunsModel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// A page at a time, each asked for by whoever shows it.
    void pagesComeWhenTheyAreWanted()
    {
        HubRunsModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QVERIFY(!model.canFetchMore({}));
        HubRun run;
        run.name = "Run 1";
        model.setRuns({run}, false);
        QCOMPARE(model.rowCount(), 1);
        QCOMPARE(model.index(0, HubRunsModel::TrialColumn).data().toString(), QStringLiteral("Run 1"));
        const QSignalSpy wanted(&model, &HubRunsModel::moreWanted);
        QVERIFY(model.canFetchMore({}));
        model.fetchMore({});
        QVERIFY(wanted.size() >= 1);
        model.addRuns({run, run}, true);
        QCOMPARE(model.rowCount(), 3);
        QVERIFY(!model.canFetchMore({}));
        model.setRuns({}, true);
        QCOMPARE(model.rowCount(), 0);
    }

    /// What others call their teams is never markup.
    void namesStayText()
    {
        HubRunsModel model;
        HubRun run;
        run.team = "<b>Owls";
        model.setRuns({run}, true);
        const QModelIndex team = model.index(0, HubRunsModel::TeamColumn);
        QCOMPARE(team.data().toString(), QStringLiteral("<b>Owls"));
        QCOMPARE(team.data(Qt::ToolTipRole).toString(), QStringLiteral("&lt;b&gt;Owls"));
    }
};

ODOGRAPH_TEST(TestHubRunsModel, QCoreApplication)
#include "tst_hub_runs_model.moc"
