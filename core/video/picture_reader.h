// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <filesystem>

namespace odo {

/// Reads a still picture (PNG, JPEG, BMP, TIFF, PNM) as a full-range frame by BT.601: a JPEG's planes and a
/// grey picture's luma as they are, colours as 4:4:4. What it says on how it is to be turned is ignored:
/// cameras are calibrated on the sensor's own rows and columns. Refuses more than 50 megapixels or
/// 32000 pixels a side before decoding. Any thread.
Result<Frame> readPicture(const std::filesystem::path &file);

} // namespace odo
