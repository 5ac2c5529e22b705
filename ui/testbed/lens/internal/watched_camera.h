// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <functional>
#include <memory>
#include <mutex>

namespace odo {

/// Opens the camera whose board is to be seen.
using OpenCamera = std::function<Result<std::shared_ptr<CameraSource>>()>;

/// A camera that one thread opens and reads while another may stop it at any moment.
class WatchedCamera
{
public:
    explicit WatchedCamera(OpenCamera open);

    /// Opens the camera at the first call. Errors: those of opening and of CameraSource::next(). One thread.
    Result<CapturedFrame> next();
    /// Wakes who waits in next(). Any thread.
    void stop();

private:
    Result<std::shared_ptr<CameraSource>> camera();

    const OpenCamera m_open;
    std::mutex m_mutex; ///< guards what follows
    std::shared_ptr<CameraSource> m_camera;
    bool m_stopped = false;
};

} // namespace odo
