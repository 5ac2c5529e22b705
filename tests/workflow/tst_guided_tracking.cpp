// SPDX-License-Identifier: GPL-3.0-or-later
// Areas that a person gives are inputs of the tracking: kept with the trial, noted with what was tracked by
// them, and undone with it; nothing that was recorded is altered.
#include "core/project/guidance_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/track/guidance.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trials/trial_copy.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;
using Kind = GuidanceItem::Kind;

class TestGuidedTracking : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    TrialRecord trial() const { return m_project->trials().find("run").value(); }
    Result<void> run(Job &&job) const { return runToEnd(job, *m_project, {}); }
    Result<void> track(const GuidanceEdit &edit = {}) const
    {
        TrackSettings settings;
        settings.guidance = edit;
        return run(TrackJob("run", settings));
    }
    /// Without the videos.
    bool again(const std::vector<GivenGuidance> &added) const
    {
        TrackSettings settings;
        settings.again = true;
        settings.guidance.added = added;
        const auto done = run(TrackJob("run", settings));
        if (!done)
            qWarning("%s", done.error().message().c_str());
        return done.has_value();
    }
    ObservationSeries seriesOf(std::size_t view) const
    {
        const auto recordings = m_project->trials().recordings(trial().id).value();
        return *m_project->trials().currentObservations(recordings[view].id, trial().robots.front()).value();
    }
    /// Of what a view saw: what is within the left of a line.
    int foundLeftOf(std::size_t view, double x) const
    {
        const std::vector<Observation> all = seriesOf(view).observations;
        return int(std::ranges::count_if(
            all, [x](const Observation &one) { return one.found && one.ellipse.centrePx.x() < x; }));
    }
    static GuidanceEdit leftOfA(double x, Kind kind = Kind::Ignore)
    {
        GuidanceEdit edit;
        edit.added.push_back({kind, "A", {{0, 0}, {x, 0}, {x, 719}, {0, 719}}});
        return edit;
    }
    std::string figures() const
    {
        std::string words;
        const std::vector<AnalysisRecord> current = m_project->analyses().current(trial().id).value();
        for (const AnalysisRecord &analysis : current)
            for (const Metric &metric : analysis.profile.metrics)
                words += metric.name + '=' + std::to_string(metric.value) + ' ';
        return words;
    }
    bool isNew() const { return isGuidanceNew(*m_project, trial()).value(); }

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_project.reset(); }
    void areasAreInputs();
    void aTrackingCanBringThem();
    void theyAreCopiedAndCleared();
    void pointsByHandAreKeptApart();
    void whatIsNotVisibleIsAGap();
    void whatCannotBeMeantIsRefused();
};

void TestGuidedTracking::initTestCase()
{
    SimulatedScene scene = demoTestbed(6);
    scene.durationS = 3;
    scene.robots = {demoRobot("robot", {.colour = demoBlue, .heightM = 0.06},
                              makeFigureEightMotion({1.5, 1.1}, 0.9, 0.6, 6, 0.5))};
    QVERIFY(renderVideo(scene, 0, path("a.mkv"), {}, {}));
    QVERIFY(renderVideo(scene, 1, path("b.mkv"), {}, {}));
    m_project = Project::create(path("class.odo"), "Class").value();
    const RecordId layout = m_project->layouts().add(scene.floor.markers)->id;
    for (const SimulatedCamera &camera : scene.cameras)
        QVERIFY(registerSimulatedCamera(*m_project, camera, scene.floor.markers, layout));
    QVERIFY(addSimulatedRobot(*m_project, scene.robots[0]));
    ImportSettings settings;
    settings.trial = "run";
    settings.videos = {{"A", path("a.mkv")}, {"B", path("b.mkv")}};
    settings.steps = {{SyncBy::Given, 0}};
    QVERIFY(run(ImportTrialJob(settings)));
    QVERIFY(track());
}

