// SPDX-License-Identifier: GPL-3.0-or-later
// Names, courses and scoring of tasks, and what depends on them.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

Task line(double lengthM)
{
    Task task;
    task.kind = TaskTemplate::StraightLine;
    task.gates = {gateAcross("Start", GateRole::Start, {0, 0}, {1, 0}, 0.5),
                  gateAcross("Finish", GateRole::Finish, {lengthM, 0}, {1, 0}, 0.5)};
    task.path.points = {{0, 0}, {lengthM, 0}};
    return task;
}

} // namespace

class TestTaskChanges : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aTaskGetsAnotherName();
    void aCourseIsChangedInItsPlace();
    void whatWasMeasuredKeepsTheTaskItWasMeasuredBy();
    void aLongNameStillHasAVersion();
    void changesAreTakenBack();
    void aTaskIsArchivedAndRestored();
    void zonesBelongToTheCourse();
    void whatIsUsedIsNotRemoved();
    void aScoringIsStored();
    void figuresOfScoredRunsAreRead();

private:
    TaskRepository &tasks() { return m_project->tasks(); }
    TaskRecord task(const std::string &name) { return tasks().find(name).value(); }
    std::vector<RecordId> measuredOtherwise() const
    {
        std::vector<RecordId> trials;
        const auto all = m_project->analyses().trialsMeasuredOtherwise().value();
        for (const OtherwiseMeasured &each : all)
            trials.push_back(each.trial);
        return trials;
    }
    void measure(RecordId byTask, std::vector<Metric> metrics = {});

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    FilledProject m_filled;
    std::size_t m_count = 0; ///< of the tasks
};

void TestTaskChanges::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_project =
        std::move(*Project::create(m_folder->filePath(QStringLiteral("year.odo")).toStdString(), "Year"));
    RecordSource source(5);
    m_filled = *fill(*m_project, source);
    QVERIFY(tasks().add({0, "Line", line(2)}));
    QVERIFY(m_project->trials().setTask(m_filled.trial, "Line"));
    m_count = tasks().all()->size();
}

void TestTaskChanges::measure(RecordId byTask, std::vector<Metric> metrics)
{
    RecordSource source(6);
    AnalysisRecord analysis = source.analysis(m_filled.trial, m_filled.robot, 4);
    analysis.task = byTask;
    analysis.profile.metrics = std::move(metrics);
    analysis.profile.passages = {{"Start", GateRole::Start, {}, 0.01, 0},
                                 {"Finish", GateRole::Finish, {}, 0.01, 0}};
    analysis.profile.spikes = {{0, {}, flagBit(SampleFlag::Jump), foreignWords("jump")},
                               {1, {}, flagBit(SampleFlag::SpeedLimit), foreignWords("fast")}};
    const auto added = m_project->analyses().add(analysis);
    QVERIFY2(added, added ? "" : added.error().message().c_str());
}

void TestTaskChanges::aTaskGetsAnotherName()
{
    const RecordId id = task("Line").id;
    QVERIFY(tasks().add({0, "Taken", {}}));
    QCOMPARE(tasks().rename(id, "Taken").error().code, ErrorCode::AlreadyExists);
    QCOMPARE(tasks().rename(id, " ").error().code, ErrorCode::InvalidInput);
    QCOMPARE(tasks().rename(id + 99, "Other").error().code, ErrorCode::NotFound);
    QVERIFY(tasks().rename(id, "Line"));
    QVERIFY(tasks().rename(id, "Sprint"));
    QCOMPARE(m_project->trials().get(m_filled.trial)->task, std::string("Sprint"));
}

void TestTaskChanges::aCourseIsChangedInItsPlace()
{
    TaskRecord changed = task("Line");
    QCOMPARE(tasks().change(changed)->id, changed.id); // nothing is another
    QVERIFY(tasks().setScoring(changed.id, {{"gate_time", 4, 10, 30}}));
    changed.task = line(3);
    const auto stored = tasks().change(changed);
    QVERIFY(stored.has_value());
    QCOMPARE(tasks().all()->size(), m_count); // nothing was measured by the one before: it is gone
    QCOMPARE(task("Line").task.path.points[1].x(), 3.0);
    QCOMPARE(tasks().scoring(stored->id)->size(), std::size_t(1));
    QCOMPARE(m_project->trials().get(m_filled.trial)->task, std::string("Line"));
    changed = *stored;
    changed.task.gates[0].to = changed.task.gates[0].from;
    QCOMPARE(tasks().change(changed).error().code, ErrorCode::InvalidInput);
    QCOMPARE(task("Line").id, stored->id);
}

