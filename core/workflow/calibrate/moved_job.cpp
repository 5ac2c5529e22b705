// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/moved_job.h"

#include "core/base/subjects.h"
#include "core/capture/camera_source.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibration_pictures.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <cmath>

namespace odo {

namespace {

RegistrationCheck::Outcome outcomeOf(MovedCheck::Verdict verdict)
{
    switch (verdict) {
    case MovedCheck::Verdict::CameraMoved:
        return RegistrationCheck::Outcome::CameraMoved;
    case MovedCheck::Verdict::MarkersMoved:
        return RegistrationCheck::Outcome::MarkersMoved;
    case MovedCheck::Verdict::Still:
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

MovedJob::MovedJob(MovedSettings settings) : m_settings(std::move(settings)) {}

Result<void> MovedJob::prepare(Project &project)
{
    const auto registered = registeredCamera(project, m_settings.camera);
    if (!registered)
        return tl::unexpected(registered.error());
    const RegistrationRecord &record = registered->registration;
    auto view = floorViewOf(project, record);
    if (!view)
        return tl::unexpected(view.error());
    auto layout = project.layouts().get(record.layout);
    if (!layout)
        return tl::unexpected(layout.error());
    m_registration = record.id;
    m_view = std::move(*view);
    m_layout = std::move(layout->layout);
    m_stored = record.pixels;
    // Of one coordinate; the RMS of a registration is that of the whole distance.
    m_fitPx = record.registration.rmsPx / std::sqrt(2.0);
    return {};
}

Result<Frame> MovedJob::picture(const JobControl &control) const
{
    if (!m_settings.liveUri.empty()) {
        auto camera = openCamera(m_settings.liveUri);
        if (!camera)
            return tl::unexpected(camera.error());
        return settledPicture(**camera, control);
    }
    std::optional<Frame> first;
    const auto visited = visitPictures(
        m_settings.pictureFile, 1,
        [&](const Frame &frame, const std::string &) {
            first = frame;
            return false;
        },
        control.cancel);
    if (!visited)
        return tl::unexpected(visited.error());
    if (!first)
        return fail(ErrorCode::Undetermined, fileSubject(m_settings.pictureFile),
                    ODO_TEXT("workflow.file_without_picture", "it has no picture"), giveAnotherFile());
    return *first;
}

Result<void> MovedJob::run(const JobControl &control)
{
    control.report(0, ODO_TEXT("workflow.looking_for_markers_again", "looking for the markers again"));
    const auto frame = picture(control);
    if (!frame)
        return tl::unexpected(frame.error());
    const Message camera = cameraSubject(m_settings.camera);
    const Intrinsics &lens = m_view->camera().intrinsics();
    if (frame->y.width != lens.widthPx || frame->y.height != lens.heightPx)
        return fail(ErrorCode::InvalidInput, whetherMoved(camera),
                    ODO_TEXT("workflow.registered_at_another_size",
                             "the picture is %1, the camera was registered at %2")(
                        sizeText(frame->y.width, frame->y.height), sizeText(lens.widthPx, lens.heightPx)),
                    ODO_TEXT("workflow.give_picture_of_that_size", "give a picture of that size"));
    auto check = checkMoved(m_settings.camera, *m_view, m_stored,
                            findAgain(*frame, m_layout, m_stored, m_view->camera()), m_fitPx);
    if (!check)
        return tl::unexpected(check.error());
    if (control.isCancelled())
        return cancelled(camera);
    m_check = std::move(*check);
    return {};
}

Result<void> MovedJob::commit(Project &project)
{
    return project.note(checkWords(m_settings.camera), [&] {
        return project.cameras().addCheck(m_registration, {instantNow(), outcomeOf(m_check.verdict),
                                                           m_check.shiftPx, m_check.shiftM, m_check.words});
    });
}

Result<void> keepNotTold(Project &project, const std::string &camera, const Error &error)
{
    const auto registered = registeredCamera(project, camera);
    if (!registered)
        return tl::unexpected(registered.error());
    return project.note(checkWords(camera), [&] {
        return project.cameras().addCheck(
            registered->registration.id,
            {instantNow(), RegistrationCheck::Outcome::NotTold, 0, 0, wholeMessage(error)});
    });
}

} // namespace odo
