// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/live_cameras.h"

#include "ui/models/core_words.h"

namespace odo {

LiveCameras::LiveCameras(List list, QObject *parent) : QObject(parent), m_list(std::move(list)) {}

void LiveCameras::look()
{
    auto found = std::make_shared<std::vector<CameraDescription>>();
    if (!m_task.start([found, list = m_list](const JobControl &) -> Result<void> {
            *found = list();
            return {};
        }))
        return;
    connect(
        &m_task, &BackgroundTask::finished, this,
        [this, found] {
            m_cameras = std::move(*found);
            Q_EMIT changed();
        },
        Qt::SingleShotConnection);
    Q_EMIT changed();
}

QString shownDeviceName(const CameraDescription &camera)
{
    const QString name = QString::fromStdString(camera.name);
    return camera.kind == "simulated" ? shownWords(name) : name;
}

} // namespace odo