void TestTaskChanges::whatWasMeasuredKeepsTheTaskItWasMeasuredBy()
{
    const RecordId first = task("Line").id;
    measure(first);
    const auto second = tasks().change({first, "Line", line(3)});
    QVERIFY(second && second->id != first);
    QCOMPARE(second->name, std::string("Line"));
    const AnalysisRecord analysis = m_project->analyses().currentMetrics(m_filled.trial)->front();
    QCOMPARE(analysis.task, first);
    QCOMPARE(tasks().get(first)->name, std::string("Line (version 1)"));
    QCOMPARE(tasks().get(first)->task.path.points[1].x(), 2.0);
    QVERIFY(isEarlierVersion(*tasks().get(first), tasks().uses()->at(first)));
    QCOMPARE(tasks().current()->size(), m_count); // to choose from there is only the newest
    QCOMPARE(tasks().all()->size(), m_count + 1);
    measure(second->id);
    QVERIFY(tasks().change({second->id, "Line", line(4)}));
    QCOMPARE(tasks().get(second->id)->name, std::string("Line (version 2)"));
}

void TestTaskChanges::aLongNameStillHasAVersion()
{
    const std::string longest(200, 'x');
    const RecordId first = task("Line").id;
    QVERIFY(tasks().rename(first, longest));
    measure(first);
    QVERIFY(tasks().change({first, longest, line(3)}));
    QCOMPARE(tasks().get(first)->name, std::string(188, 'x') + " (version 1)");
}

void TestTaskChanges::changesAreTakenBack()
{
    const TaskRecord before = task("Line");
    measure(before.id);
    QVERIFY(m_project->change(foreignWords("move the finish"), [&]() -> Result<void> {
        const auto done = tasks().change({before.id, "Line", line(3)});
        return done ? Result<void>() : tl::unexpected(done.error());
    }));
    QVERIFY(m_project->undo());
    QCOMPARE(task("Line").id, before.id);
    QCOMPARE(tasks().all()->size(), m_count);
    QVERIFY(m_project->redo());
    QCOMPARE(task("Line").task.path.points[1].x(), 3.0);
}

void TestTaskChanges::aTaskIsArchivedAndRestored()
{
    const RecordId id = task("Line").id;
    QVERIFY(
        m_project->change(foreignWords("archive task Line"), [&] { return tasks().setArchived(id, true); }));
    QVERIFY(task("Line").archived.has_value());
    QCOMPARE(tasks().current()->size(), m_count - 1); // not among those to choose from
    QCOMPARE(m_project->trials().get(m_filled.trial)->task, std::string("Line"));
    QVERIFY(tasks().change({id, "Line", line(3)}));
    QVERIFY(task("Line").archived.has_value()); // another course leaves it where it is
    QVERIFY(m_project->change(foreignWords("take it out"),
                              [&] { return tasks().setArchived(task("Line").id, false); }));
    QCOMPARE(tasks().current()->size(), m_count);
    QVERIFY(m_project->undo());
    QVERIFY(task("Line").archived.has_value());
    QVERIFY(m_project->redo());
    QCOMPARE(tasks().setArchived(999, true).error().code, ErrorCode::NotFound);
}

