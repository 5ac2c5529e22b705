// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/internal/libav.h"

namespace odo {

/// Whether a decoded frame holds two fields, of two moments.
bool isInterlaced(const AVFrame &avFrame);

/// The frame as its first field shows it: each line of the other field becomes the mean of the lines above
/// and below. Then all of the frame is of the moment of its time stamp, at half the vertical resolution. In
/// planar and semi-planar formats of 8 bits; the chroma of 4:2:0 keeps its position, because that of a field
/// lies where the frame's would (H.273 §8.7). Null where memory runs out.
libav::FramePtr firstFieldOf(libav::FramePtr avFrame);

} // namespace odo
