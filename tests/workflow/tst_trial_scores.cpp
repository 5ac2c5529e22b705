// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

class TestTrialScores : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void runsOfScoredTasksAreScored()
    {
        QTemporaryDir folder;
        const auto project = openStoredExample(folder.path().toStdString());
        const auto scores = [&] { return trialScores(*project, Instant::min(), Instant::max()).value(); };
        QVERIFY(scores().empty());
        const TrialRecord trial = *project->trials().find("Trial 1");
        const TaskRecord task = *project->tasks().find(trial.task);
        const AnalysisRecord analysis = project->analyses().currentMetrics(trial.id)->front();
        const Metric &length =
            *std::ranges::find(analysis.profile.metrics, std::string("path_length"), &Metric::name);
        // Half of the points at the length that it has.
        QVERIFY(
            project->tasks().setScoring(task.id, {{"path_length", length.value - 1, length.value + 1, 20}}));
        QCOMPARE(scores().size(), std::size_t(1));
        const bool isByTask = analysis.task == task.id || !hasCourse(task.task);
        QCOMPARE(scores()[0].score.has_value(), isByTask);
        if (!isByTask)
            QVERIFY(project->tasks().change({task.id, task.name, {}})); // without a course
        QVERIFY(std::abs(scores()[0].score->points - 10) < 1e-9);
        const auto metrics = scoreMetrics(*project, Instant::min(), Instant::max());
        QCOMPARE(metrics->size(), std::size_t(1));
        QCOMPARE(metrics->front().metric.name, std::string(scoreMetric));
        QVERIFY(trialScores(*project, Instant::min(), trial.date - std::chrono::hours(1))->empty());
        // With a course the stored analysis was measured by another one: it is not scored until it is
        // measured again.
        Task line;
        line.path.points = {{0, 0}, {1, 0}};
        QVERIFY(project->tasks().change({project->tasks().find(task.name)->id, task.name, line}));
        QVERIFY(!scores()[0].score);
        QVERIFY(scoreMetrics(*project, Instant::min(), Instant::max())->empty());
    }
};

ODOGRAPH_TEST(TestTrialScores, QCoreApplication)
#include "tst_trial_scores.moc"