void TestTaskChanges::zonesBelongToTheCourse()
{
    TaskRecord changed = task("Line");
    changed.task = {};
    const RecordId bare = tasks().change(changed)->id;
    measure(bare);
    changed = task("Line");
    changed.task.zones = {rectangularZone("Field", ZoneRule::StayInside, {0, 0}, {3, 2})};
    const auto fenced = tasks().change(changed);
    QVERIFY(fenced && fenced->id != bare);
    QVERIFY(hasCourse(fenced->task));
    QCOMPARE(measuredOtherwise(), std::vector<RecordId>{m_filled.trial});
    changed = *fenced;
    changed.task.zones[0].rule = ZoneRule::StayOutside;
    QVERIFY(tasks().change(changed)->id != fenced->id);
    changed = task("Line");
    changed.task.zones.push_back(changed.task.zones[0]);
    QCOMPARE(tasks().change(changed).error().message(),
             std::string("zone 'Field': the name is used twice; give each zone a name of its own"));
}

void TestTaskChanges::whatIsUsedIsNotRemoved()
{
    const RecordId id = task("Line").id;
    measure(id);
    QCOMPARE(QString::fromStdString(tasks().remove(id).error().message()),
             QStringLiteral("task 'Line': a trial uses it; give them another task first"));
    QVERIFY(m_project->trials().setTask(m_filled.trial, ""));
    QCOMPARE(tasks().remove(id).error().why.english(), std::string("its rules were used to measure trials"));
    const auto spare = tasks().add({0, "Spare", line(1)});
    QVERIFY(tasks().setScoring(spare->id, {{"laps", 3, 0, 10}}));
    QVERIFY(tasks().remove(spare->id));
    QCOMPARE(tasks().find("Spare").error().code, ErrorCode::NotFound);
}

void TestTaskChanges::aScoringIsStored()
{
    const RecordId id = task("Line").id;
    const std::vector<Criterion> rubric{{"gate_time", 4, 10, 30}, {"spikes", 10, 0, -10}};
    QVERIFY(tasks().scoring(id)->empty());
    QVERIFY(tasks().setScoring(id, rubric));
    QVERIFY(*tasks().scoring(id) == rubric);
    QVERIFY(tasks().scorings()->at(id) == rubric);
    QCOMPARE(tasks().setScoring(id, {{"laps", 1, 1, 10}}).error().code, ErrorCode::InvalidInput);
    QVERIFY(*tasks().scoring(id) == rubric);
    QVERIFY(tasks().setScoring(id, {}));
    QVERIFY(tasks().scorings()->empty());
    QCOMPARE(tasks().setScoring(id + 99, rubric).error().code, ErrorCode::NotFound);
}

void TestTaskChanges::figuresOfScoredRunsAreRead()
{
    const RecordId id = task("Line").id;
    const auto read = [&] {
        return m_project->analyses().scoredMetrics(Instant::min(), Instant::max()).value();
    };
    measure(id, {{"gate_time", "s", 9, 0.1}, {"max_speed", "m/s", 1, {}}});
    QVERIFY(read().empty()); // the task is not scored
    QVERIFY(tasks().setScoring(id, {{"gate_time", 4, 10, 30}, {"spikes", 10, 0, -10}}));
    measure(id, {{"gate_time", "s", 7, 0.2}, {"max_speed", "m/s", 1, {}}}); // the newest counts
    const auto runs = read();
    QCOMPARE(runs.size(), std::size_t(1));
    QVERIFY(runs[0].trial == m_filled.trial && runs[0].robot == m_filled.robot && runs[0].task == id &&
            runs[0].isByTask);
    const Score score = scoreOf(*tasks().scoring(id), runs[0].metrics);
    QCOMPARE(score.points, 15.0 - 2.0);
    QCOMPARE(runs[0].metrics[1].value, 1.0); // beyond a limit
    QCOMPARE(runs[0].metrics[2].value, 2.0); // gates
    QVERIFY(m_project->analyses().trialsMeasuredOtherwise()->empty());
    QVERIFY(tasks().change({id, "Line", line(3)}));
    QVERIFY(!read()[0].isByTask);
    QCOMPARE(measuredOtherwise(), std::vector<RecordId>{m_filled.trial});
    const TaskRecord changed = task("Line");
    QVERIFY(tasks().change({changed.id, "Line", {}})); // without a course nothing depends on it
    QVERIFY(read()[0].isByTask);
    QVERIFY(m_project->analyses().trialsMeasuredOtherwise()->empty());
}

ODOGRAPH_TEST(TestTaskChanges, QCoreApplication)
#include "tst_task_changes.moc"
