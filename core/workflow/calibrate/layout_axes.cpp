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
    const auto all = project.layouts().all();
    if (!all)
        return tl::unexpected(all.error());
    std::vector<LayoutRecord> world{first};
    for (std::size_t i = 0; i < world.size(); ++i) {
        const auto cameras = camerasOnLayout(project, world[i].id);
        if (!cameras)
            return tl::unexpected(cameras.error());
        for (const LayoutRecord &layout : *all) {
            const bool isThrough = std::ranges::any_of(*cameras, [&](const RegisteredCamera &camera) {
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
    const auto cameras = camerasOnLayout(project, layout.id);
    if (!cameras)
        return tl::unexpected(cameras.error());
    for (const RegisteredCamera &camera : *cameras) {
        RegistrationRecord record = camera.registration;
        record.registration = transformed(record.registration, outcome.newFromOld);
        std::optional<RegistrationCheck> check = record.lastCheck;
        if (check)
            check->shiftM *= outcome.newFromOld.scale;
        if (auto stored = storeFromOldMarkers(project, camera.camera.name, std::move(record), check); !stored)
            return tl::unexpected(stored.error());
        outcome.cameras.push_back(camera.camera.name);
    }
    return {};
}

Result<std::vector<std::string>> tasksWithPlaces(Project &project)
{
    const auto tasks = project.tasks().all();
    if (!tasks)
        return tl::unexpected(tasks.error());
    std::vector<std::string> names;
    for (const TaskRecord &record : *tasks)
        if (!record.task.gates.empty() || !record.task.path.points.empty() || !record.task.zones.empty())
            names.push_back(record.name);
    return names;
}

} // namespace

Result<LayoutAxesOutcome> changeLayoutAxes(Project &project, const std::string &layout,
                                           const AxesChange &change)
{
    auto stored = project.layouts().find(layout);
    if (!stored)
        return tl::unexpected(stored.error());
    const auto newFromOld = axesTransformOf(stored->layout, change);
    if (!newFromOld)
        return tl::unexpected(newFromOld.error());
    auto tasks = tasksWithPlaces(project);
    if (!tasks)
        return tl::unexpected(tasks.error());
    LayoutAxesOutcome outcome{std::move(*stored), *newFromOld, {}, std::move(*tasks)};
    const auto world = layoutsOfWorld(project, outcome.layout);
    if (!world)
        return tl::unexpected(world.error());
    const auto done = project.change(
        ODO_TEXT("workflow.put_axes_elsewhere", "put the axes of layout %1 elsewhere")(Named::layout(layout)),
        [&]() -> Result<void> {
            for (LayoutRecord each : *world) {
                each.layout = transformed(each.layout, *newFromOld);
                if (auto set = project.layouts().setPlaces(each); !set)
                    return set;
                if (auto carried = carryCameras(project, each, outcome); !carried)
                    return carried;
            }
            outcome.layout.layout = transformed(outcome.layout.layout, *newFromOld);
            return {};
        });
    if (!done)
        return tl::unexpected(done.error());
    return outcome;
}

} // namespace odo
