// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "core/video/frame.h"

#include <filesystem>
#include <vector>

namespace odo {

/// Writes a frame as a still picture in colour; the ending names the format (.png, .jpg). Errors: those of
/// OutputFile.
Result<void> writePicture(const Frame &frame, const OutputTarget &target);

/// A frame in colour as a PNG.
Result<std::vector<unsigned char>> colourPng(const Frame &frame);

/// A frame's luma as a grey PNG, unchanged.
Result<std::vector<unsigned char>> greyPng(const Frame &frame);

/// The advice where a picture makes trouble that is not known better.
Message useAnotherPicture();

} // namespace odo
