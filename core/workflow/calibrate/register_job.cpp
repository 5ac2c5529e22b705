// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/register_job.h"

#include "core/base/error.h"
#include "core/calibration/marker_detection.h"
#include "core/exchange/labelled_points.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/fitted_intrinsics.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>

namespace odo {

namespace {

// Markers do not move; a few frames are searched in case somebody hides one in the first.
constexpr int markerVideoStep = 10;
constexpr int mostImages = 12;

Message registrationOf(const std::string &camera)
{
    return ODO_TEXT("workflow.registration_of_camera", "registration of camera '%1'")(Named::camera(camera));
}

Message imageSizeNotKnown()
{
    return joined({ODO_TEXT("workflow.picture_size_not_known", "the size of its images is not known"),
                   ODO_TEXT("workflow.neither_lens_nor_recording", "it has no intrinsics and no recording")},
                  Join::Colon);
}

} // namespace

RegisterJob::RegisterJob(RegisterSettings settings) : m_settings(std::move(settings)) {}

Result<void> RegisterJob::prepare(Project &project)
{
    const auto layout = ODO_TRY(project.layouts().find(m_settings.layout));
    m_layout = layout.layout;
    m_record.layout = layout.id;
    m_record.image = m_settings.image;
    m_mediaFolder = project.mediaFolder();

    const auto cameras = ODO_TRY(project.cameras().all());
    for (const CameraRecord &camera : cameras) {
        if (camera.name != m_settings.camera)
            continue;
        const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(camera.id));
        if (intrinsics) {
            m_intrinsicsKnown = true;
            m_stored = *intrinsics;
            m_intrinsics = intrinsics->calibration.intrinsics;
            m_record.intrinsics = intrinsics->id;
            if (m_settings.widthPx > 0)
                takeSize(m_settings.widthPx, m_settings.heightPx);
        }
        const auto recording = ODO_TRY(project.trials().newestRecording(camera.id));
        if (recording && m_settings.imageFile.empty() && m_settings.pixelsFile.empty() &&
            m_settings.pixels.empty())
            m_settings.imageFile = project.resolve(*recording);
        if (recording && !m_intrinsicsKnown) {
            m_intrinsics.widthPx = recording->widthPx;
            m_intrinsics.heightPx = recording->heightPx;
        }
    }
    m_context.isSeenInImage = m_settings.pixelsFile.empty();
    return findOtherCameras(project, layout.id);
}

Result<void> RegisterJob::findOtherCameras(Project &project, RecordId layout)
{
    const auto cameras = ODO_TRY(camerasOnLayout(project, layout));
    for (const RegisteredCamera &each : cameras) {
        if (each.camera.name == m_settings.camera)
            continue;
        auto view = ODO_TRY(floorViewOf(project, each.registration));
        m_context.others.push_back({each.camera.name, view.camera(), std::move(view)});
    }
    return {};
}

Result<void> RegisterJob::run(const JobControl &control)
{
    if (!m_settings.pixelsFile.empty()) {
        auto pixels = ODO_TRY(readPixelsCsv(m_settings.pixelsFile));
        m_settings.pixels = std::move(pixels);
    }
    if (m_settings.pixels.empty() || !m_settings.imageFile.empty())
        ODO_TRY(findInImages(control));
    fitIntrinsics();
    auto camera = ODO_TRY(cameraModel());
    auto registration = registerFloor(m_layout, m_settings.pixels, camera, m_intrinsicsKnown, m_context);
    if (!registration) {
        Error error = registration.error();
        error.what = registrationOf(m_settings.camera);
        return tl::unexpected(error);
    }
    m_record.pixels = m_settings.pixels;
    m_record.assumedIntrinsics = registration->intrinsics;
    m_record.registration = std::move(*registration);
    if (!m_fitting.isEmpty())
        m_record.registration.verdict =
            joined({std::move(m_record.registration.verdict), m_fitting}, Join::Space);
    return keepImage();
}

Result<void> RegisterJob::keepImage()
{
    if (!m_seenIn)
        return {};
    m_media = std::make_unique<CalibrationMedia>(m_mediaFolder);
    m_record.image = ODO_TRY(m_media->writeFloor(m_settings.camera, *m_seenIn));
    return {};
}

