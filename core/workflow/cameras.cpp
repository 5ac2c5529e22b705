// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/cameras.h"

#include "core/exchange/intrinsics_yaml.h"
#include "core/project/instant_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

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
    auto intrinsics = readIntrinsics(file);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    IntrinsicsRecord record;
    record.made = instantNow();
    record.origin = "imported from " + file.filename().string();
    record.calibration.intrinsics = std::move(*intrinsics);
    const auto stored = project.note("import the lens of camera " + camera + " from " + file.filename().string(), [&]() -> Result<void> {
        const auto found = findOrAddCamera(project, camera);
        if (!found)
            return tl::unexpected(found.error());
        record.camera = found->id;
        auto added = project.cameras().addIntrinsics(record);
        if (!added)
            return tl::unexpected(added.error());
        record = std::move(*added);
        return {};
    });
    if (!stored)
        return tl::unexpected(stored.error());
    return record;
}

Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target)
{
    const auto found = project.cameras().find(camera);
    if (!found)
        return tl::unexpected(found.error());
    const auto intrinsics = project.cameras().currentIntrinsics(found->id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    if (!*intrinsics)
        return fail(ErrorCode::NotFound, "intrinsics of camera '" + camera + "'", "it was never calibrated",
                    "run odograph calibrate, or odograph intrinsics import");
    return writeIntrinsics(target, camera, (*intrinsics)->calibration.intrinsics);
}

} // namespace odo
