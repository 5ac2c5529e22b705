// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <filesystem>

namespace odo {

/// Writes a frame as a still picture in colour; the ending names the format (.png, .jpg).
Result<void> writePicture(const Frame &frame, const std::filesystem::path &file);

} // namespace odo
