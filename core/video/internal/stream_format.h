// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"
#include "core/video/video_input.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace odo {

/// What the stream and its container say about the frames. They are given as
/// planesOf() says. Errors: a pixel format of which it makes none, more than 100 megapixels or 32000 pixels a
/// side.
Result<FrameFormat> streamFormat(const VideoInput &input);

/// Size and chroma of an MJPEG stream as most of these of its frames have it by their headers, where they
/// agree: libav judges a stream by one frame, which may be a damaged one. Frames of two images, one for each
/// field, stay as the container says.
void judgeByMost(const std::vector<std::vector<std::uint8_t>> &jpegs, FrameFormat &format,
                 AVPixelFormat &pixelFormat);

/// chroma_sample_loc_type (0 left, 1 centre, 2 top left, ...) of the first sequence parameter set in H.264
/// decoder configuration (avcC or Annex B), or nullopt where the stream says nothing about it. Never reads
/// outside `data`. Source: ITU-T H.264 (08/2021) §7.3.2.1.1 and §E.1.1.
std::optional<unsigned> h264ChromaLocation(std::span<const std::uint8_t> data);

} // namespace odo
