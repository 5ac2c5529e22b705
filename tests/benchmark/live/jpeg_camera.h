// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/simulation/scene.h"

namespace odo::test {

using JpegFrames = std::shared_ptr<const std::vector<std::vector<std::uint8_t>>>;

/// What a camera of a scene sees, from a frame to the last, coded as a webcam does.
Result<JpegFrames> codeFrames(const SimulatedScene &scene, int camera, std::int64_t firstFrame);

/// A webcam that codes its pictures itself: shows the same ones over and over at their rate, and reads them
/// as the V4L2 source reads its buffers. What the kernel does for a real one is missing.
std::unique_ptr<CameraSource> openJpegCamera(const std::string &uri, JpegFrames frames,
                                             double framesPerSecond);

} // namespace odo::test
