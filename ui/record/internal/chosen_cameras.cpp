// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/chosen_cameras.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/trial_sources.h"
#include "ui/record/internal/camera_choice.h"

#include <algorithm>

namespace odo {

ChosenCameras::ChosenCameras(Project &project, CameraAccess access, QObject *parent)
    : QObject(parent), m_project(project), m_connected(std::move(access.list), this),
      m_running(std::move(access.open))
{
    connect(&m_connected, &LiveCameras::changed, this, [this] {
        if (m_wanted && !isPreparing() && !session())
            restart();
    });
}

void ChosenCameras::want()
{
    m_wanted = true;
    if (!session() && !m_running.isOpening())
        m_connected.look();
}

void ChosenCameras::stop()
{
    m_wanted = false;
    m_running.stop();
}

std::vector<ChosenCamera> ChosenCameras::proposed(const std::vector<CameraRecord> &cameras) const
{
    return proposeCameras(cameras, m_connected.cameras(), rememberedCameras());
}

void ChosenCameras::restart()
{
    const auto cameras = m_project.cameras().all();
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    if (std::ranges::all_of(m_chosen, [](const ChosenCamera &camera) { return camera.second.empty(); }))
        m_chosen = proposed(*cameras);
    auto wanted = wantedCameras(m_project, m_chosen);
    if (!wanted) {
        Q_EMIT failed(wanted.error());
        return;
    }
    if (wanted->empty()) {
        Q_EMIT noneConnected();
        return;
    }
    m_running.start(std::move(*wanted));
    Q_EMIT starting();
}

/// Of the cameras that it knows; one that can only be read goes by what this machine remembers.
void ChosenCameras::keepInProject()
{
    for (const auto &[name, uri] : m_chosen) {
        const auto camera = m_project.cameras().find(name);
        if (!camera || camera->deviceUri == uri)
            continue;
        if (const auto kept = m_project.note(
                ODO_TEXT("ui.connect_camera", "connect camera %1")(Named::camera(name)),
                [&, device = uri] { return m_project.cameras().setDevice(camera->id, device); });
            !kept && kept.error().code != ErrorCode::ReadOnly)
            Q_EMIT failed(kept.error());
    }
}

void ChosenCameras::choose(QWidget *parent)
{
    std::vector<ChosenCamera> now = m_chosen;
    if (now.empty())
        now = proposed(m_project.cameras().all().value_or(std::vector<CameraRecord>()));
    CameraChoiceDialog dialog(now, m_connected, parent);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_chosen = dialog.cameras();
    rememberCameras(m_chosen);
    keepInProject();
    restart();
}

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
        const auto registration = ODO_TRY(registrationOf(project, name));
        if (registration) {
            auto view = ODO_TRY(floorViewOf(project, *registration));
            const Intrinsics &lens = view.camera().intrinsics();
            camera.registeredPx = {lens.widthPx, lens.heightPx};
            camera.floorView = std::move(view);
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
        auto layout = ODO_TRY(project.layouts().get((*registration)->layout));
        scene->layout = std::move(layout.layout);
    }
    return scene;
}

} // namespace odo