Result<void> RegisterJob::findInImages(const JobControl &control)
{
    const Message what =
        ODO_TEXT("workflow.markers_for_camera", "markers for camera '%1'")(Named::camera(m_settings.camera));
    if (m_settings.imageFile.empty())
        return fail(ErrorCode::NotFound, what,
                    ODO_TEXT("workflow.no_pixels_no_picture",
                             "it needs pixels, or an image to detect the markers in"),
                    ODO_TEXT("workflow.give_pixels_or_picture",
                             "give the markers' pixels, or an image or a video of the floor"));
    const bool wanted = m_settings.pixels.empty();
    tl::unexpected<Error> lastProblem =
        fail(ErrorCode::Undetermined, what,
             ODO_TEXT("workflow.video_without_picture", "the video has no frame"), giveAnotherFile());
    int looked = 0;
    Result<MarkerSearch> search = MarkerSearch();
    auto visited = visitImages(
        m_settings.imageFile, markerVideoStep,
        [&](const Frame &frame, const std::string &name) {
            control.report(double(looked) / mostImages, detectingMarkersIn(name));
            search = searchIn(frame);
            if (!wanted)
                m_seenIn = frame;
            if (!wanted || !search)
                return false;
            auto pixels = findMarkers(frame, m_layout, *search);
            if (!pixels)
                lastProblem = tl::unexpected(pixels.error());
            else if (pixels->size() > m_settings.pixels.size()) {
                m_settings.pixels = std::move(*pixels);
                m_seenIn = frame;
            }
            return m_settings.pixels.size() < m_layout.markers.size() && ++looked < mostImages &&
                   !control.isCancelled();
        },
        control.cancel);
    if (control.isCancelled())
        return cancelled(what);
    if (!visited || !search)
        return visited ? tl::unexpected(search.error()) : visited;
    if (m_settings.pixels.empty())
        return lastProblem;
    return {};
}

/// The lens serves images of this size until it is fitted to one.
void RegisterJob::takeSize(int widthPx, int heightPx)
{
    const Intrinsics &stored = m_stored.calibration.intrinsics;
    const auto formats = sensorFormats(stored.widthPx, stored.heightPx, widthPx, heightPx);
    const bool isSame = widthPx == stored.widthPx && heightPx == stored.heightPx;
    m_intrinsics = isSame || formats.empty() ? stored : inFormat(stored, formats.front());
}

/// What is known of the markers of an image, whose size the lens takes.
Result<MarkerSearch> RegisterJob::searchIn(const Frame &frame)
{
    const int widthPx = frame.format.width, heightPx = frame.format.height;
    MarkerSearch search{std::nullopt, m_intrinsicsKnown, m_settings.hints};
    if (!m_intrinsicsKnown) {
        m_intrinsics.widthPx = widthPx;
        m_intrinsics.heightPx = heightPx;
        return search;
    }
    takeSize(widthPx, heightPx);
    const Intrinsics &stored = m_stored.calibration.intrinsics;
    search.intrinsicsKnown = determinedFormat(stored.widthPx, stored.heightPx, widthPx, heightPx).has_value();
    if (search.intrinsicsKnown)
        search.camera = ODO_TRY(cameraModel());
    return search;
}

/// Where the image has another size than the lens was calibrated at.
void RegisterJob::fitIntrinsics()
{
    const Intrinsics &stored = m_stored.calibration.intrinsics;
    if (!m_intrinsicsKnown ||
        (m_intrinsics.widthPx == stored.widthPx && m_intrinsics.heightPx == stored.heightPx))
        return;
    const auto misfit = [this](const Intrinsics &lens) -> std::optional<double> {
        const auto camera = CameraModel::create(lens);
        const auto fit = camera ? registerFloor(m_layout, m_settings.pixels, *camera, true)
                                : tl::unexpected(camera.error());
        if (!fit)
            return std::nullopt;
        double squares = 0;
        for (const MarkerError &marker : fit->markers)
            squares += marker.errorPx * marker.errorPx;
        return squares;
    };
    auto [lens, how] = fittedIntrinsics(stored, m_intrinsics.widthPx, m_intrinsics.heightPx,
                                        m_settings.pixels.size(), misfit);
    m_intrinsics = std::move(lens);
    m_fitting = std::move(how);
}

Result<CameraModel> RegisterJob::cameraModel() const
{
    if (m_intrinsicsKnown)
        return CameraModel::create(m_intrinsics);
    if (m_intrinsics.widthPx > 0)
        return CameraModel::assumed(m_intrinsics.widthPx, m_intrinsics.heightPx);
    return fail(ErrorCode::NotFound, registrationOf(m_settings.camera), imageSizeNotKnown(),
                ODO_TEXT("workflow.calibrate_or_give_picture",
                         "calibrate it, import its intrinsics, or give an image or a video as well"));
}

Message registerChange(const std::string &camera)
{
    return ODO_TEXT("workflow.register_camera", "register camera %1")(Named::camera(camera));
}