void TestGuidedTracking::areasAreInputs()
{
    const std::string before = figures(), algorithm = seriesOf(0).algorithm;
    const int left = foundLeftOf(0, 640);
    QVERIFY(left > 10 && foundLeftOf(0, 1280) > left + 10);
    QVERIFY(!isNew());
    QVERIFY(changeGuidance(*m_project, "run", leftOfA(640)));
    QVERIFY(isNew());
    QCOMPARE(figures(), before); // what was tracked stays
    QVERIFY(track());
    QVERIFY(!isNew());
    QCOMPARE(foundLeftOf(0, 630), 0);
    QVERIFY(foundLeftOf(0, 1280) > 10);
    QVERIFY(foundLeftOf(1, 1280) > 10);
    QCOMPARE(seriesOf(0).algorithm, algorithm + "; ignoring 0.0,0.0 640.0,0.0 640.0,719.0 0.0,719.0");
    QCOMPARE(seriesOf(1).algorithm, algorithm);
    QVERIFY(figures() != before);
    QVERIFY(m_project->undo()); // the tracking
    QCOMPARE(figures(), before);
    QCOMPARE(foundLeftOf(0, 640), left);
    QVERIFY(isNew());
    QVERIFY(m_project->undo()); // the area
    QVERIFY(!isNew());
    QVERIFY(m_project->guidance().of(trial().id)->empty());
    QVERIFY(track());
    QCOMPARE(figures(), before);
    QVERIFY(m_project->undo());
    QVERIFY(m_project->check(true)->empty());
}

void TestGuidedTracking::aTrackingCanBringThem()
{
    const std::string before = figures();
    QVERIFY(track(leftOfA(640, Kind::Search)));
    QVERIFY(foundLeftOf(0, 640) > 10);
    QCOMPARE(foundLeftOf(0, 1280), foundLeftOf(0, 650));
    QCOMPARE(m_project->guidance().of(trial().id)->size(), std::size_t(1));
    QVERIFY(m_project->undo()); // both in one step
    QVERIFY(m_project->guidance().of(trial().id)->empty());
    QCOMPARE(figures(), before);
}

void TestGuidedTracking::theyAreCopiedAndCleared()
{
    QVERIFY(changeGuidance(*m_project, "run", leftOfA(100)));
    const auto copy = copyTrial(*m_project, "run", "copy");
    QVERIFY2(copy, copy ? "" : copy.error().message().c_str());
    const auto own = m_project->guidance().of(trial().id).value(),
               copied = m_project->guidance().of(copy->id).value();
    QCOMPARE(copied.size(), std::size_t(1));
    QVERIFY(copied.front().recording != own.front().recording);
    QVERIFY(copied.front().pointsPx == own.front().pointsPx);
    GuidanceEdit clear;
    clear.clearsAll = true;
    QVERIFY(changeGuidance(*m_project, "run", clear));
    QVERIFY(m_project->guidance().of(trial().id)->empty());
    QCOMPARE(m_project->guidance().of(copy->id)->size(), std::size_t(1));
}

