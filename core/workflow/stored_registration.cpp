// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/stored_registration.h"

#include "core/project/instant_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/cameras.h"

namespace odo {

Result<RegistrationRecord> storeRegistration(Project &project, const std::string &camera, RegistrationRecord record)
{
    const auto owner = findOrAddCamera(project, camera);
    if (!owner)
        return tl::unexpected(owner.error());
    record.camera = owner->id;
    record.made = instantNow();
    record.softwareVersion = ODOGRAPH_VERSION;
    return project.cameras().addRegistration(record);
}

Result<RegistrationRecord> storeFromOldMarkers(Project &project, const std::string &camera, RegistrationRecord record,
                                               const std::optional<RegistrationCheck> &lastCheck)
{
    auto stored = storeRegistration(project, camera, std::move(record));
    if (!stored || !lastCheck)
        return stored;
    if (auto added = project.cameras().addCheck(stored->id, *lastCheck); !added)
        return tl::unexpected(added.error());
    return project.cameras().registration(stored->id);
}

Result<std::vector<RegisteredCamera>> camerasOnLayout(Project &project, RecordId layout)
{
    const auto cameras = project.cameras().all();
    if (!cameras)
        return tl::unexpected(cameras.error());
    std::vector<RegisteredCamera> registered;
    for (const CameraRecord &camera : *cameras) {
        auto registration = project.cameras().currentRegistration(camera.id);
        if (!registration)
            return tl::unexpected(registration.error());
        if (*registration && (*registration)->layout == layout)
            registered.push_back({camera, std::move(**registration)});
    }
    return registered;
}

Result<RegisteredCamera> registeredCamera(Project &project, const std::string &camera)
{
    const auto found = project.cameras().find(camera);
    if (!found)
        return tl::unexpected(found.error());
    auto registration = project.cameras().currentRegistration(found->id);
    if (!registration)
        return tl::unexpected(registration.error());
    if (!*registration)
        return fail(ErrorCode::NotFound, "camera '" + camera + "'", "it is not registered to the floor",
                    "register it first, by markers or through another camera");
    return RegisteredCamera{*found, std::move(**registration)};
}

} // namespace odo
