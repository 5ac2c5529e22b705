// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/camera_lists.h"
#include "ui/models/trial_model.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTrialScene : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    TrialScenePtr m_example;

    /// Stores a view's camera with its registration; gives the recording to be added.
    RecordingRecord storeView(const SceneView &view, RecordId layout, RecordId &registration)
    {
        const RecordId camera = m_project->cameras().add({0, view.camera, {}}).value().id;
        IntrinsicsRecord intrinsics;
        intrinsics.camera = camera;
        intrinsics.origin = foreignWords("imported from A.yaml");
        intrinsics.calibration.intrinsics = view.floorView->camera().intrinsics();
        intrinsics = m_project->cameras().addIntrinsics(intrinsics).value();
        RegistrationRecord record;
        record.camera = camera;
        record.layout = layout;
        record.intrinsics = intrinsics.id;
        record.registration = *view.registration;
        record.registration.poseCovariance.setZero();
        registration = m_project->cameras().addRegistration(record).value().id;
        // A newer one must not replace the one that the analysis used.
        record.registration.worldFromCamera.translation.z() += 1;
        m_project->cameras().addRegistration(record).value();
        RecordingRecord recording = view.recording;
        recording.camera = camera;
        recording.path = "Trial.media/" + view.camera + ".mkv";
        return recording;
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_example = exampleScene({.frames = 30});
        auto created =
            Project::create(std::filesystem::path(m_folder.path().toStdString()) / "Trial.odo", "Test");
        QVERIFY2(created.has_value(), created ? "" : created.error().message().c_str());
        m_project = std::move(*created);
        const RecordId layout = m_project->layouts().add(*m_example->layout).value().id;
        RobotRecord robot = m_example->robots[0].robot;
        robot = m_project->robots().add(robot).value();
        AnalysisRecord analysis = *m_example->robots[0].analysis;
        std::vector<RecordingRecord> recordings;
        for (const SceneView &view : m_example->views) {
            RecordId registration = 0;
            recordings.push_back(storeView(view, layout, registration));
            analysis.registrations.push_back(registration);
            analysis.views.push_back(view.camera);
        }
        TrialRecord trial;
        trial.name = "Trial 3";
        trial.robots = {robot.id};
        Task task;
        task.gates = {{"far", GateRole::Split, {4, 4}, {4, 4.5}}};
        task.path.points = {{0, 0}, {1, 1}};
        QVERIFY(m_project->tasks().add({0, "line", task}).has_value());
        trial.task = "line";
        trial = m_project->trials().add(trial, recordings).value();
        recordings = m_project->trials().recordings(trial.id).value();
        for (std::size_t view = 0; view < recordings.size(); ++view) {
            const ObservationSeries series{recordings[view].id, robot.id, "test",
                                           m_example->robots[0].observations[view]};
            QVERIFY(m_project->trials().addObservations(series).has_value());
        }
        analysis.trial = trial.id;
        analysis.robot = robot.id;
        QVERIFY(m_project->analyses().add(analysis).has_value());
    }
    void loadsAllThatReviewShows()
    {
        const auto scene = loadTrialScene(*m_project, "Trial 3");
        QVERIFY2(scene.has_value(), scene ? "" : scene.error().message().c_str());
        const TrialScene &got = **scene;
        QCOMPARE(got.views.size(), std::size_t(2));
        QCOMPARE(got.views[1].camera, std::string("B"));
        QVERIFY(got.views[0].file.is_absolute());
        QCOMPARE(got.frameTimes(), m_example->frameTimes());
        QCOMPARE(got.layout->markers.size(), std::size_t(4));
        QCOMPARE(got.robots.size(), std::size_t(1));
        QCOMPARE(got.robots[0].analysis->profile.points.size(), std::size_t(30));
        QVERIFY(got.observationAt(1, 0, 12));
        QCOMPARE(got.task->gates.size(), std::size_t(1));
        QVERIFY(got.floorBounds().contains(Eigen::Vector2d(4, 4.5))); // the whole task is to be seen
        // The same point of the floor lies at the same pixel, so the registration is the one that was used.
        const auto expected = m_example->views[0].floorView->pixelFromWorld({1, 1, 0});
        const auto pixel = got.views[0].floorView->pixelFromWorld({1, 1, 0});
        QVERIFY((*expected - *pixel).norm() < 1e-6);
    }
    void anImportedTrackIsOfTheCentre()
    {
        TrialScene scene;
        scene.robots.resize(1);
        QVERIFY(scene.referenceM(0).isZero());
        scene.robots.front().robot.referenceM = {0.1, -0.02};
        QVERIFY(scene.referenceM(0) == Eigen::Vector2d(0.1, -0.02));
        scene.imported.resize(1);
        QVERIFY(scene.referenceM(0).isZero()); // another program's point, which nobody knows
    }
    void anUnknownTrialIsTold()
    {
        const auto scene = loadTrialScene(*m_project, "Trial 4");
        QVERIFY(!scene.has_value());
        QCOMPARE(scene.error().code, ErrorCode::NotFound);
    }
    void loadsTheLists()
    {
        TrialRows reading(*m_project);
        const auto trials = reading.next(100);
        QVERIFY(trials.has_value());
        QCOMPARE(trials->size(), std::size_t(1));
        QVERIFY(reading.next(100)->empty());
        const auto cameras = loadCameraRows(*m_project);
        QVERIFY(cameras.has_value());
        QCOMPARE(cameras->size(), std::size_t(2));
        QVERIFY(cameras->front().intrinsics && cameras->front().registration);
    }
};

ODOGRAPH_TEST(TestTrialScene, QApplication)
#include "tst_trial_scene.moc"
