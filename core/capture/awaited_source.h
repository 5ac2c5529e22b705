// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <functional>

namespace odo {

/// Stands for a camera that could not be opened, so that others can run without it: opens it, again and again
/// on a thread of its own, until it is there, and is that camera from then on. Until then next() says
/// Unavailable, with the reason that the last attempt gave. An address that is not understood (InvalidInput)
/// is not tried again, and nothing comes of it. The destructor waits for an attempt that is under way.
std::unique_ptr<CameraSource> awaitCamera(const std::string &uri, Error why,
                                          std::function<Result<std::unique_ptr<CameraSource>>()> open,
                                          Nanoseconds betweenAttempts = std::chrono::seconds(2));

} // namespace odo
