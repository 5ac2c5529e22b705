// SPDX-License-Identifier: GPL-3.0-or-later
// Which trials and metrics a table has. In the stored example, Trial 1 (Falcon) has one robot, Trial 2
// (Heron) has two, and Trial 3 was never tracked; Trial 1 is the newest.
#include "core/workflow/trials/trial_table_reading.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/stored_verdicts.h"
#include "core/workflow/trials/trial_changes.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;

class TestTrialTableReading : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = openStoredExample(m_folder->path().toStdString());
    }

    void aRowForEachRobotTheOldestFirst()
    {
        const ResultTable table = *readTrialTable(*m_project, {});
        QCOMPARE(names(table),
                 (QStringList{QStringLiteral("Trial 3/"), QStringLiteral("Trial 2/Red 2"),
                              QStringLiteral("Trial 2/Blue 1"), QStringLiteral("Trial 1/Red 2")}));
        QVERIFY(!table.rows[0].verdict);
        QVERIFY(std::ranges::none_of(table.rows[0].metrics, &std::optional<Metric>::has_value));
        const auto analyses = *m_project->analyses().currentMetrics(trial("Trial 1").id);
        for (const Metric &metric : analyses.front().profile.metrics)
            QCOMPARE(valueOf(table, 3, metric.name), metric.value);
    }

    void theChoiceLeavesOutOthers()
    {
        QCOMPARE(names(*readTrialTable(*m_project, {.team = "Heron"})).size(), 2);
        QCOMPARE(names(*readTrialTable(*m_project, {.className = "9B"})).size(), 3);
        const std::string task = trial("Trial 1").task;
        QVERIFY(!task.empty());
        const ResultTable ofTask = *readTrialTable(*m_project, {.task = task});
        QVERIFY(!ofTask.rows.empty());
        for (const TrialTableRow &row : ofTask.rows)
            QCOMPARE(row.trial.task, task);
        QVERIFY(setInBin(*m_project, {trial("Trial 2")}, true));
        QCOMPARE(names(*readTrialTable(*m_project, {})).size(), 2);
        QVERIFY(readTrialTable(*m_project, {.team = "Heron"})->rows.empty());
    }

    void metricsComeInTheGivenOrder()
    {
        const ResultTable table =
            *readTrialTable(*m_project, {.metrics = {"path_length", "duration", "score"}});
        QCOMPARE(table.columns.size(), std::size_t(3));
        QCOMPARE(table.columns[0].metric + table.columns[0].unit, std::string("path_lengthm"));
        QCOMPARE(table.columns[1].metric + table.columns[1].unit, std::string("durations"));
        QCOMPARE(table.columns[2].metric + table.columns[2].unit, std::string("scorepoints"));
    }

    void whatDoesNotExistIsNamed()
    {
        QCOMPARE(readTrialTable(*m_project, {.className = "7A"}).error().message(),
                 std::string("class '7A': the project has no such class; it has '9B'"));
        QCOMPARE(readTrialTable(*m_project, {.task = "Slalom"}).error().code, ErrorCode::NotFound);
        QCOMPARE(readTrialTable(*m_project, {.team = "Owl"}).error().code, ErrorCode::NotFound);
        const auto refused = readTrialTable(*m_project, {.metrics = {"beauty"}});
        QCOMPARE(refused.error().code, ErrorCode::NotFound);
        QVERIFY(refused.error().message().starts_with(
            "metric 'beauty': no trial of the project has it; choose from "));
    }

    /// As of projects of older formats, whose lower bounds are not marked.
    void lowerBoundsAreKnownBeforeVerdictsAreStored()
    {
        auto analysis = m_project->analyses().current(trial("Trial 1").id)->front();
        analysis.profile.metrics.front().isAtLeast = true;
        const std::string metric = analysis.profile.metrics.front().name;
        QVERIFY(m_project->analyses().add(std::move(analysis)));
        const auto isAtLeast = [&] {
            const ResultTable table = *readTrialTable(*m_project, {.metrics = {metric}});
            return table.rows[3].metrics[0]->isAtLeast;
        };
        const bool before = isAtLeast();
        QVERIFY(storeMissingVerdicts(*m_project));
        QVERIFY(before && isAtLeast());
        QVERIFY(readTrialTable(*m_project, {})->rows[3].verdict->level() == CheckLevel::Doubtful);
    }

    /// Once in metres, once in millimetres: never in one column.
    void aMetricOfTwoUnitsHasTwoColumns()
    {
        auto analysis = m_project->analyses().current(trial("Trial 1").id)->front();
        analysis.profile.metrics = {{"path_length", "mm", 1500, {}}};
        QVERIFY(m_project->analyses().add(std::move(analysis)));
        const ResultTable table = *readTrialTable(*m_project, {.metrics = {"path_length"}});
        QCOMPARE(table.columns.size(), std::size_t(2));
        QVERIFY(table.columns[0].unit == "m" && table.columns[1].unit == "mm");
        QVERIFY(table.rows[1].metrics[0] && !table.rows[1].metrics[1]);
        QVERIFY(!table.rows[3].metrics[0] && table.rows[3].metrics[1]->value == 1500);
    }

    void aChangedCourseIsSaid()
    {
        QVERIFY(m_project->tasks().add({0, "Lap", {.limits = {.maxSpeedMps = 3}}}));
        QVERIFY(!readTrialTable(*m_project, {})->rows[3].isMeasuredOtherwise);
        QVERIFY(editTrial(*m_project, trial("Trial 1").id, {.task = "Lap"}));
        QVERIFY(readTrialTable(*m_project, {})->rows[3].isMeasuredOtherwise);
    }

private:
    TrialRecord trial(const char *name) const { return *m_project->trials().find(name); }
    static QStringList names(const ResultTable &table)
    {
        QStringList names;
        for (const TrialTableRow &row : table.rows)
            names << QString::fromStdString(row.trial.name + '/' + row.robot);
        return names;
    }
    static double valueOf(const ResultTable &table, std::size_t row, const std::string &metric)
    {
        const auto its = std::ranges::find(table.columns, metric, &TrialTableColumn::metric);
        return table.rows[row].metrics[std::size_t(its - table.columns.begin())]->value;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestTrialTableReading, QCoreApplication)
#include "tst_trial_table_reading.moc"
