// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/cameras.h"

#include "core/base/subjects.h"
#include "core/capture/camera_errors.h"
#include "core/exchange/intrinsics_yaml.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

namespace odo {

Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name)
{
    auto found = project.cameras().find(name);
    if (found || found.error().code != ErrorCode::NotFound)
        return found;
    return project.cameras().add({0, name, ""});
}

Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file)
{
    auto intrinsics = ODO_TRY(readIntrinsics(file));
    IntrinsicsRecord record;
    record.made = instantNow();
    const MessageArgument name = Named::file(file.filename());
    record.origin = ODO_TEXT("workflow.lens_imported_from", "imported from %1")(name);
    record.calibration.intrinsics = std::move(intrinsics);
    const auto stored = project.note(
        ODO_TEXT("workflow.import_lens", "import the lens of camera %1 from %2")(Named::camera(camera), name),
        [&]() -> Result<void> {
            const auto found = ODO_TRY(findOrAddCamera(project, camera));
            record.camera = found.id;
            auto added = ODO_TRY(project.cameras().addIntrinsics(record));
            record = std::move(added);
            return {};
        });
    if (!stored)
        return tl::unexpected(stored.error());
    return record;
}

Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target)
{
    const auto found = ODO_TRY(project.cameras().find(camera));
    const auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(found.id));
    if (!intrinsics)
        return fail(
            ErrorCode::NotFound,
            ODO_TEXT("workflow.intrinsics_of_camera", "intrinsics of camera '%1'")(Named::camera(camera)),
            ODO_TEXT("workflow.never_calibrated", "it was never calibrated"),
            ODO_TEXT("workflow.run_calibrate", "run odograph calibrate, or odograph intrinsics import"));
    return writeIntrinsics(target, camera, intrinsics->calibration.intrinsics);
}

Result<RegistrationRecord> storeRegistration(Project &project, const std::string &camera,
                                             RegistrationRecord record)
{
    const auto owner = ODO_TRY(findOrAddCamera(project, camera));
    record.camera = owner.id;
    record.made = instantNow();
    record.softwareVersion = ODOGRAPH_VERSION;
    return project.cameras().addRegistration(record);
}

Result<RegistrationRecord> storeFromOldMarkers(Project &project, const std::string &camera,
                                               RegistrationRecord record,
                                               const std::optional<RegistrationCheck> &lastCheck)
{
    auto stored = storeRegistration(project, camera, std::move(record));
    if (!stored || !lastCheck)
        return stored;
    ODO_TRY(project.cameras().addCheck(stored->id, *lastCheck));
    return project.cameras().registration(stored->id);
}

Result<std::vector<RegisteredCamera>> camerasOnLayout(Project &project, RecordId layout)
{
    const auto cameras = ODO_TRY(project.cameras().all());
    std::vector<RegisteredCamera> registered;
    for (const CameraRecord &camera : cameras) {
        auto registration = ODO_TRY(project.cameras().currentRegistration(camera.id));
        if (registration && registration->layout == layout)
            registered.push_back({camera, std::move(*registration)});
    }
    return registered;
}

Result<RegisteredCamera> registeredCamera(Project &project, const std::string &camera)
{
    const auto found = ODO_TRY(project.cameras().find(camera));
    auto registration = ODO_TRY(project.cameras().currentRegistration(found.id));
    if (!registration)
        return fail(ErrorCode::NotFound, cameraSubject(camera), notRegisteredToFloor(), registerItFirst());
    return RegisteredCamera{found, std::move(*registration)};
}

} // namespace odo
