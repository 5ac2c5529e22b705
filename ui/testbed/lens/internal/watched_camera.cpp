// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/watched_camera.h"

namespace odo {

WatchedCamera::WatchedCamera(OpenCamera open) : m_open(std::move(open)) {}

Result<std::shared_ptr<CameraSource>> WatchedCamera::camera()
{
    if (m_camera)
        return m_camera;
    auto opened = m_open(); // without the lock: it may take seconds
    if (!opened)
        return opened;
    const std::lock_guard lock(m_mutex);
    m_camera = *opened;
    if (m_stopped)
        m_camera->stop();
    return m_camera;
}

Result<CapturedFrame> WatchedCamera::next()
{
    const auto opened = camera();
    return opened ? (*opened)->next() : tl::unexpected(opened.error());
}

void WatchedCamera::stop()
{
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    if (m_camera)
        m_camera->stop();
}

} // namespace odo