Result<RegistrationRecord> registerWithCurrentIntrinsics(Project &project, const std::string &camera)
{
    const Message what =
        ODO_TEXT("workflow.registration_with_lens_in_force",
                 "registration of camera '%1' with the current lens calibration")(Named::camera(camera));
    const auto registered = ODO_TRY(registeredCamera(project, camera));
    const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(registered.camera.id));
    if (!intrinsics || intrinsics->id == registered.registration.intrinsics)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.made_with_it_already", "it already uses that calibration"),
                    ODO_TEXT("workflow.calibrate_lens_first",
                             "calibrate the lens first, or choose another calibration"));
    const auto layout = ODO_TRY(project.layouts().get(registered.registration.layout));
    const auto cameras = ODO_TRY(project.cameras().all());
    if (std::ranges::any_of(cameras, [&](const CameraRecord &each) {
            return isLayoutOfReference(layout.layout.name, each.name);
        }))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.registered_through_another", "it was registered via another camera"),
                    ODO_TEXT("workflow.register_through_it_again", "register it via that camera again"));
    RegisterSettings settings{
        camera, layout.layout.name, {}, {}, registered.registration.pixels, registered.registration.image};
    const FloorView before = ODO_TRY(floorViewOf(project, registered.registration));
    settings.widthPx = before.camera().intrinsics().widthPx;
    settings.heightPx = before.camera().intrinsics().heightPx;
    RegisterJob job(std::move(settings));
    ODO_TRY(job.prepare(project));
    ODO_TRY(job.run({}));
    std::optional<RegistrationRecord> record;
    const auto stored = project.change(
        ODO_TEXT("workflow.register_camera_again", "register camera %1 again")(Named::camera(camera)),
        [&]() -> Result<void> {
            RegistrationRecord again = ODO_TRY(job.withStoredIntrinsics(project));
            again.isUpright = registered.registration.isUpright;
            record = ODO_TRY(storeFromOldMarkers(project, camera, again, registered.registration.lastCheck));
            return {};
        });
    if (!stored)
        return tl::unexpected(stored.error());
    return *record;
}

Result<RegistrationRecord> RegisterJob::withStoredIntrinsics(Project &project) const
{
    RegistrationRecord record = m_record;
    if (m_fitting.isEmpty())
        return record;
    IntrinsicsRecord fitted;
    fitted.camera = m_stored.camera;
    fitted.made = m_stored.made;
    fitted.origin = m_fitting;
    fitted.calibration.intrinsics = m_intrinsics;
    fitted.softwareVersion = ODOGRAPH_VERSION;
    fitted = ODO_TRY(project.cameras().addIntrinsics(fitted));
    record.intrinsics = fitted.id;
    return record;
}

Result<void> RegisterJob::commit(Project &project)
{
    auto committed = project.change(registerChange(m_settings.camera), [&]() -> Result<void> {
        m_record = ODO_TRY(withStoredIntrinsics(project));
        m_record = ODO_TRY(storeRegistration(project, m_settings.camera, m_record));
        return {};
    });
    if (committed && m_media)
        m_media->keep();
    m_media.reset(); // where it was not stored, its image goes
    return committed;
}

