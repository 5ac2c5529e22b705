// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/stored_example.h"
#include "tests/support/said_error.h"

#include "core/project/internal/old_sentences.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/ui/support/example_scene.h"

#include <stdexcept>

namespace odo {
namespace {

const Instant firstDay{std::chrono::milliseconds(1'762'952'400'000)};

/// Within this file a failure is an exception, turned into a Result at its end.
template <class T>
T must(Result<T> result)
{
    if (!result)
        throw std::runtime_error(result.error().message());
    return std::move(*result);
}

void must(const Result<void> &result)
{
    if (!result)
        throw std::runtime_error(result.error().message());
}

struct Stored
{
    Project &project;
    RecordId layout = 0;
    std::vector<RecordId> cameras, registrations, robots;
};

void storeTestbed(Stored &stored, const TrialScene &scene)
{
    Project &project = stored.project;
    stored.layout = must(project.layouts().add(*scene.layout)).id;
    for (const SceneView &view : scene.views) {
        const RecordId camera = must(project.cameras().add({0, view.camera, ""})).id;
        IntrinsicsRecord intrinsics;
        intrinsics.camera = camera;
        intrinsics.made = firstDay;
        intrinsics.origin = fromOldSentence(OldSentences::Origins, "calibrated from 3 pictures");
        intrinsics.calibration.intrinsics = view.floorView->camera().intrinsics();
        intrinsics.calibration.rmsPx = 0.21;
        for (int i = 1; i <= 3; ++i) {
            intrinsics.calibration.images.emplace_back();
            intrinsics.calibration.images.back().view.source = "board_" + std::to_string(i) + ".png";
            intrinsics.calibration.images.back().rmsPx = 0.19 + 0.01 * i;
        }
        intrinsics.calibration.verdict = fromOldSentence(
            OldSentences::Calibrations, "Good: 3 pictures fit to 0.21 px, focal length 480.0 px ± 0.20 %. "
                                        "Standard lens: no other model fits.");
        RegistrationRecord registration;
        registration.camera = camera;
        registration.layout = stored.layout;
        registration.intrinsics = must(project.cameras().addIntrinsics(intrinsics)).id;
        registration.made = firstDay;
        for (const Marker &marker : scene.layout->markers) {
            const Eigen::Vector3d point(marker.pointInWorld.x(), marker.pointInWorld.y(), 0);
            registration.pixels.push_back({marker.label, *view.floorView->pixelFromWorld(point)});
            registration.registration.markers.push_back({marker.label, 0.0016, 0.4});
        }
        registration.registration.worldFromCamera = view.floorView->worldFromCamera();
        registration.registration.poseCovariance = Eigen::Matrix<double, 6, 6>::Identity() * 1e-8;
        registration.registration.rmsPx = 0.4;
        registration.registration.rmsM = 0.0016;
        registration.registration.verdict = fromOldSentence(
            OldSentences::Registrations, "Good: 4 markers fit to 1.6 mm RMS (worst V, 1.6 mm), and the "
                                         "floor among them is known to ±1.6 mm.");
        stored.registrations.push_back(must(project.cameras().addRegistration(registration)).id);
        stored.cameras.push_back(camera);
    }
    for (const SceneRobot &robot : scene.robots)
        stored.robots.push_back(must(project.robots().add(robot.robot)).id);
}

TrialRecord storeTrial(Stored &stored, const TrialScene &scene, TrialRecord trial, std::size_t robotCount)
{
    trial.durationS = toSeconds(scene.frameTimes().back());
    trial.syncMethod = scene.trial.syncMethod;
    trial.syncOffsetSigmaS = scene.trial.syncOffsetSigmaS;
    for (std::size_t robot = 0; robot < robotCount; ++robot)
        trial.robots.push_back(stored.robots.at(robot));
    std::vector<RecordingRecord> recordings;
    for (std::size_t view = 0; view < scene.views.size(); ++view) {
        RecordingRecord recording = scene.views[view].recording;
        recording.camera = stored.cameras.at(view);
        recording.position = static_cast<int>(view);
        recording.path = scene.views[view].file.string();
        recordings.push_back(recording);
    }
    return must(stored.project.trials().add(trial, recordings));
}

void storeResults(Stored &stored, const TrialScene &scene, const TrialRecord &trial)
{
    const auto recordings = must(stored.project.trials().recordings(trial.id));
    for (std::size_t robot = 0; robot < trial.robots.size(); ++robot) {
        for (std::size_t view = 0; view < recordings.size(); ++view)
            must(stored.project.trials().addObservations({recordings[view].id, trial.robots[robot],
                                                          "example 1",
                                                          scene.robots[robot].observations[view]}));
        AnalysisRecord analysis = *scene.robots[robot].analysis;
        analysis.trial = trial.id;
        analysis.robot = trial.robots[robot];
        analysis.made = trial.date;
        analysis.softwareVersion = "0.1";
        analysis.registrations = stored.registrations;
        analysis.views = {"A", "B"};
        must(stored.project.analyses().add(analysis));
    }
}

void storeAll(const std::filesystem::path &folder, const std::filesystem::path &file,
              const StoredExampleOptions &options)
{
    const auto media = folder / "example.media";
    std::filesystem::create_directories(media);
    const auto project = must(Project::create(file, "Year 9 robotics"));
    const TrialScenePtr scene = exampleScene({options.frames, 2, options.widthPx, options.heightPx, media});
    Stored stored{*project, 0, {}, {}, {}};
    storeTestbed(stored, *scene);

    TrialRecord third;
    third.name = "Trial 3";
    third.date = firstDay;
    TrialScene lost = *scene;
    for (SceneView &view : lost.views)
        view.file = media / "lost" / view.file.filename();
    storeTrial(stored, lost, third, 0);

    TrialRecord second;
    second.name = "Trial 2";
    second.team = must(project->teams().add({0, "Heron", "9B"})).id;
    second.task = "Figure eight, both at once";
    second.date = firstDay + std::chrono::hours(24);
    storeResults(stored, *scene, storeTrial(stored, *scene, second, 2));

    TrialRecord first;
    first.name = "Trial 1";
    first.team = must(project->teams().add({0, "Falcon", "9B"})).id;
    first.task = "Figure eight, 2 laps";
    first.notes = "New wheels since trial 2.";
    first.date = firstDay + std::chrono::hours(48);
    storeResults(stored, *scene, storeTrial(stored, *scene, first, 1));
}

} // namespace

Result<std::filesystem::path> storeExample(const std::filesystem::path &folder,
                                           const StoredExampleOptions &options)
{
    const std::filesystem::path file = folder / "example.odo";
    try {
        storeAll(folder, file, options);
    } catch (const std::exception &error) {
        return test::saidFailure(ErrorCode::Internal, "example project", error.what(), "mend the example");
    }
    return file;
}

std::unique_ptr<Project> openStoredExample(const std::filesystem::path &folder,
                                           const StoredExampleOptions &options)
{
    const auto made = storeExample(folder, options);
    if (!made)
        qFatal("%s", made.error().message().c_str());
    auto project = Project::open(*made, Project::Access::ReadWrite);
    if (!project)
        qFatal("%s", project.error().message().c_str());
    return std::move(*project);
}

} // namespace odo
