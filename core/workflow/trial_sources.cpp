// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trial_sources.h"

#include "core/base/subjects.h"
#include "core/calibration/lens_influence.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

namespace odo {

ViewClock clockOf(const RecordingRecord &recording)
{
    return {fromSeconds(recording.startOffsetS), recording.clockRate};
}

Result<FloorView> floorViewOf(Project &project, const RegistrationRecord &registration)
{
    Intrinsics intrinsics = registration.assumedIntrinsics;
    if (registration.intrinsics != 0) {
        auto stored = project.cameras().intrinsics(registration.intrinsics);
        if (!stored)
            return tl::unexpected(stored.error());
        intrinsics = stored->calibration.intrinsics;
    }
    auto camera = CameraModel::create(std::move(intrinsics));
    if (!camera)
        return tl::unexpected(camera.error());
    return floorViewOf(registration.registration, *camera, registration.pixels);
}

Result<std::optional<FloorView>> floorViewInForce(Project &project, RecordId camera)
{
    const auto registration = project.cameras().currentRegistration(camera);
    if (!registration)
        return tl::unexpected(registration.error());
    if (!*registration)
        return std::nullopt;
    auto floorView = floorViewOf(project, **registration);
    if (!floorView)
        return tl::unexpected(floorView.error());
    return std::move(*floorView);
}

Result<std::vector<RegisteredView>> registeredViews(Project &project, const TrialRecord &trial)
{
    auto recordings = project.trials().recordings(trial.id);
    if (!recordings)
        return tl::unexpected(recordings.error());
    std::vector<RegisteredView> views;
    for (RecordingRecord &recording : *recordings) {
        RegisteredView view;
        view.file = project.resolve(recording);
        auto registration = project.cameras().currentRegistration(recording.camera);
        if (!registration)
            return tl::unexpected(registration.error());
        if (*registration) {
            auto floorView = floorViewOf(project, **registration);
            if (!floorView)
                return tl::unexpected(floorView.error());
            const Intrinsics &lens = floorView->camera().intrinsics();
            if (lens.widthPx != recording.widthPx || lens.heightPx != recording.heightPx)
                return fail(ErrorCode::InvalidInput,
                            ODO_TEXT("workflow.view_of_trial", "view '%1' of trial '%2'")(
                                Named::camera(recording.cameraName), Named::trial(trial.name)),
                            ODO_TEXT("workflow.another_picture_size",
                                     "its pictures are %1 but the camera was calibrated at %2")(
                                sizeText(recording.widthPx, recording.heightPx),
                                sizeText(lens.widthPx, lens.heightPx)),
                            ODO_TEXT("workflow.calibrate_at_recorded_size",
                                     "calibrate and register the camera at the size it records"));
            view.floorView = std::move(*floorView);
            view.registration = std::move(**registration);
        }
        view.recording = std::move(recording);
        views.push_back(std::move(view));
    }
    return views;
}

Result<std::vector<RobotRecord>> robotsToTrack(Project &project, const TrialRecord &trial,
                                               const std::vector<std::string> &names)
{
    std::vector<RobotRecord> robots;
    for (const std::string &name : names) {
        auto robot = project.robots().find(name);
        if (!robot)
            return tl::unexpected(robot.error());
        robots.push_back(std::move(*robot));
    }
    if (!names.empty())
        return robots;
    for (const RecordId id : trial.robots) {
        auto robot = project.robots().get(id);
        if (!robot)
            return tl::unexpected(robot.error());
        robots.push_back(std::move(*robot));
    }
    if (!robots.empty())
        return robots;
    auto all = project.robots().all();
    if (all && all->empty())
        return fail(ErrorCode::NotFound, trialSubject(trial.name), noRobotToLookFor(),
                    joined({ODO_TEXT("workflow.add_one_with", "add one with"),
                            nameAlone(std::string("odograph robot add PROJECT NAME --colour #rrggbb"))},
                           Join::Colon));
    return all;
}

Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial)
{
    std::vector<ImportedTrack> tracks;
    for (const RecordId robot : trial.robots) {
        auto track = project.trials().currentImportedTrack(trial.id, robot, false);
        if (!track)
            return tl::unexpected(track.error());
        if (*track)
            tracks.push_back(std::move(**track));
    }
    return tracks;
}

} // namespace odo
