// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/v4l2/v4l2_mode.h"

namespace odo {

/// An open camera for people, by its node; of each format and size the fastest mode is named, the best first.
CameraDescription describeV4l2(const V4l2Device &device, const std::vector<V4l2Mode> &modes,
                               const V4l2Mode &chosen);

} // namespace odo
