// SPDX-License-Identifier: GPL-3.0-or-later
// Clips that were imported before the project knew a robot or the floor are synchronised afterwards: by
// tracking itself, or when a person asks for it.
#include "core/workflow/track/synchronise_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

class TestSynchroniseJob : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    SimulatedScene m_scene;
    std::unique_ptr<Project> m_project;
    double m_offsetS = 0;

    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    void import(const char *trial, ViewStep step, std::vector<std::pair<std::string, const char *>> views)
    {
        ImportSettings settings;
        settings.trial = trial;
        for (const auto &[camera, file] : views)
            settings.videos.emplace_back(camera, path(file));
        settings.steps = {step};
        ImportTrialJob job(settings);
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
    }
    Result<TrackOutcome> track(const char *trial)
    {
        TrackJob job(trial, {});
        if (const auto done = runToEnd(job, *m_project, {}); !done)
            return tl::unexpected(done.error());
        return job.outcome();
    }
    Result<std::vector<Message>> synchronise(const char *trial, std::vector<ViewStep> steps)
    {
        SynchroniseJob job(trial, std::move(steps));
        if (const auto done = runToEnd(job, *m_project, {}); !done)
            return tl::unexpected(done.error());
        return job.warnings();
    }
    RecordingRecord secondView(const char *trial)
    {
        return m_project->trials().recordings(m_project->trials().find(trial)->id).value().at(1);
    }
    double disagreementM(const char *trial)
    {
        const RecordId id = m_project->trials().find(trial)->id;
        return m_project->analyses().current(id).value().front().profile.meanViewDisagreementM;
    }
    RecordId analysis(const char *trial)
    {
        return m_project->analyses().current(m_project->trials().find(trial)->id).value().front().id;
    }
    void isFoundByMotion(const char *trial)
    {
        const RecordingRecord view = secondView(trial);
        QCOMPARE(view.syncMethod, std::string("auto"));
        const double error = view.startOffsetS - m_offsetS;
        QVERIFY2(view.startOffsetSigmaS < 0.01 && std::abs(error) < 3 * view.startOffsetSigmaS,
                 qPrintable(QStringLiteral("%1 +- %2").arg(error).arg(view.startOffsetSigmaS)));
        const TrialRecord record = m_project->trials().find(trial).value();
        QCOMPARE(record.syncMethod, view.syncMethod);
        QCOMPARE(record.syncOffsetS, view.startOffsetS);
        QVERIFY(record.syncScore > 0.5);
    }

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_project.reset(); }
    void whatIsNotFoundChangesNothing();
    void trackingSeeksWhatIsOpen();
    void whatAPersonAskedForStays();
    void aTrackedTrialIsAnalysedByTheNewClocks();
    void refusesWhatHasNoTwoViews();
};

void TestSynchroniseJob::initTestCase()
{
    m_scene = demoTestbed(5);
    m_scene.durationS = 4;
    m_scene.cameras[1].startOffsetS = 0.2137;
    m_scene.robots = {demoRobot("robot", {.colour = demoBlue, .heightM = 0.06},
                                makeFigureEightMotion({1.5, 1.1}, 0.9, 0.6, 6, 0.5))};
    m_offsetS = frameSceneTime(m_scene, 1, 0) - frameSceneTime(m_scene, 0, 0);
    QVERIFY(renderVideo(m_scene, 0, path("a.mkv"), {}, {}));
    QVERIFY(renderVideo(m_scene, 1, path("b.mkv"), {}, {}));
    m_project = Project::create(path("class.odo"), "Class").value();
    // nothing is known of the floor and the robot
    import("open", {SyncBy::Automatic}, {{"A", "a.mkv"}, { "B", "b.mkv" }});
    import("none", {SyncBy::None}, {{"A", "a.mkv"}, { "B", "b.mkv" }});
    import("alone", {SyncBy::Automatic}, {{ "A", "a.mkv" }});
    QCOMPARE(secondView("open").syncMethod, std::string("open"));
    QCOMPARE(publishedSyncMethod(secondView("open").syncMethod), std::string("none"));
    QCOMPARE(secondView("none").syncMethod, std::string("none"));
}

