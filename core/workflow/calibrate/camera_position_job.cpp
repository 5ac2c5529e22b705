// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/camera_position_job.h"

#include "core/base/error.h"
#include "core/capture/camera_source.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <cmath>

namespace odo {

namespace {

RegistrationCheck::Outcome outcomeOf(CameraPositionCheck::Verdict verdict)
{
    switch (verdict) {
    case CameraPositionCheck::Verdict::CameraMoved:
        return RegistrationCheck::Outcome::CameraMoved;
    case CameraPositionCheck::Verdict::MarkersMoved:
        return RegistrationCheck::Outcome::MarkersMoved;
    case CameraPositionCheck::Verdict::Still:
        break;
    }
    return RegistrationCheck::Outcome::Still;
}

Message checkWords(const std::string &camera)
{
    return ODO_TEXT("workflow.check_whether_moved",
                    "check whether camera %1 has moved")(Named::camera(camera));
}

} // namespace

CameraPositionJob::CameraPositionJob(CameraPositionSettings settings) : m_settings(std::move(settings)) {}

Result<void> CameraPositionJob::prepare(Project &project)
{
    const auto registered = ODO_TRY(registeredCamera(project, m_settings.camera));
    const RegistrationRecord &record = registered.registration;
    auto view = ODO_TRY(floorViewOf(project, record));
    auto layout = ODO_TRY(project.layouts().get(record.layout));
    m_registration = record.id;
    m_view = std::move(view);
    m_layout = std::move(layout.layout);
    m_stored = record.pixels;
    // Of one coordinate; the RMS of a registration is that of the whole distance.
    m_fitPx = record.registration.rmsPx / std::sqrt(2.0);
    return {};
}

Result<Frame> CameraPositionJob::image(const JobControl &control) const
{
    if (!m_settings.liveUri.empty()) {
        auto camera = ODO_TRY(openCamera(m_settings.liveUri));
        return settledFrame(*camera, control);
    }
    std::optional<Frame> first;
    const auto visited = visitImages(
        m_settings.imageFile, 1,
        [&](const Frame &frame, const std::string &) {
            first = frame;
            return false;
        },
        control.cancel);
    if (!visited)
        return tl::unexpected(visited.error());
    if (!first)
        return fail(ErrorCode::Undetermined, fileSubject(m_settings.imageFile),
                    ODO_TEXT("workflow.file_without_picture", "it contains no image"), giveAnotherFile());
    return *first;
}

Result<void> CameraPositionJob::run(const JobControl &control)
{
    control.report(0, ODO_TEXT("workflow.looking_for_markers_again", "detecting the markers again"));
    const auto frame = ODO_TRY(image(control));
    const Message camera = cameraSubject(m_settings.camera);
    const Intrinsics &lens = m_view->camera().intrinsics();
    if (frame.y.width != lens.widthPx || frame.y.height != lens.heightPx)
        return fail(ErrorCode::InvalidInput, cameraMovement(camera),
                    ODO_TEXT("workflow.registered_at_another_size",
                             "the image is %1, the camera was registered at %2")(
                        sizeText(frame.y.width, frame.y.height), sizeText(lens.widthPx, lens.heightPx)),
                    ODO_TEXT("workflow.give_picture_of_that_size", "give an image of that size"));
    auto check =
        ODO_TRY(checkCameraPosition(m_settings.camera, *m_view, m_stored,
                                    findAgain(frame, m_layout, m_stored, m_view->camera()), m_fitPx));
    if (control.isCancelled())
        return cancelled(camera);
    m_check = std::move(check);
    return {};
}

Result<void> CameraPositionJob::commit(Project &project)
{
    return project.note(checkWords(m_settings.camera), [&] {
        return project.cameras().addCheck(m_registration, {instantNow(), outcomeOf(m_check.verdict),
                                                           m_check.shiftPx, m_check.shiftM, m_check.words});
    });
}

Result<void> keepUndetermined(Project &project, const std::string &camera, const Error &error)
{
    const auto registered = ODO_TRY(registeredCamera(project, camera));
    return project.note(checkWords(camera), [&] {
        return project.cameras().addCheck(
            registered.registration.id,
            {instantNow(), RegistrationCheck::Outcome::Undetermined, 0, 0, wholeMessage(error)});
    });
}

} // namespace odo
