// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"
#include "core/video/internal/libav.h"

#include <optional>

extern "C" {
#include <libavutil/pixfmt.h>
}

namespace odo {

/// The format of the 8-bit planes that a PixelPlanes makes of a pixel format: chroma as halved there, or as
/// in the next finer one that a FrameFormat knows; of red, green and blue 4:4:4 by BT.601 at full range.
/// `stated`: size, range, matrix and siting as the stream has them. Nullopt: it is none that is read (of a
/// sensor's mosaic, of a graphics card, of XYZ).
std::optional<FrameFormat> planesOf(AVPixelFormat pixels, const FrameFormat &stated);

/// The pixel format of libav that the planes of a frame have, apart from its range.
AVPixelFormat pixelsLike(const FrameFormat &format);

/// Bits of a sample in a pixel format of libav.
int bitsOf(AVPixelFormat pixels);

/// Makes Frames of libav's frames of one pixel format and size. Planes of 8 bits are referred to, not copied.
/// Deeper ones lose their lower bits (by libyuv), which are noise in what cameras record; what is packed,
/// in a palette or in red, green and blue is converted by libswscale. Grey gets chroma 128, and what is
/// transparent is read as if it were not. One thread at a time; frames may outlive it.
class PixelPlanes
{
public:
    /// `format`: by planesOf(pixels, …).
    PixelPlanes(AVPixelFormat pixels, const FrameFormat &format);

    AVPixelFormat pixels() const { return m_pixels; }
    const FrameFormat &format() const { return m_frames.format(); }
    /// Index and time are left to the caller. Nullopt: it is of another size or pixel format, or libswscale
    /// fails.
    std::optional<Frame> frameOf(libav::FramePtr avFrame) const;

private:
    AVPixelFormat m_pixels;
    FramePool m_frames;
};

} // namespace odo
