// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/layout_axes.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"

#include <algorithm>

namespace odo {

namespace {

/// The layout, and those that lie in its axes since a camera was registered through one that stands on it.
Result<std::vector<LayoutRecord>> layoutsOfWorld(Project &project, const LayoutRecord &first)
{
    const auto all = ODO_TRY(project.layouts().all());
    std::vector<LayoutRecord> world{first};
    for (std::size_t i = 0; i < world.size(); ++i) {
        const auto cameras = ODO_TRY(camerasOnLayout(project, world[i].id));
        for (const LayoutRecord &layout : all) {
            const bool isThrough = std::ranges::any_of(cameras, [&](const RegisteredCamera &camera) {
                return isLayoutThrough(layout.layout.name, camera.camera.name);
            });
            if (isThrough && std::ranges::find(world, layout.id, &LayoutRecord::id) == world.end())
                world.push_back(layout);
        }
    }
    return world;
}

Result<void> carryCameras(Project &project, const LayoutRecord &layout, LayoutAxesOutcome &outcome)
{
    const auto cameras = ODO_TRY(camerasOnLayout(project, layout.id));
    for (const RegisteredCamera &camera : cameras) {
        RegistrationRecord record = camera.registration;
        record.registration = transformed(record.registration, outcome.newFromOld);
        std::optional<RegistrationCheck> check = record.lastCheck;
        if (check)
            check->shiftM *= outcome.newFromOld.scale;
        ODO_TRY(storeFromOldMarkers(project, camera.camera.name, std::move(record), check));
        outcome.cameras.push_back(camera.camera.name);
    }
    return {};
}

Result<std::vector<std::string>> tasksWithPlaces(Project &project)
{
    const auto tasks = ODO_TRY(project.tasks().all());
    std::vector<std::string> names;
    for (const TaskRecord &record : tasks)
        if (!record.task.gates.empty() || !record.task.path.points.empty() || !record.task.zones.empty())
            names.push_back(record.name);
    return names;
}

} // namespace

Result<LayoutAxesOutcome> changeLayoutAxes(Project &project, const std::string &layout,
                                           const AxesChange &change)
{
    auto stored = ODO_TRY(project.layouts().find(layout));
    const auto newFromOld = ODO_TRY(axesTransformOf(stored.layout, change));
    auto tasks = ODO_TRY(tasksWithPlaces(project));
    LayoutAxesOutcome outcome{std::move(stored), newFromOld, {}, std::move(tasks)};
    const auto world = ODO_TRY(layoutsOfWorld(project, outcome.layout));
    const auto done = project.change(
        ODO_TEXT("workflow.put_axes_elsewhere", "put the axes of layout %1 elsewhere")(Named::layout(layout)),
        [&]() -> Result<void> {
            for (LayoutRecord each : world) {
                each.layout = transformed(each.layout, newFromOld);
                ODO_TRY(project.layouts().setPlaces(each));
                ODO_TRY(carryCameras(project, each, outcome));
            }
            outcome.layout.layout = transformed(outcome.layout.layout, newFromOld);
            return {};
        });
    if (!done)
        return tl::unexpected(done.error());
    return outcome;
}

} // namespace odo
