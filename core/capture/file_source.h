// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/pace.h"

#include <filesystem>

namespace odo {

/// A video file that plays as if it were a camera; it is lost at its end. Errors: those of VideoReader::open.
Result<std::unique_ptr<CameraSource>> openFileSource(const std::filesystem::path &file, Pace::Kind pace);

} // namespace odo
