// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/chosen_cameras.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/record/camera_choice_dialog.h"
#include "ui/record/live_scene.h"

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
                "connect camera " + name, [&, device = uri] { return m_project.cameras().setDevice(camera->id, device); });
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

} // namespace odo
