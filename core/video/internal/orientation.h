// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/image_reader.h"

#include <cstdint>
#include <span>

namespace odo {

/// How a still image is to be turned before it is shown, as EXIF numbers it (CIPA DC-008, tag 274): of a JPEG
/// by its first EXIF segment, of a PNG by its eXIf chunk, of a WebP by its EXIF chunk, of a TIFF by its own
/// directory. 1 where it does not say so, or in a way that no writer does; of HEIF always, which libheif
/// turns by the file's own boxes. Never reads outside `file`.
int statedOrientation(ImageFormat format, std::span<const std::uint8_t> file);

/// The same for the display matrix of a video (ISO/IEC 14496-12 §8.3.2; libavutil/display.h), the first two
/// columns a, b, c, d of which show pixel (p, q) at (a p + c q, b p + d q): its nearest quarter turn,
/// mirrored or not. 1 of one that shows nothing.
int orientationOfMatrix(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d);

} // namespace odo
