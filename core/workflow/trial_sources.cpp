// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trial_sources.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/sensor_format.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/guidance.h"

namespace odo {

ViewClock clockOf(const RecordingRecord &recording)
{
    return {fromSeconds(recording.startOffsetS), recording.clockRate};
}

std::filesystem::path imageFileOf(const Project &project, const StoredImage &image)
{
    return image.path.empty() ? std::filesystem::path() : absolutePath(project.file(), image.path);
}

KnownRecording knownRecording(const RecordingRecord &recording)
{
    return {recording.frameTimes.size(), std::max(recording.orientation, 1), recording.widthPx,
            recording.heightPx};
}

namespace {

/// That a registration was made with.
Result<Intrinsics> lensOf(Project &project, const RegistrationRecord &registration)
{
    if (registration.intrinsics == 0)
        return registration.assumedIntrinsics;
    auto stored = ODO_TRY(project.cameras().intrinsics(registration.intrinsics));
    return std::move(stored.calibration.intrinsics);
}

} // namespace

Message registerInItsVideo()
{
    return ODO_TEXT(
        "workflow.register_in_its_video",
        "register the camera in a frame of this video, to which its lens calibration is then fitted");
}

Result<FloorView> floorViewOf(Project &project, const RegistrationRecord &registration)
{
    auto lens = ODO_TRY(lensOf(project, registration));
    const auto camera = ODO_TRY(CameraModel::create(std::move(lens)));
    return floorViewOf(registration.registration, camera, registration.pixels);
}

Result<std::optional<FloorView>> floorViewAt(const RegistrationRecord &registration, const Intrinsics &lens,
                                             int widthPx, int heightPx)
{
    const auto format = determinedFormat(lens.widthPx, lens.heightPx, widthPx, heightPx);
    if (!format)
        return std::nullopt;
    const auto camera = ODO_TRY(CameraModel::create(inFormat(lens, *format)));
    std::vector<MarkerPixel> pixels = registration.pixels;
    for (MarkerPixel &marker : pixels)
        marker.pixel = inFormat(marker.pixel, lens.widthPx, lens.heightPx, *format);
    return floorViewOf(registration.registration, camera, pixels);
}

Result<std::optional<FloorView>> floorViewAt(Project &project, const RegistrationRecord &registration,
                                             const RecordingRecord &recording)
{
    const Intrinsics lens = ODO_TRY(lensOf(project, registration));
    return floorViewAt(registration, lens, recording.widthPx, recording.heightPx);
}

Error registeredAtOtherSize(const std::string &trialName, const RecordingRecord &recording,
                            const Intrinsics &lens)
{
    return {
        ErrorCode::InvalidInput, viewInTrialSubject(recording.cameraName, trialName),
        ODO_TEXT("workflow.another_picture_size", "its frames are %1, but the camera was registered at %2")(
            sizeText(recording.widthPx, recording.heightPx), sizeText(lens.widthPx, lens.heightPx)),
        registerInItsVideo()};
}

std::vector<Message> convertedViewWarnings(const std::string &trialName,
                                           const std::vector<RegisteredView> &views)
{
    std::vector<Message> sentences;
    for (const RegisteredView &view : views) {
        if (!view.convertedFromPx)
            continue;
        const auto &[widthPx, heightPx] = *view.convertedFromPx;
        sentences.push_back(wholeMessage(
            viewInTrialSubject(view.recording.cameraName, trialName),
            ODO_TEXT("workflow.registration_converted",
                     "its frames are %1, so the camera's registration at %2 was converted")(
                sizeText(view.recording.widthPx, view.recording.heightPx), sizeText(widthPx, heightPx)),
            ODO_TEXT(
                "workflow.register_if_other_part",
                "if the camera shows another part of the scene at that size, register it again in a frame "
                "of this video")));
    }
    return sentences;
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
    const auto guidance = ODO_TRY(project.guidance().of(trial.id));
    const auto marks = ODO_TRY(project.trials().pointedOut(trial.id));
    std::vector<RegisteredView> views;
    for (RecordingRecord &recording : recordings) {
        RegisteredView view;
        view.file = project.resolve(recording);
        view.area = searchedAreaOf(guidance, recording.id);
        view.marks = marksOf(marks, recording.id);
        auto registration = ODO_TRY(project.cameras().currentRegistration(recording.camera));
        if (registration) {
            const Intrinsics lens = ODO_TRY(lensOf(project, *registration));
            auto floorView = ODO_TRY(floorViewAt(*registration, lens, recording.widthPx, recording.heightPx));
            if (!floorView)
                return tl::unexpected(registeredAtOtherSize(trial.name, recording, lens));
            if (lens.widthPx != recording.widthPx || lens.heightPx != recording.heightPx)
                view.convertedFromPx = {lens.widthPx, lens.heightPx};
            view.floorView = std::move(floorView);
            view.registrationImage = imageFileOf(project, registration->image);
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
