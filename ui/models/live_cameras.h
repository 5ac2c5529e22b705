// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "ui/models/background_task.h"

namespace odo {

/// The cameras that are connected. To look for them takes up to two seconds, so it is done on a thread of its own; what was
/// found last stands meanwhile. GUI thread.
class LiveCameras : public QObject
{
    Q_OBJECT
public:
    using List = std::function<std::vector<CameraDescription>()>;

    /// list: called on a thread of its own.
    explicit LiveCameras(List list = listCameras, QObject *parent = nullptr);

    /// Looks again, unless that is under way.
    void look();
    bool isLooking() const { return m_task.isRunning(); }
    const std::vector<CameraDescription> &cameras() const { return m_cameras; }

Q_SIGNALS:
    void changed(); ///< looking has begun or ended

private:
    List m_list;
    std::vector<CameraDescription> m_cameras;
    BackgroundTask m_task;
};

/// What a camera that is connected is called: a simulated one in the language of the windows, others as their makers call them.
QString shownDeviceName(const CameraDescription &camera);

} // namespace odo