namespace {

constexpr const char *viaWord = " through ";

Message subject(const RegisterViaCameraSettings &settings)
{
    return ODO_TEXT("workflow.registration_through", "registration of camera '%1' via '%2'")(
        Named::camera(settings.camera), Named::camera(settings.reference));
}

std::string freeName(const std::vector<LayoutRecord> &layouts, const std::string &wanted)
{
    const auto isTaken = [&](const std::string &name) {
        return std::ranges::any_of(layouts, [&](const LayoutRecord &one) { return one.layout.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + " (" + std::to_string(number) + ")";
    return name;
}

} // namespace

RegisterViaCameraJob::RegisterViaCameraJob(RegisterViaCameraSettings settings)
    : m_settings(std::move(settings))
{
}

Result<void> RegisterViaCameraJob::prepare(Project &project)
{
    if (m_settings.camera == m_settings.reference)
        return fail(ErrorCode::InvalidInput, subject(m_settings),
                    ODO_TEXT("workflow.through_itself", "a camera cannot be registered via itself"),
                    ODO_TEXT("workflow.name_another_camera", "name another camera that is registered"));
    const auto reference = ODO_TRY(project.cameras().find(m_settings.reference));
    const auto registration = ODO_TRY(project.cameras().currentRegistration(reference.id));
    if (!registration)
        return fail(ErrorCode::NotFound, subject(m_settings),
                    ODO_TEXT("workflow.camera_not_registered",
                             "camera '%1' is not registered")(Named::camera(m_settings.reference)),
                    registerItFirst());
    m_reference = ODO_TRY(floorViewOf(project, *registration));
    m_referenceRegistration = registration->id;
    return findCamera(project);
}

Result<void> RegisterViaCameraJob::findCamera(Project &project)
{
    const auto camera = ODO_TRY(project.cameras().find(m_settings.camera));
    const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(camera.id));
    if (intrinsics) {
        m_camera = ODO_TRY(CameraModel::create(intrinsics->calibration.intrinsics));
        m_intrinsicsKnown = true;
        m_record.intrinsics = intrinsics->id;
        return {};
    }
    const auto recording = ODO_TRY(project.trials().newestRecording(camera.id));
    if (!recording)
        return fail(ErrorCode::NotFound, subject(m_settings), imageSizeNotKnown(),
                    ODO_TEXT("workflow.calibrate_or_import_trial",
                             "calibrate it, import its intrinsics, or import a trial with it first"));
    m_camera = CameraModel::assumed(recording->widthPx, recording->heightPx);
    return {};
}

Result<void> RegisterViaCameraJob::run(const JobControl &)
{
    auto chained = registerViaCamera(*m_reference, cameraSubject(m_settings.reference), m_settings.points,
                                     *m_camera, m_intrinsicsKnown);
    if (!chained) {
        Error error = chained.error();
        error.what = subject(m_settings);
        return tl::unexpected(error);
    }
    m_layout = std::move(chained->positions);
    m_record.pixels = std::move(chained->pixels);
    m_record.registration = std::move(chained->registration);
    m_record.assumedIntrinsics = m_record.registration.intrinsics;
    m_record.image = m_settings.image;
    return {};
}

Result<RegistrationRecord> storeViaCamera(Project &project, const std::string &camera,
                                          const std::string &reference, RecordId referenceRegistration,
                                          MarkerLayout &positions, RegistrationRecord record)
{
    const auto layouts = ODO_TRY(project.layouts().all());
    positions.name = freeName(layouts, camera + viaWord + reference);
    const auto layout = ODO_TRY(project.layouts().add(positions));
    record.layout = layout.id;
    record.registration.verdict =
        joined({std::move(record.registration.verdict),
                ODO_TEXT("workflow.made_through_registration",
                         "It was made via registration %1 of the project.")(referenceRegistration)},
               Join::Space);
    return storeRegistration(project, camera, std::move(record));
}

Result<void> RegisterViaCameraJob::commit(Project &project)
{
    return project.change(ODO_TEXT("workflow.register_camera_through", "register camera %1 via camera %2")(
                              Named::camera(m_settings.camera), Named::camera(m_settings.reference)),
                          [&]() -> Result<void> {
                              m_record =
                                  ODO_TRY(storeViaCamera(project, m_settings.camera, m_settings.reference,
                                                         m_referenceRegistration, m_layout, m_record));
                              return {};
                          });
}

bool isLayoutOfReference(const std::string &layoutName, const std::string &reference)
{
    // freeName() may have put a number behind it.
    const std::string ending = viaWord + reference;
    const auto at = layoutName.rfind(ending);
    if (at == std::string::npos || at == 0)
        return false;
    const std::string rest = layoutName.substr(at + ending.size());
    return rest.empty() || (rest.starts_with(" (") && rest.ends_with(")"));
}

RegisterJointJob::RegisterJointJob(RegisterJointSettings settings) : m_settings(std::move(settings)) {}

Result<void> RegisterJointJob::prepare(Project &project)
{
    const auto layout = ODO_TRY(project.layouts().find(m_settings.layout));
    m_layout = layout.layout;
    auto cameras = ODO_TRY(camerasOnLayout(project, layout.id));
    for (RegisteredCamera &camera : cameras) {
        const auto view = ODO_TRY(floorViewOf(project, camera.registration));
        m_names.push_back(camera.camera.name);
        m_cameras.push_back(
            {camera.camera.name, view.camera(), view.worldFromCamera(), camera.registration.pixels});
        m_records.push_back(std::move(camera.registration));
    }
    return {};
}

Result<void> RegisterJointJob::run(const JobControl &control)
{
    control.report(
        0, ODO_TEXT("workflow.fitting_cameras_together", "fitting %1 cameras jointly")(m_cameras.size()));
    m_joint = ODO_TRY(registerJointly(m_layout, m_cameras, m_settings.tapeSigmaM));
    return {};
}

Result<void> RegisterJointJob::commit(Project &project)
{
    return project.change(
        ODO_TEXT("workflow.register_cameras_together",
                 "register the cameras of layout %1 jointly")(Named::layout(m_settings.layout)),
        [&]() -> Result<void> {
            for (std::size_t i = 0; i < m_records.size(); ++i) {
                m_records[i].registration = m_joint.registrations[i];
                const auto stored =
                    ODO_TRY(storeFromOldMarkers(project, m_names[i], m_records[i], m_records[i].lastCheck));
                m_records[i] = stored;
            }
            return {};
        });
}

} // namespace odo