void TestSynchroniseJob::whatIsNotFoundChangesNothing()
{
    // no robot, no floor, no sound, no flash
    const auto before = secondView("open");
    const auto failed = synchronise("open", {});
    QVERIFY(!failed);
    QCOMPARE(failed.error().message(),
             std::string("synchronisation of view 'B': camera 'A' is not registered to the floor, neither "
                         "view shows a flash of light, and view 'A' has no sound; flash the room lights or "
                         "clap twice while both cameras record, or give --sync SECONDS"));
    QCOMPARE(secondView("open").syncMethod, before.syncMethod);
    const auto apart = synchronise("open", {{SyncBy::Given, 100}});
    QVERIFY(!apart);
    QVERIFY2(apart.error().message().find("views 'A' and 'B' do not overlap") != std::string::npos,
             apart.error().message().c_str());
    QCOMPARE(secondView("open").syncMethod, std::string("open"));
}

void TestSynchroniseJob::trackingSeeksWhatIsOpen()
{
    const RecordId layout = m_project->layouts().add(m_scene.floor.markers)->id;
    for (const SimulatedCamera &camera : m_scene.cameras)
        QVERIFY(registerSimulatedCamera(*m_project, camera, m_scene.floor.markers, layout));
    QVERIFY(addSimulatedRobot(*m_project, m_scene.robots[0]));
    const auto tracked = track("open");
    QVERIFY2(tracked, tracked ? "" : tracked.error().message().c_str());
    isFoundByMotion("open");
    QVERIFY2(disagreementM("open") < 0.005, qPrintable(QString::number(disagreementM("open"))));
    for (const Message &warning : tracked->warnings)
        QVERIFY2(warning.english().find("not synchronised") == std::string::npos, warning.english().c_str());
}

void TestSynchroniseJob::whatAPersonAskedForStays()
{
    const auto tracked = track("none");
    QVERIFY2(tracked, tracked ? "" : tracked.error().message().c_str());
    QCOMPARE(secondView("none").syncMethod, std::string("none"));
    QVERIFY(std::ranges::any_of(tracked->warnings, [](const Message &warning) {
        return warning.english() ==
               "view 'B' in trial 'none': it is not synchronised: the same start time as the first view was "
               "assumed, and positions of a moving robot are wrong; synchronise it again with odograph trial "
               "set --sync auto, or enter the time offset";
    }));
}

/// Nothing is decoded for what was tracked; Undo brings back clocks and figures.
void TestSynchroniseJob::aTrackedTrialIsAnalysedByTheNewClocks()
{
    const double before = disagreementM("none");
    const RecordId first = analysis("none");
    const auto found = synchronise("none", {});
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    isFoundByMotion("none");
    QVERIFY(analysis("none") != first);
    QVERIFY2(before > 0.03 && disagreementM("none") < 0.005,
             qPrintable(QStringLiteral("%1 %2").arg(before).arg(disagreementM("none"))));
    const std::string words = m_project->changes()->front().words.english();
    QVERIFY2(words.starts_with("synchronise none: B 0.21") && words.ends_with("(before: B not synchronised)"),
             words.c_str());
    QVERIFY(m_project->undo());
    QCOMPARE(secondView("none").syncMethod, std::string("none"));
    QCOMPARE(secondView("none").startOffsetS, 0.0);
    QCOMPARE(analysis("none"), first);
    QCOMPARE(disagreementM("none"), before);

    const auto typed = synchronise("none", {{SyncBy::Given, m_offsetS}});
    QVERIFY2(typed, typed ? "" : typed.error().message().c_str());
    QCOMPARE(secondView("none").syncMethod, std::string("told"));
    QCOMPARE(secondView("none").startOffsetS, m_offsetS);
    QVERIFY(disagreementM("none") < 0.005);
}

void TestSynchroniseJob::refusesWhatHasNoTwoViews()
{
    QCOMPARE(synchronise("alone", {}).error().message(),
             std::string("trial 'alone': it does not have two views; choose a trial of two views or more"));
    QCOMPARE(int(synchronise("nobody", {}).error().code), int(ErrorCode::NotFound));
    QVERIFY2(synchronise("open", {{SyncBy::Given, 1}, {SyncBy::None}})
                     .error()
                     .message()
                     .find("the number of views is 2, the number of offsets 2") != std::string::npos,
             synchronise("open", {{SyncBy::Given, 1}, {SyncBy::None}}).error().message().c_str());
}

ODOGRAPH_TEST(TestSynchroniseJob, QCoreApplication)
#include "tst_synchronise_job.moc"
