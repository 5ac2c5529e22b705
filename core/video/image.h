// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "core/video/frame.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace odo {

/// An image for the screen: 0xffRRGGBB in native byte order (Qt's Format_RGB32), rows without padding.
struct ScreenImage
{
    int width = 0, height = 0;
    std::unique_ptr<std::uint32_t[]> pixels; ///< null: no image
};

/// Scales a frame to this size and converts it for the screen, by its own matrix and range (libyuv); high
/// dynamic range is mapped to the screen's. No image for a size of 0 or less. Any thread.
ScreenImage toScreen(const Frame &frame, int width, int height);

/// The way back, for what was painted to be encoded: pixels as in ScreenImage, rows `strideBytes` apart, to
/// 4:2:0 at limited range by BT.601, chroma centred. Width and height are even. Any thread.
Frame fromScreen(const std::uint32_t *pixels, int width, int height, std::ptrdiff_t strideBytes,
                 Nanoseconds time);

/// Writes a frame as a still image in colour; the ending names the format (.png, .jpg). Errors: those of
/// OutputFile.
Result<void> writeImage(const Frame &frame, const OutputTarget &target);

/// A frame in colour as a PNG.
Result<std::vector<unsigned char>> colourPng(const Frame &frame);

/// A frame's luma as a grey PNG, unchanged.
Result<std::vector<unsigned char>> greyPng(const Frame &frame);

/// The general advice where an image cannot be used.
Message useAnotherImage();

} // namespace odo