/// A point by hand is in a series of its own; the tracked one stays to the last bit, and is what a further
/// correction starts from.
void TestGuidedTracking::pointsByHandAreKeptApart()
{
    const std::string before = figures();
    const ObservationSeries tracked = seriesOf(0);
    const Observation &there = tracked.observations[40];
    QVERIFY(there.found);
    const Eigen::Vector2d pixel = there.ellipse.centrePx + Eigen::Vector2d(3, 0);
    const double timeS = toSeconds(there.time);
    QVERIFY(again({{Kind::Point, "A", {pixel}, "robot", timeS, timeS, 1.5}}));
    QVERIFY(m_project->check(true)->empty());
    QCOMPARE(m_project->undoWords().english(), std::string("correct run by hand"));
    ObservationSeries corrected = seriesOf(0);
    QCOMPARE(corrected.algorithm, tracked.algorithm + "; by hand 1 points, 0 frames not visible");
    QVERIFY(corrected.observations[40].isByHand);
    QVERIFY(corrected.observations[40].ellipse.centrePx == pixel);
    QCOMPARE(corrected.observations[40].centreCovariancePx2(0, 0), 1.5 * 1.5);
    QVERIFY(!corrected.observations[41].isByHand &&
            corrected.observations[41].ellipse.centrePx == tracked.observations[41].ellipse.centrePx);
    const auto sample = [this](std::int64_t frame) {
        const std::vector<AnalysisRecord> current = m_project->analyses().current(trial().id).value();
        return *std::ranges::find(current.front().profile.samples, frame, &Sample::frame);
    };
    QVERIFY(hasFlag(sample(40).flags, SampleFlag::ByHand) && !isRejected(sample(40).flags));
    QVERIFY(!hasFlag(sample(41).flags, SampleFlag::ByHand));
    // another one, and the same frame once more: both start from what was tracked
    QVERIFY(again({{Kind::Point, "A", {pixel}, "robot", timeS, timeS, 3}}));
    QCOMPARE(m_project->guidance().of(trial().id)->size(), std::size_t(1));
    QVERIFY(track()); // kept when it is tracked anew
    corrected = seriesOf(0);
    QVERIFY(corrected.observations[40].isByHand);
    const auto raw =
        m_project->trials().currentObservations(corrected.recording, corrected.robot, true).value();
    QVERIFY(raw.has_value() && raw->algorithm == tracked.algorithm);
    QVERIFY(raw->observations[40].ellipse.centrePx == there.ellipse.centrePx);
    for (int i = 0; i < 3; ++i)
        QVERIFY(m_project->undo());
    QCOMPARE(figures(), before);
    QCOMPARE(seriesOf(0).algorithm, tracked.algorithm);
    QVERIFY(m_project->check(true)->empty());
}

void TestGuidedTracking::whatIsNotVisibleIsAGap()
{
    const std::string before = figures();
    const auto lost = [this] {
        const std::vector<AnalysisRecord> current = m_project->analyses().current(trial().id).value();
        return std::ranges::count_if(current.front().profile.samples, [](const Sample &sample) {
            return sample.time >= fromSeconds(1) && sample.time <= fromSeconds(1.5) && !sample.position;
        });
    };
    QCOMPARE(lost(), 0);
    QVERIFY(again({{Kind::Hidden, "A", {}, "robot", 1, 1.5}})); // the other view still sees it
    QVERIFY(lost() <= 1);
    QVERIFY(again({{Kind::Hidden, "", {}, "", 1, 1.5}}));
    QVERIFY(lost() >= 14);
    QVERIFY(m_project->undo());
    QVERIFY(m_project->undo());
    QCOMPARE(lost(), 0);
    QCOMPARE(figures(), before);
}

void TestGuidedTracking::whatCannotBeMeantIsRefused()
{
    const auto refusal = [this](const GivenGuidance &given) {
        GuidanceEdit edit;
        edit.added = {given};
        const auto done = changeGuidance(*m_project, "run", edit);
        return done ? QString() : QString::fromStdString(done.error().message());
    };
    QVERIFY(
        refusal({Kind::Ignore, "Z", {{0, 0}, {9, 0}, {9, 9}}}).contains(QStringLiteral("has no such view")));
    QVERIFY(refusal({Kind::Ignore, "A", {{0, 0}, {9, 0}}}).contains(QStringLiteral("at least 3 corners")));
    QVERIFY(refusal({Kind::Ignore, "A", {{0, 0}, {5000, 0}, {9, 9}}})
                .contains(QStringLiteral("a corner is outside the frame")));
    QVERIFY(refusal({Kind::Point, "A", {{9, 9}}, "robot", 900, 900, 1})
                .contains(QStringLiteral("the view has no frame at that time")));
    QVERIFY(refusal({Kind::Point, "A", {{9, 9}}, "robot", 1, 1, 0}).contains(QStringLiteral("σ above 0 px")));
    QVERIFY(refusal({Kind::Point, "A", {{9, 9}}, "nobody", 1, 1, 1}).contains(QStringLiteral("nobody")));
    // a little beyond the edge is the edge
    QCOMPARE(refusal({Kind::Ignore, "A", {{-20, 0}, {9, 0}, {9, 9}}}), QString());
    QCOMPARE(m_project->guidance().of(trial().id)->front().pointsPx.front(), Eigen::Vector2d(0, 0));
}

ODOGRAPH_TEST(TestGuidedTracking, QCoreApplication)
#include "tst_guided_tracking.moc"
