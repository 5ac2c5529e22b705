// SPDX-License-Identifier: GPL-3.0-or-later
// What hid a robot follows from what a project stores.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/trial_occlusions.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/stored_example.h"
#include "ui/models/trial_scene.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTrialOcclusions : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    /// The robot of Trial 1 as view B did not find it from frame 10 to frame 20.
    static void hideIt(Project &project)
    {
        const TrialRecord trial = project.trials().find("Trial 1").value();
        AnalysisRecord analysis = project.analyses().current(trial.id)->front();
        const RecordingRecord recording = project.trials().recordings(trial.id)->at(1);
        ObservationSeries series =
            project.trials().currentObservations(recording.id, analysis.robot)->value();
        for (std::size_t frame = 10; frame <= 20; ++frame) {
            series.observations[frame].found = false;
            analysis.profile.samples[frame].views = 1;
        }
        QVERIFY(project.trials().addObservations(series));
        QVERIFY(project.analyses().add(analysis));
    }

private Q_SLOTS:
    void theyFollowFromWhatIsStored()
    {
        const auto project = openStoredExample(m_folder.path().toStdString());
        const RecordId trial = project->trials().find("Trial 1").value().id;
        const auto found = [&] {
            return trialOcclusions(*project, trial, project->analyses().current(trial).value()).value();
        };
        QCOMPARE(found().size(), std::size_t(1));
        QCOMPARE(found().front().size(), std::size_t(0));
        hideIt(*project);
        QCOMPARE(found().front().size(), std::size_t(1));
        QCOMPARE(occlusionSentence(found().front().front()).english(),
                 std::string("not visible in view B (0.33 s to 0.67 s)"));

        const auto scene = loadTrialScene(*project, "Trial 1");
        QVERIFY(scene.has_value());
        const std::vector<Occlusion> &shown = (*scene)->robots.front().occlusions;
        QCOMPARE(shown.size(), std::size_t(1));
        QCOMPARE(occlusionSentence(shown.front()), occlusionSentence(found().front().front()));
    }

    void passingRobotsAreNoSpikes()
    {
        const TrialScenePtr scene = exampleScene({.frames = 40, .robots = 2});
        constexpr std::size_t frame = 15;
        const auto left = [&](SampleFlags flags, double asideM, bool isBlueTracked = true) {
            std::vector<RegisteredView> views;
            std::vector<TrackedView> tracked;
            for (std::size_t v = 0; v < scene->views.size(); ++v) {
                views.push_back({scene->views[v].recording, {}, {}, scene->views[v].floorView});
                TrackedView &view = tracked.emplace_back();
                for (const SceneRobot &robot : scene->robots) {
                    view.series.push_back({0, 0, {}, robot.observations[v]});
                    for (Observation &one : view.series.back().observations)
                        one.areaPx = 500;
                }
            }
            AnalysisRecord red = *scene->robots[0].analysis, blue = *scene->robots[1].analysis;
            red.robotName = "Red 2", blue.robotName = "Blue 1";
            for (std::size_t i = 0; i < blue.profile.points.size(); ++i)
                blue.profile.points[i].position = red.profile.points[i].position + Eigen::Vector2d(asideM, 0);
            for (std::size_t i = frame - 5; i <= frame + 5; ++i) {
                tracked[1].series[0].observations[i].found = false;
                red.profile.samples[i].views = 1;
            }
            red.profile.samples[frame].flags = flags;
            red.profile.spikes = {{std::int64_t(frame), red.profile.samples[frame].time, flags,
                                   foreignWords("the tracker was not sure (score 10 %)")}};
            const StoredRobot other{blue,
                                    {tracked[0].series[1].observations, tracked[1].series[1].observations}};
            const auto all = isBlueTracked ? trackedOcclusions(views, tracked, {&red, &blue})
                                           : trackedOcclusions(views, tracked, {&red}, {other});
            removeSpikesOfPassing(all.front(), red.profile.spikes);
            return red.profile.spikes.size();
        };
        QCOMPARE(left(flagBit(SampleFlag::LowScore), 0.05), std::size_t(0));
        QCOMPARE(left(flagBit(SampleFlag::LowScore), 0.05, false), std::size_t(0));
        QCOMPARE(left(flagBit(SampleFlag::LowScore) | flagBit(SampleFlag::Interpolated), 0.05),
                 std::size_t(0));
        QCOMPARE(left(flagBit(SampleFlag::LowScore), 1.5), std::size_t(1)); // too far away to be the cause
        QCOMPARE(left(flagBit(SampleFlag::LowScore) | flagBit(SampleFlag::Jump), 0.05), std::size_t(1));
    }

    void theOthersAreThoseThatAreNotTrackedNow()
    {
        const auto project = openStoredExample(m_folder.filePath(QStringLiteral("two")).toStdString());
        const TrialRecord trial = project->trials().find("Trial 2").value();
        const auto views = registeredViews(*project, trial).value();
        const RobotRecord red = project->robots().find("Red 2").value(),
                          blue = project->robots().find("Blue 1").value();
        const auto others = otherRobots(*project, trial.id, views, {red}).value();
        QCOMPARE(others.size(), std::size_t(1));
        QCOMPARE(others.front().analysis.robotName, std::string("Blue 1"));
        QCOMPARE(others.front().observations.size(), std::size_t(2));
        QCOMPARE(others.front().observations[1].size(), std::size_t(30));
        QCOMPARE(otherRobots(*project, trial.id, views, {red, blue}).value().size(), std::size_t(0));
    }

    void aTrialThatWasNotTrackedHasNone()
    {
        const auto project = openStoredExample(m_folder.filePath(QStringLiteral("other")).toStdString());
        const RecordId trial = project->trials().find("Trial 3").value().id;
        QCOMPARE(trialOcclusions(*project, trial, {}).value().size(), std::size_t(0));
        QCOMPARE((*loadTrialScene(*project, "Trial 3"))->robots.size(), std::size_t(0));
    }
};

ODOGRAPH_TEST(TestTrialOcclusions, QCoreApplication)
#include "tst_trial_occlusions.moc"
