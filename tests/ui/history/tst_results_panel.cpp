// SPDX-License-Identifier: GPL-3.0-or-later
// Results of many trials as a table: sorted, filtered, grouped, copied and saved; fast for thousands.
#include "ui/history/internal/results_panel.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/trials/trial_table_reading.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/internal/result_statistics_model.h"
#include "ui/history/internal/results_model.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// So many runs of 15 teams with 20 metrics each.
std::shared_ptr<ResultTable> manyRuns(int count)
{
    auto table = std::make_shared<ResultTable>();
    for (int i = 0; i < 20; ++i)
        table->columns.push_back({"metric_" + std::to_string(i), "m"});
    for (int i = 0; i < count; ++i) {
        TrialTableRow row;
        row.trial.name = "Trial " + std::to_string(i);
        row.trial.teamName = "Team " + std::to_string(i % 15);
        row.trial.className = i % 2 == 0 ? "9A" : "9B";
        row.trial.date = Instant(std::chrono::seconds(i));
        row.robot = "Red";
        for (const TrialTableColumn &column : table->columns)
            row.metrics.push_back(Metric{column.metric, "m", (i * 7919 % 10007) / 1000.0, 0.01});
        table->rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

class TestResultsPanel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        m_project = openStoredExample(m_folder.path().toStdString());
    }
    void init()
    {
        QSettings().clear();
        m_panel = std::make_unique<ResultsPanel>(*m_project);
        m_panel->resize(900, 600);
        m_panel->show();
        m_panel->refresh();
        QTRY_VERIFY(m_panel->isSettled());
        m_table = m_panel->findChild<QTableView *>(QStringLiteral("results"));
        m_statistics = named<QTableView>(*m_panel, "Statistics");
    }
    void cleanup() { m_panel.reset(); }

    /// Trial 2 has two robots, trial 3 was not tracked.
    void showsEachRobotOfEachTrial()
    {
        QCOMPARE(m_table->model()->rowCount(), 4);
        QCOMPARE(cell(0, "Trial"), QStringLiteral("Trial 1")); // the newest
        const auto table = readTrialTable(*m_project, {});
        QVERIFY(table);
        const std::optional<Metric> speed = valueOf(*table, "Trial 1", "max_speed");
        QVERIFY(speed);
        const NumberText text = metricNumber(*speed);
        QCOMPARE(cell(0, "Top speed (m/s)"), QStringLiteral("%1 ±%2").arg(text.value, text.sigma));
        QCOMPARE(cell(rowOf("Trial 3"), "Verdict"), QStringLiteral("not tracked"));
        QCOMPARE(cell(rowOf("Trial 3"), "Top speed (m/s)"), QString());
    }

    void sortsByAMetricWithWhatIsMissingLast()
    {
        for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
            m_table->sortByColumn(columnOf(*m_table, "Top speed (m/s)"), order);
            QCOMPARE(cell(3, "Trial"), QStringLiteral("Trial 3"));
            const double first = number(cell(0, "Top speed (m/s)")),
                         second = number(cell(1, "Top speed (m/s)"));
            QVERIFY(order == Qt::AscendingOrder ? first <= second : first >= second);
        }
    }

    void filtersAndGroups()
    {
        named<QLineEdit>(*m_panel, "Search the results")->setText(QStringLiteral("heron 2"));
        QCOMPARE(m_table->model()->rowCount(), 2); // both robots of trial 2
        named<QLineEdit>(*m_panel, "Search the results")->clear();
        QCOMPARE(m_table->model()->rowCount(), 4);
        auto *groups = named<QComboBox>(*m_panel, "Group by");
        groups->setCurrentIndex(groups->findText(QStringLiteral("By team")));
        QTRY_VERIFY(m_panel->isSettled());
        QSet<QString> teams;
        for (int row = 0; row < m_statistics->model()->rowCount(); ++row)
            teams << m_statistics->model()->index(row, ResultStatisticsModel::GroupColumn).data().toString();
        QCOMPARE(teams, (QSet<QString>{QStringLiteral("Falcon"), QStringLiteral("Heron")}));
        const ResultsPanel again(*m_project); // it is remembered
        QCOMPARE(QSettings().value(QStringLiteral("results/group")).toString(), QStringLiteral("team"));
    }

    /// Statistics are of all that is shown, or of two selected rows or more.
    void statisticsFollowTheSelection()
    {
        const auto runs = [this] {
            return m_statistics->model()->index(0, ResultStatisticsModel::RunsColumn).data().toString();
        };
        QTRY_COMPARE(runs(), QStringLiteral("3"));
        m_table->selectRow(rowOf("Trial 1"));
        QTRY_VERIFY(m_panel->isSettled());
        QCOMPARE(runs(), QStringLiteral("3"));
        named<QLineEdit>(*m_panel, "Search the results")->setText(QStringLiteral("Heron"));
        QTRY_COMPARE(runs(), QStringLiteral("2"));
        m_table->selectAll();
        QTRY_VERIFY(says(*m_panel, "Statistics of 2 run"));
    }

    /// With headings, value and σ apart, in all digits: a spreadsheet takes it as it is.
    void copiesWithHeadings()
    {
        m_table->selectRow(rowOf("Trial 1"));
        m_table->setFocus();
        QTest::keyClick(m_table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(2));
        const QStringList heads = lines.at(0).split(u'\t'), cells = lines.at(1).split(u'\t');
        QCOMPARE(cells.size(), heads.size());
        const qsizetype speed = heads.indexOf(QStringLiteral("Top speed (m/s)"));
        QCOMPARE(heads.at(speed + 1), QStringLiteral("± Top speed (m/s)"));
        const auto table = readTrialTable(*m_project, {});
        const std::optional<Metric> value = valueOf(*table, "Trial 1", "max_speed");
        QVERIFY(std::abs(number(cells.at(speed)) - value->value) < 1e-8 * value->value);
        QVERIFY(std::abs(number(cells.at(speed + 1)) - *value->sigma) < 1e-8 * *value->sigma);
        m_statistics->clearSelection();
        m_statistics->setFocus();
        QTest::keyClick(m_statistics, Qt::Key_C, Qt::ControlModifier);
        const QStringList all = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(all.size(), qsizetype(m_statistics->model()->rowCount() + 1));
        QVERIFY(all.front().contains(QStringLiteral("\t± Mean\t")));
    }

    void metricsAreChosenAndRemembered()
    {
        auto *menu = m_panel->findChild<QMenu *>();
        const int before = m_table->model()->columnCount();
        QAction *unchosen = nullptr;
        for (QAction *each : menu->actions())
            if (each->isCheckable() && !each->isChecked())
                unchosen = each;
        QVERIFY(unchosen);
        unchosen->trigger();
        QCOMPARE(m_table->model()->columnCount(), before + 1);
        ResultsPanel again(*m_project);
        again.refresh();
        QTRY_VERIFY(again.isSettled());
        QCOMPARE(again.findChild<QTableView *>(QStringLiteral("results"))->model()->columnCount(),
                 before + 1);
    }

    /// Defined in a dialog that says what is wrong, it is a column like any other, also the next time.
    void ownMetricsByAFormula()
    {
        const auto define = [](QDialog &dialog) {
            auto *rows = named<QTableWidget>(dialog, "Own metrics");
            button(dialog, "Add")->click();
            rows->item(0, 0)->setText(QStringLiteral("energy"));
            rows->item(0, 1)->setText(QStringLiteral("J"));
            rows->item(0, 2)->setText(QStringLiteral("0.5 * weight * max_speed^2"));
            QVERIFY(says(dialog, "metric or variable 'weight'"));
            QVERIFY(!button(dialog, "OK")->isEnabled());
            rows->item(0, 2)->setText(QStringLiteral("0.5 * 0.4 * max_speed^2"));
            QVERIFY(button(dialog, "OK")->isEnabled());
            dialog.accept();
        };
        Person person({define});
        auto *menu = m_panel->findChild<QMenu *>();
        menu->actions().last()->trigger();
        QVERIFY(person.isDone());
        QTRY_VERIFY(m_panel->isSettled());
        const auto table = readTrialTable(*m_project, {});
        const double speed = valueOf(*table, "Trial 1", "max_speed")->value;
        const double shown = number(cell(rowOf("Trial 1"), "Energy (J)"));
        QVERIFY2(std::abs(shown / (0.2 * speed * speed) - 1) < 0.02, qPrintable(QString::number(shown)));
        ResultsPanel again(*m_project);
        again.refresh();
        QTRY_VERIFY(again.isSettled());
        columnOf(*again.findChild<QTableView *>(QStringLiteral("results")), "Energy (J)");
    }

    void savesWhatIsShown()
    {
        named<QLineEdit>(*m_panel, "Search the results")->setText(QStringLiteral("falcon"));
        const QString file = m_folder.filePath(QStringLiteral("class.csv"));
        QSignalSpy saved(m_panel.get(), &ResultsPanel::saved);
        const auto answer = [&file](QDialog &dialog) {
            auto *files = qobject_cast<QFileDialog *>(&dialog);
            QVERIFY(files);
            files->selectNameFilter(QStringLiteral("CSV for programs (*.csv)"));
            files->selectFile(file);
            QMetaObject::invokeMethod(files, "accept");
        };
        Person person({answer});
        button(*m_panel, "Save table…")->click();
        QVERIFY(person.isDone());
        QTRY_COMPARE(saved.count(), 1);
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArrayList lines = written.readAll().split('\n');
        QVERIFY2(lines.at(0).contains(",max_speed_m_s,sigma_max_speed_m_s"), lines.at(0).constData());
        QVERIFY(lines.at(1).startsWith("Trial 1,Falcon,9B,"));
        QCOMPARE(lines.size(), qsizetype(3));
    }

    void opensATrialByEnterOrDoubleClick()
    {
        QSignalSpy chosen(m_panel.get(), &ResultsPanel::trialChosen);
        m_table->setCurrentIndex(m_table->model()->index(rowOf("Trial 1"), 0));
        QTest::keyClick(m_table, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.at(0).at(0).toString(), QStringLiteral("Trial 1"));
    }

    void teamsByPseudonymAreNeverSavedByName()
    {
        ResultsModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        auto table = manyRuns(3);
        table->rows[0].trial.teamPseudonym = "Badger";
        model.setTable(table);
        model.setMetrics({0});
        QCOMPARE(model.shownTable().rows.back().trial.teamName, std::string("Team 0"));
        showPseudonyms(true);
        QCOMPARE(model.shownTable().rows.back().trial.teamName, std::string("Badger"));
        showPseudonyms(false);
    }

    /// Filter, sort and statistics of 20 metrics over 10,000 runs: beside other tests, six times the 50 ms
    /// that each may take. The workbook is written on another thread: six times ten seconds.
    void tenThousandRuns()
    {
        ResultsModel model;
        ResultStatisticsModel statistics;
        model.setTable(manyRuns(10'000));
        std::vector<std::size_t> columns(20);
        for (std::size_t i = 0; i < columns.size(); ++i)
            columns[i] = i;
        QElapsedTimer clock;
        const auto within = [&clock](const char *what) {
            const auto ms = double(clock.nsecsElapsed()) / 1e6;
            qInfo("%s: %.1f ms", what, ms);
            return ms < 300 * slowness;
        };
        clock.start();
        model.setMetrics(columns);
        QVERIFY(within("metrics"));
        clock.start();
        model.setFilter({"9A", {}, QStringLiteral("team 1")});
        QVERIFY(within("filter"));
        QVERIFY(model.rowCount() > 2000 && model.rowCount() < 5000);
        clock.start();
        model.setFilter({});
        QVERIFY(within("all"));
        clock.start();
        model.sort(ResultsModel::TrialColumn);
        QVERIFY(within("by name"));
        QCOMPARE(model.trialAt(2), QStringLiteral("Trial 2")); // not Trial 10
        clock.start();
        model.sort(ResultsModel::FactCount);
        QVERIFY(within("by metric"));
        clock.start();
        const auto found = resultStatistics(*model.table(), model.shownRows(), model.metrics(),
                                            {ResultGrouping::By::Team, {}});
        statistics.setStatistics(found, model.table()->columns, true);
        QVERIFY(within("statistics"));
        QCOMPARE(found.size(), std::size_t(20 * 15));
        clock.start();
        const QString text = model.tabbed({0, 1, 2});
        QVERIFY(within("copy of three"));
        clock.start();
        const auto shown = model.shownTable(); // before the file is written on another thread
        QVERIFY(within("table to save"));
        clock.start();
        QVERIFY(writeTrialTableXlsx(
            shown,
            OutputTarget(m_folder.filePath(QStringLiteral("all.xlsx")).toStdString(), Existing::ReplaceAny)));
        qInfo("workbook: %.1f s", double(clock.elapsed()) / 1e3);
        QVERIFY(clock.elapsed() < 60'000 * slowness);
    }

private:
    static int columnOf(const QTableView &table, const char *heading)
    {
        for (int column = 0; column < table.model()->columnCount(); ++column)
            if (table.model()->headerData(column, Qt::Horizontal).toString() == QString::fromUtf8(heading))
                return column;
        qFatal("no column %s", heading);
    }
    QString cell(int row, const char *heading) const
    {
        return m_table->model()->index(row, columnOf(*m_table, heading)).data().toString();
    }
    int rowOf(const char *trial) const
    {
        for (int row = 0; row < m_table->model()->rowCount(); ++row)
            if (cell(row, "Trial") == QLatin1String(trial))
                return row;
        qFatal("no trial %s", trial);
    }
    static double number(const QString &text) { return QLocale().toDouble(text.section(u' ', 0, 0)); }
    static std::optional<Metric> valueOf(const ResultTable &table, const char *trial, const char *metric)
    {
        for (const TrialTableRow &row : table.rows)
            if (row.trial.name == trial)
                for (const auto &each : row.metrics)
                    if (each && each->name == metric)
                        return each;
        return {};
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ResultsPanel> m_panel;
    QTableView *m_table = nullptr, *m_statistics = nullptr;
};

ODOGRAPH_TEST(TestResultsPanel, QApplication)
#include "tst_results_panel.moc"
