// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/same_records.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

/// Trials, their tasks, and what was measured in them.
class TestTrialRecords : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_project = std::make_unique<StoredProject>(); }

    void trialsRoundTrip()
    {
        const RecordId camera = (*m_project)->cameras().add({0, "A", ""})->id;
        const RecordId red = (*m_project)->robots().add(robotNamed("red"))->id;
        const RecordId blue = (*m_project)->robots().add(robotNamed("blue"))->id;
        TrialRecord wanted;
        wanted.name = "Lauf „1“";
        wanted.team = (*m_project)->teams().add({0, "Dynamo", "8b"})->id;
        wanted.task = "figure eight";
        wanted.date = m_source.instant();
        wanted.notes = "two\nlines\tand a tab";
        wanted.syncMethod = "auto";
        wanted.syncOffsetS = m_source.number();
        wanted.syncOffsetSigmaS = m_source.number();
        wanted.syncScore = m_source.number();
        wanted.robots = {blue, red};
        wanted.durationS = m_source.number();
        wanted.range = TimeSpan{Nanoseconds(0), Nanoseconds(7'000'000'001)};
        const std::vector<RecordingRecord> recordings = {m_source.recording(camera, 20000),
                                                         m_source.recording(camera, 0)};
        const auto stored = (*m_project)->trials().add(wanted, recordings);
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        m_project->reopen();
        const auto read = (*m_project)->trials().find("Lauf „1“");
        QVERIFY(read.has_value());
        QCOMPARE(read->id, stored->id);
        QCOMPARE(read->team, wanted.team);
        QCOMPARE(read->teamName, std::string("Dynamo"));
        QCOMPARE(read->className, std::string("8b"));
        QCOMPARE(read->task, wanted.task);
        QVERIFY(read->date == wanted.date);
        QCOMPARE(read->notes, wanted.notes);
        QCOMPARE(read->syncMethod, wanted.syncMethod);
        QVERIFY(same(read->syncOffsetS, wanted.syncOffsetS) && same(read->syncScore, wanted.syncScore));
        QVERIFY(same(read->syncOffsetSigmaS, wanted.syncOffsetSigmaS) &&
                same(read->durationS, wanted.durationS));
        QVERIFY(read->range == wanted.range); // one that begins with the trial is not none
        QVERIFY((*m_project)->trials().setRange(read->id, std::nullopt));
        QVERIFY(!(*m_project)->trials().get(read->id)->range);
        QVERIFY(read->robots == wanted.robots);
        QVERIFY((read->robotNames == std::vector<std::string>{"blue", "red"}));
        QCOMPARE(read->viewCount, 2);
        const auto views = (*m_project)->trials().recordings(stored->id);
        QCOMPARE(views->size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            const RecordingRecord &a = (*views)[i], &b = recordings[i];
            QCOMPARE(a.position, int(i));
            QCOMPARE(a.cameraName, std::string("A"));
            QVERIFY(a.path == b.path && a.sha256 == b.sha256 && a.bytes == b.bytes && a.widthPx == b.widthPx);
            QVERIFY(a.heightPx == b.heightPx && same(a.framesPerSecond, b.framesPerSecond));
            QVERIFY(same(a.startOffsetS, b.startOffsetS) && same(a.clockRate, b.clockRate));
            QVERIFY(a.syncMethod == b.syncMethod && same(a.startOffsetSigmaS, b.startOffsetSigmaS));
            QVERIFY(a.frameTimes == b.frameTimes);
        }
    }

    void tasksRoundTrip()
    {
        const Task wanted = m_source.task();
        const auto stored = (*m_project)->tasks().add({0, "Übung 1", wanted});
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        QVERIFY((*m_project)->tasks().add({0, "empty", {}}).has_value());
        m_project->reopen();
        QCOMPARE((*m_project)->tasks().all()->size(), std::size_t(2));
        const Task read = (*m_project)->tasks().find("Übung 1")->task;
        QVERIFY(read.kind == wanted.kind && read.path.closed &&
                read.limits.maxSpeedMps == wanted.limits.maxSpeedMps);
        QVERIFY(read.limits.maxAccelMps2 == wanted.limits.maxAccelMps2);
        QVERIFY(read.path.points == wanted.path.points && read.gates.size() == wanted.gates.size());
        for (std::size_t i = 0; i < wanted.gates.size(); ++i) {
            const Gate &a = read.gates[i], &b = wanted.gates[i];
            QVERIFY(a.name == b.name && a.role == b.role && sameMatrix(a.from, b.from) &&
                    sameMatrix(a.to, b.to));
        }
        QCOMPARE(read.zones.size(), wanted.zones.size());
        for (std::size_t i = 0; i < wanted.zones.size(); ++i)
            QVERIFY(read.zones[i].name == wanted.zones[i].name &&
                    read.zones[i].rule == wanted.zones[i].rule &&
                    read.zones[i].corners == wanted.zones[i].corners);
        const Task empty = (*m_project)->tasks().get((*m_project)->tasks().find("empty")->id)->task;
        QVERIFY(empty.gates.empty() && empty.path.points.empty() && !empty.limits.maxAccelMps2);
        QCOMPARE((*m_project)->tasks().add({0, "empty", {}}).error().code, ErrorCode::AlreadyExists);
        const auto missing = (*m_project)->tasks().find("x");
        QCOMPARE(missing.error().message(),
                 std::string("task 'x': the project has no such task; it has 'Übung 1', 'empty'"));
    }

    void aTaskThatCannotBeMeasuredIsRefusedWhole()
    {
        Task task = m_source.task();
        task.gates[2].name = "half";
        QCOMPARE((*m_project)->tasks().add({0, "t", task}).error().message(),
                 std::string("gate 'half': the name is used twice; give each gate a name of its own"));
        task = m_source.task();
        task.zones[0].corners.pop_back();
        task.zones[0].corners.pop_back();
        QCOMPARE(
            (*m_project)->tasks().add({0, "t", task}).error().message(),
            std::string("zone 'поле': it has fewer than three corners; enter the corners of its outline, "
                        "all the way round"));
        task = m_source.task();
        task.gates[1].name = "a\nb";
        QCOMPARE((*m_project)->tasks().add({0, "t", task}).error().code, ErrorCode::InvalidInput);
        QVERIFY((*m_project)->tasks().all()->empty());
    }

    void aTrialIsGivenAnotherTask()
    {
        TrialRecord trial;
        trial.name = "run";
        trial.task = "not described yet"; // a name alone is a task too
        const auto stored = (*m_project)->trials().add(trial, {});
        QVERIFY(stored.has_value());
        QCOMPARE(stored->task, trial.task);
        QVERIFY((*m_project)->tasks().add({0, "line", m_source.task()}).has_value());
        QVERIFY((*m_project)->trials().setTask(stored->id, "line").has_value());
        QCOMPARE((*m_project)->trials().get(stored->id)->task, std::string("line"));
        QVERIFY((*m_project)->trials().setTask(stored->id, "").has_value());
        QVERIFY((*m_project)->trials().get(stored->id)->task.empty());
        QCOMPARE((*m_project)->trials().setTask(999, "line").error().code, ErrorCode::NotFound);
    }

    void trialsAreListedNewestFirstAndCanBeChanged()
    {
        const RecordId robot = (*m_project)->robots().add(robotNamed("red"))->id;
        const RecordId camera = (*m_project)->cameras().add({0, "A", ""})->id;
        for (int i : {2, 1, 3}) {
            TrialRecord trial;
            trial.name = std::to_string(i);
            trial.date = Instant(std::chrono::milliseconds(i));
            QVERIFY((*m_project)
                        ->trials()
                        .add(trial, {m_source.recording(camera, 1), m_source.recording(camera, 1)}));
        }
        const auto all = (*m_project)->trials().all();
        QCOMPARE(all->front().name, std::string("3"));
        QCOMPARE(all->back().name, std::string("1"));
        TrialRecord trial = all->front();
        QVERIFY((*m_project)->trials().setNotes(trial.id, "wet floor"));
        QVERIFY((*m_project)->trials().setRobots(trial.id, {robot}));
        auto views = *(*m_project)->trials().recordings(trial.id);
        trial.syncMethod = views[1].syncMethod = "told";
        trial.syncOffsetS = views[1].startOffsetS = 0.25;
        trial.syncOffsetSigmaS = views[1].startOffsetSigmaS = 0.01;
        trial.syncRate = views[1].clockRate = 2e-4;
        trial.syncRateSigma = 3e-6;
        QVERIFY((*m_project)->trials().setSync(trial, views));
        const std::map<std::string, std::string> variables{{"surface", "carpet"}, {"battery", "7.4"}};
        QVERIFY((*m_project)->trials().setVariables(trial.id, variables));
        for (const auto &wrong : std::vector<std::map<std::string, std::string>>{
                 {{"surface", "two\nlines"}}, {{"", "x"}}, {{"x", ""}}, {{std::string(201, 'x'), "x"}}})
            QVERIFY(!(*m_project)->trials().setVariables(trial.id, wrong));
        const auto changed = (*m_project)->trials().get(trial.id);
        QCOMPARE(changed->notes, std::string("wet floor"));
        QVERIFY(changed->robots == std::vector<RecordId>{robot});
        QCOMPARE(changed->syncMethod, std::string("told"));
        QVERIFY(changed->variables == variables);
        QCOMPARE(changed->syncRate, 2e-4);
        QCOMPARE(changed->syncRateSigma, 3e-6);
        QCOMPARE((*m_project)->trials().recordings(trial.id)->at(1).startOffsetS, 0.25);
        QCOMPARE((*m_project)->trials().recordings(trial.id)->at(1).clockRate, 2e-4);
        QCOMPARE((*m_project)->trials().recordings(trial.id)->at(1).syncMethod, std::string("told"));
        QCOMPARE((*m_project)->trials().recordings(trial.id)->at(1).startOffsetSigmaS, 0.01);
        QCOMPARE((*m_project)->trials().setNotes(999, "").error().code, ErrorCode::NotFound);
    }

    void observationsRoundTripAndTheNewestSeriesIsCurrent_data()
    {
        QTest::addColumn<bool>("haveSupport");
        QTest::newRow("ellipses") << false;
        QTest::newRow("with the support of whole silhouettes") << true;
    }
    void observationsRoundTripAndTheNewestSeriesIsCurrent()
    {
        QFETCH(bool, haveSupport);
        const auto filled = fill(**m_project, m_source);
        QVERIFY2(filled.has_value(), filled ? "" : filled.error().message().c_str());
        ObservationSeries wanted{filled->recordings[0], filled->robot, "colour 2", {}};
        for (int i = 0; i < 20000; ++i) // more than two chunks
            wanted.observations.push_back(m_source.observation(i));
        for (Observation &observation : wanted.observations)
            for (std::size_t k = 0; k < supportDirections && haveSupport && observation.found; ++k)
                observation.supportPx.push_back(float(observation.frame) + 0.25F * float(k));
        // Of the last chunk alone shadows leave some in doubt.
        for (std::size_t i = 17000; i < wanted.observations.size() && haveSupport; i += 3)
            wanted.observations[i].lastingCovariancePx2 << 2.5, -0.5, -0.5, 1 + double(i);
        QVERIFY((*m_project)->trials().addObservations(wanted).has_value());
        m_project->reopen();
        const auto read = (*m_project)->trials().currentObservations(wanted.recording, wanted.robot);
        QVERIFY(read && *read);
        QCOMPARE((*read)->algorithm, wanted.algorithm);
        QCOMPARE((*read)->observations.size(), wanted.observations.size());
        for (std::size_t i = 0; i < wanted.observations.size(); ++i)
            QVERIFY(sameObservation((*read)->observations[i], wanted.observations[i]));
        QVERIFY(!(*m_project)->trials().currentObservations(wanted.recording, 999)->has_value());
        const auto refused = (*m_project)->trials().addObservations({999, 999, "", {}});
        QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
    }

    void analysesRoundTrip()
    {
        const auto filled = fill(**m_project, m_source);
        QVERIFY(filled.has_value());
        AnalysisRecord wanted = m_source.analysis(filled->trial, filled->robot, 333);
        wanted.registrations = {1, 0};
        wanted.task = (*m_project)->tasks().find("line")->id;
        wanted.options.overrides = {{3, true}, {17, false}};
        wanted.profile.points[3].sigmaXM = std::numeric_limits<double>::infinity();
        wanted.profile.points[4].accelMps2 = -0.0;
        const auto stored = (*m_project)->analyses().add(wanted);
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        m_project->reopen();
        const auto current = (*m_project)->analyses().current(filled->trial);
        QVERIFY2(current.has_value(), current ? "" : current.error().message().c_str());
        QCOMPARE(current->size(), std::size_t(1));
        const AnalysisRecord &read = current->front();
        QCOMPARE(read.id, stored->id);
        QCOMPARE(read.robotName, std::string("red"));
        QVERIFY(read.trial == wanted.trial && read.robot == wanted.robot && read.made == wanted.made);
        QCOMPARE(read.softwareVersion, wanted.softwareVersion);
        QVERIFY(read.options.smoother == wanted.options.smoother);
        QVERIFY(same(read.options.maxSpeedMps, wanted.options.maxSpeedMps));
        QVERIFY(same(read.options.maxAccelMps2, wanted.options.maxAccelMps2));
        QVERIFY(read.options.longestBridgedGap == wanted.options.longestBridgedGap);
        QVERIFY(read.options.overrides == wanted.options.overrides);
        QVERIFY(read.registrations == wanted.registrations && read.views == wanted.views);
        const Profile &a = read.profile, &b = wanted.profile;
        QVERIFY(same(a.heightM, b.heightM) && a.heightEstimated == b.heightEstimated);
        QVERIFY(same(a.meanViewDisagreementM, b.meanViewDisagreementM));
        QCOMPARE(a.samples.size(), b.samples.size());
        for (std::size_t i = 0; i < b.samples.size(); ++i)
            QVERIFY(sameSample(a.samples[i], b.samples[i]) && samePoint(a.points[i], b.points[i]));
        QCOMPARE(a.spikes.size(), b.spikes.size());
        QVERIFY(a.spikes[0].sampleIndex == b.spikes[0].sampleIndex && a.spikes[0].time == b.spikes[0].time);
        QVERIFY(a.spikes[0].flags == b.spikes[0].flags && a.spikes[0].reason == b.spikes[0].reason);
        compareMetrics(a.metrics, b.metrics);
        QCOMPARE(read.task, wanted.task);
        QCOMPARE(a.passages.size(), b.passages.size());
        for (std::size_t i = 0; i < b.passages.size(); ++i) {
            QVERIFY(a.passages[i].gate == b.passages[i].gate && a.passages[i].role == b.passages[i].role);
            QVERIFY(a.passages[i].time == b.passages[i].time &&
                    same(a.passages[i].sigmaS, b.passages[i].sigmaS));
            QVERIFY(same(a.passages[i].commonSigmaS, b.passages[i].commonSigmaS));
        }
        QCOMPARE(read.ambiguousNames.size(), wanted.ambiguousNames.size());
        for (std::size_t i = 0; i < wanted.ambiguousNames.size(); ++i) {
            const AmbiguousName &is = read.ambiguousNames[i], &was = wanted.ambiguousNames[i];
            QVERIFY(is.from == was.from && is.to == was.to && is.others == was.others);
            QCOMPARE(is.otherNames,
                     was.others.empty() ? std::vector<std::string>() : std::vector<std::string>{"red"});
        }
        const auto cheap = (*m_project)->analyses().currentMetrics(filled->trial);
        QVERIFY(cheap && cheap->size() == 1 && cheap->front().profile.samples.empty());
        compareMetrics(cheap->front().profile.metrics, b.metrics);
    }

    void doubtsOfAnyTimeAreRead()
    {
        const auto filled = fill(**m_project, m_source);
        const RecordId id = (*m_project)->analyses().current(filled->trial)->front().id;
        const auto connection = ProjectConnection::open((*m_project)->file(), DatabaseAccess::ReadWrite);
        QVERIFY((*connection)
                    ->execute(QStringLiteral(
                        "UPDATE doubtful_name SET from_ns=9223372036854775807, to_ns=-9223372036854775807")));
        const auto read = (*m_project)->analyses().ambiguousNames(id);
        QVERIFY(read && read->size() == 2);
        QVERIFY(read->front().from == Nanoseconds(0) && read->front().to > Nanoseconds(0));
        // in order, and not too far apart for the difference
        QVERIFY(read->front().to - read->front().from > Nanoseconds(0));
        QVERIFY((*m_project)->analyses().ambiguousNames(id + 99)->empty());
    }

    void analysesThatCannotBeRightAreRefusedWhole()
    {
        const auto filled = fill(**m_project, m_source);
        const auto before = (*m_project)->analyses().current(filled->trial)->front().id;
        AnalysisRecord analysis = m_source.analysis(filled->trial, filled->robot, 5);
        analysis.profile.metrics[1].value = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE((*m_project)->analyses().add(analysis).error().message(),
                 std::string("metric 'duration': it is not a finite number; reanalyse the trial"));
        analysis = m_source.analysis(filled->trial, filled->robot, 5);
        analysis.profile.points.pop_back();
        QCOMPARE((*m_project)->analyses().add(analysis).error().code, ErrorCode::InvalidInput);
        QCOMPARE((*m_project)->analyses().add(m_source.analysis(999, 1, 5)).error().code,
                 ErrorCode::InvalidInput);
        analysis = m_source.analysis(filled->trial, filled->robot, 5);
        analysis.ambiguousNames[0].others = {filled->robot + 77}; // no robot
        QVERIFY(!(*m_project)->analyses().add(analysis));
        QCOMPARE((*m_project)->analyses().current(filled->trial)->front().id, before);
    }

    void overrulesRoundTripAndAreReplaced()
    {
        const auto filled = fill(**m_project, m_source);
        QVERIFY(filled.has_value());
        const auto said = [&] {
            return (*m_project)->trials().overrides(filled->trial, filled->robot).value();
        };
        QVERIFY(said().empty());
        QVERIFY(
            (*m_project)->trials().setManualOverrides(filled->trial, filled->robot, {{9, true}, {2, false}}));
        m_project->reopen();
        QVERIFY((said() == std::vector<ManualOverride>{{2, false}, {9, true}}));
        // Two words on one frame: refused, and the old ones stay.
        QVERIFY(!(*m_project)
                     ->trials()
                     .setManualOverrides(filled->trial, filled->robot, {{4, true}, {4, false}}));
        QCOMPARE(said().size(), std::size_t(2));
        QVERIFY((*m_project)->trials().setManualOverrides(filled->trial, filled->robot, {}));
        QVERIFY(said().empty());
        QVERIFY(!(*m_project)->trials().setManualOverrides(filled->trial + 99, filled->robot, {{1, true}}));
    }

    void pointedOutRobotsRoundTripAndAreReplaced()
    {
        const auto filled = fill(**m_project, m_source);
        QVERIFY(filled.has_value());
        const auto said = [&] { return (*m_project)->trials().pointedOut(filled->trial).value(); };
        QVERIFY(said().empty());
        const PointedOutRobot first{filled->robot, filled->recordings[0], 7, {1.0 / 3, 719}},
            second{filled->robot, filled->recordings[1], 0, {0, 12.5}};
        QVERIFY((*m_project)->trials().setPointedOut(filled->trial, {first, second}));
        m_project->reopen();
        QVERIFY((said() == std::vector<PointedOutRobot>{first, second}));
        // Two in one frame: refused, and the old ones stay. In two frames of a recording both are kept.
        QVERIFY(!(*m_project)->trials().setPointedOut(filled->trial, {first, first}));
        QCOMPARE(said().size(), std::size_t(2));
        PointedOutRobot later = first;
        later.frame = 9;
        QVERIFY((*m_project)->trials().setPointedOut(filled->trial, {later, first, second}));
        QVERIFY((said() == std::vector<PointedOutRobot>{first, later, second}));
        QVERIFY((*m_project)->trials().setPointedOut(filled->trial, {second}));
        QVERIFY((said() == std::vector<PointedOutRobot>{second}));
    }

    void truthRoundTripsAndIsReplaced()
    {
        const auto filled = fill(**m_project, m_source);
        const TruthSeries wanted = m_source.truth(filled->trial, filled->robot, 77);
        QVERIFY((*m_project)->trials().setTruth(wanted).has_value());
        m_project->reopen();
        const auto read = (*m_project)->trials().truth(filled->trial, filled->robot);
        QVERIFY(read && *read);
        QVERIFY((*read)->times == wanted.times);
        for (std::size_t i = 0; i < wanted.times.size(); ++i) {
            QVERIFY(sameMatrix((*read)->positions[i], wanted.positions[i]));
            QVERIFY(sameMatrix((*read)->velocities[i], wanted.velocities[i]));
            QVERIFY(sameMatrix((*read)->accelerations[i], wanted.accelerations[i]));
        }
        QVERIFY(!(*m_project)->trials().truth(filled->trial, 999)->has_value());
        TruthSeries uneven = wanted;
        uneven.velocities.pop_back();
        QCOMPARE((*m_project)->trials().setTruth(uneven).error().code, ErrorCode::InvalidInput);
    }

private:
    static void compareMetrics(const std::vector<Metric> &a, const std::vector<Metric> &b)
    {
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QCOMPARE(a[i].name, b[i].name);
            QCOMPARE(a[i].unit, b[i].unit);
            QVERIFY(same(a[i].value, b[i].value) && a[i].sigma == b[i].sigma);
        }
    }

    std::unique_ptr<StoredProject> m_project;
    RecordSource m_source{7};
};

ODOGRAPH_TEST(TestTrialRecords, QCoreApplication)
#include "tst_trial_records.moc"
