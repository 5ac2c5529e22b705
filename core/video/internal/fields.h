// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"
#include "core/video/internal/libav.h"

namespace odo {

/// A field of an interlaced frame: its every other line.
enum class Field { Top, Bottom };

/// The field of a decoded frame that was taken first; where the frame does not say, as the stream does.
Field firstFieldOf(const AVFrame &avFrame, AVFieldOrder ofStream);

/// The frame as one of its fields shows it: each line of the other field becomes the mean of the lines above
/// and below. Then all of it is of one moment, at half the vertical resolution. Chroma of 4:2:0 keeps its
/// position, because that of a field lies where the frame's would (H.273 §8.7).
Frame fieldOf(const Frame &frame, Field field);

} // namespace odo
