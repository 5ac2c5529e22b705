// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

namespace odo {

/// Opens a USB camera (or whatever else has a V4L2 node) by its address, see V4l2Address, and starts it. A
/// camera that was lost is known again by its serial number, or by its name and port. Errors: those of
/// parseV4l2Address, openV4l2Device, chooseMode and V4l2Stream::start.
Result<std::unique_ptr<CameraSource>> openV4l2Source(const std::string &uri);

/// The cameras that are there, in use or not. Those that this user may not open are listed with the reason in
/// place of their formats.
std::vector<CameraDescription> listV4l2Cameras();

} // namespace odo
