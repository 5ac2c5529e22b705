// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/live_scene.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/registered_view.h"

namespace odo {
namespace {

/// nullopt: the project does not know the camera, or it is not registered.
Result<std::optional<RegistrationRecord>> registrationOf(Project &project, const std::string &camera)
{
    const auto record = project.cameras().find(camera);
    if (!record)
        return std::nullopt;
    return project.cameras().currentRegistration(record->id);
}

} // namespace

Result<std::vector<WantedCamera>> wantedCameras(Project &project, const std::vector<ChosenCamera> &chosen)
{
    std::vector<WantedCamera> wanted;
    for (const auto &[name, uri] : chosen) {
        if (uri.empty())
            continue;
        WantedCamera camera{name, uri, std::nullopt, {}};
        const auto registration = registrationOf(project, name);
        if (!registration)
            return tl::unexpected(registration.error());
        if (*registration) {
            auto view = floorViewOf(project, **registration);
            if (!view)
                return tl::unexpected(view.error());
            const Intrinsics &lens = view->camera().intrinsics();
            camera.registeredPx = {lens.widthPx, lens.heightPx};
            camera.floorView = std::move(*view);
        }
        wanted.push_back(std::move(camera));
    }
    return wanted;
}

Result<TrialScenePtr> liveScene(Project &project, const std::vector<WantedCamera> &cameras,
                                const std::optional<Task> &task)
{
    auto scene = std::make_shared<TrialScene>();
    scene->task = task;
    for (const WantedCamera &camera : cameras) {
        SceneView view;
        view.camera = camera.name;
        view.floorView = camera.floorView;
        scene->views.push_back(std::move(view));
        if (!camera.floorView || scene->layout)
            continue;
        const auto registration = registrationOf(project, camera.name);
        if (!registration || !*registration)
            continue;
        auto layout = project.layouts().get((*registration)->layout);
        if (!layout)
            return tl::unexpected(layout.error());
        scene->layout = std::move(layout->layout);
    }
    return scene;
}

} // namespace odo
