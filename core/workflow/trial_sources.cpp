// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trial_sources.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
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
        auto stored = ODO_TRY(project.cameras().intrinsics(registration.intrinsics));
        intrinsics = stored.calibration.intrinsics;
    }
    auto camera = ODO_TRY(CameraModel::create(std::move(intrinsics)));
    return floorViewOf(registration.registration, camera, registration.pixels);
}

Result<std::optional<FloorView>> floorViewInForce(Project &project, RecordId camera)
{
    const auto registration = ODO_TRY(project.cameras().currentRegistration(camera));
    if (!registration)
        return std::nullopt;
    return ODO_TRY(floorViewOf(project, *registration));
}

Result<std::vector<RegisteredView>> registeredViews(Project &project, const TrialRecord &trial)
{
    auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    std::vector<RegisteredView> views;
    for (RecordingRecord &recording : recordings) {
        RegisteredView view;
        view.file = project.resolve(recording);
        auto registration = ODO_TRY(project.cameras().currentRegistration(recording.camera));
        if (registration) {
            auto floorView = ODO_TRY(floorViewOf(project, *registration));
            const Intrinsics &lens = floorView.camera().intrinsics();
            if (lens.widthPx != recording.widthPx || lens.heightPx != recording.heightPx)
                return fail(ErrorCode::InvalidInput,
                            ODO_TEXT("workflow.view_of_trial", "view '%1' of trial '%2'")(
                                Named::camera(recording.cameraName), Named::trial(trial.name)),
                            ODO_TEXT("workflow.another_picture_size",
                                     "its frames are %1 but the camera was calibrated at %2")(
                                sizeText(recording.widthPx, recording.heightPx),
                                sizeText(lens.widthPx, lens.heightPx)),
                            ODO_TEXT("workflow.calibrate_at_recorded_size",
                                     "calibrate and register the camera at the size it records"));
            view.floorView = std::move(floorView);
            view.registration = std::move(*registration);
        }
        view.recording = std::move(recording);
        views.push_back(std::move(view));
    }
    return views;
}

namespace {

tl::unexpected<Error> isAnotherFile(const RegisteredView &view, const Message &how)
{
    return fail(ErrorCode::InvalidInput,
                ODO_TEXT("workflow.recording_of_view",
                         "recording of view '%1'")(Named::camera(view.recording.cameraName)),
                how,
                ODO_TEXT("workflow.put_original_or_import",
                         "restore the original file, or import this one as another trial"));
}

} // namespace

Result<void> checkRecordings(const std::vector<RegisteredView> &views, const JobControl &control)
{
    for (const RegisteredView &view : views) {
        std::error_code error;
        const auto bytes = static_cast<std::int64_t>(files::sizeOf(view.file, error));
        if (error || view.recording.bytes == 0) // it is missing, or its size was never noted
            continue;
        if (bytes != view.recording.bytes)
            return isAnotherFile(view, ODO_TEXT("workflow.file_of_another_size",
                                                "its file has %1 bytes, but had %2 when it was added")(
                                           bytes, view.recording.bytes));
        if (view.recording.sha256.empty())
            continue;
        if (ODO_TRY(fileSha256(view.file, control)) != view.recording.sha256)
            return isAnotherFile(
                view, ODO_TEXT("workflow.file_of_other_content", "its file has changed since it was added"));
    }
    return {};
}

Result<std::vector<RobotRecord>> robotsToTrack(Project &project, const TrialRecord &trial,
                                               const std::vector<std::string> &names)
{
    std::vector<RobotRecord> robots;
    for (const std::string &name : names) {
        robots.push_back(ODO_TRY(project.robots().find(name)));
    }
    if (!names.empty())
        return robots;
    for (const RecordId id : trial.robots) {
        robots.push_back(ODO_TRY(project.robots().get(id)));
    }
    if (!robots.empty())
        return robots;
    auto all = project.robots().all();
    if (all && all->empty())
        return fail(
            ErrorCode::NotFound, trialSubject(trial.name), noRobotToTrack(),
            ODO_TEXT("workflow.add_robot", "add one with: odograph robot add PROJECT NAME --colour #rrggbb"));
    return all;
}

Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial)
{
    std::vector<ImportedTrack> tracks;
    for (const RecordId robot : trial.robots) {
        auto track = ODO_TRY(project.trials().currentImportedTrack(trial.id, robot, false));
        if (track)
            tracks.push_back(std::move(*track));
    }
    return tracks;
}

} // namespace odo
