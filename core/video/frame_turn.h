// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// The format of a frame after turned(). Mirrored and turned chroma has another siting, and at a quarter turn
/// of 4:2:2 other shifts; chroma of an odd size becomes 4:4:4.
FrameFormat turnedFormat(const FrameFormat &format, int orientation);

/// Turns the frames of one stream as an EXIF orientation demands (CIPA DC-008, tag 274): 1 not at all,
/// 2 mirrored, 3 by 180°, 4 mirrored and by 180°, 5 mirrored and by 270° clockwise, 6 by 90° clockwise, 7
/// mirrored and by 90°, 8 by 270°; any other number as 1. Planes are copied sample by sample into memory that
/// is used again; chroma of an odd size is doubled first, because its samples would cover other pixels. One
/// thread at a time; the frames are immutable.
class FrameTurner
{
public:
    FrameTurner(const FrameFormat &format, int orientation);
    const FrameFormat &format() const { return m_frames.format(); } ///< of the turned frames
    /// The frame, whole and of the format that was given, turned; Frame::orientation says how. Orientation 1
    /// copies nothing.
    Frame turned(const Frame &frame) const;

private:
    int m_orientation;
    FramePool m_frames;
};

/// One frame, turned as by FrameTurner. Any thread.
Frame turned(const Frame &frame, int orientation);

/// A frame that was turned as frame.orientation says, turned as another orientation says instead. Any thread.
Frame inOrientation(const Frame &frame, int orientation);

/// By how many degrees clockwise an orientation turns a frame, after mirroring: 0, 90, 180 or 270.
int clockwiseDegreesOf(int orientation);
/// Whether an orientation mirrors a frame, left to right.
bool isMirroring(int orientation);

} // namespace odo
