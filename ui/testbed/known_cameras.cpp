// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/known_cameras.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/registered_view.h"
#include "ui/models/camera_list_model.h"

namespace odo {
namespace {

Result<std::optional<std::filesystem::path>> newestFile(Project &project, RecordId camera)
{
    const auto recording = project.trials().newestRecording(camera);
    if (!recording)
        return tl::unexpected(recording.error());
    return *recording ? std::optional(project.resolve(**recording)) : std::nullopt;
}

} // namespace

Result<std::vector<FloorCamera>> floorCameras(Project &project)
{
    const auto rows = loadCameraRows(project);
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<FloorCamera> cameras;
    for (const CameraRow &row : *rows) {
        const auto recording = newestFile(project, row.camera.id);
        if (!recording)
            return tl::unexpected(recording.error());
        cameras.push_back({QString::fromStdString(row.camera.name), row.intrinsics, *recording, cameraBadge(row.registration)});
    }
    return cameras;
}

Result<std::vector<CheckCamera>> checkCameras(Project &project)
{
    const auto rows = loadCameraRows(project);
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<CheckCamera> cameras;
    for (const CameraRow &row : *rows) {
        if (!row.registration)
            continue;
        const auto view = floorViewOf(project, *row.registration);
        if (!view)
            return tl::unexpected(view.error());
        const auto layout = project.layouts().get(row.registration->layout);
        if (!layout)
            return tl::unexpected(layout.error());
        const auto recording = newestFile(project, row.camera.id);
        if (!recording)
            return tl::unexpected(recording.error());
        cameras.push_back({QString::fromStdString(row.camera.name), *view, layout->layout, *recording, row.camera.deviceUri,
                           cameraBadge(row.registration)});
    }
    return cameras;
}

} // namespace odo
