// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <memory>

extern "C" {
#include <libavutil/rational.h>
}

struct SwsContext;

namespace odo {

/// The width at which frames are seen whose pixels have this aspect ratio (width to height): the
/// nearest that whole samples of chroma cover; the width as it is where the ratio is not stated, is none that
/// a camera writes (beyond 1 : 3 and 3 : 1), or makes frames too large.
int widthAsSeen(const FrameFormat &format, AVRational pixelAspect);

/// Stretches the frames of one stream to another width (libswscale, bicubic), so that their pixels are
/// square. The middle of each pixel stays where it is in the scene, that of chroma by its siting. One thread
/// at a time; frames may outlive it.
class FrameStretcher
{
public:
    FrameStretcher(const FrameFormat &given, int width);
    const FrameFormat &format() const { return m_frames.format(); } ///< of stretched frames
    /// A frame of the format that was given; index and time stay.
    Frame stretched(const Frame &frame) const;

private:
    struct Free
    {
        void operator()(SwsContext *scaler) const;
    };
    FramePool m_frames;
    std::unique_ptr<SwsContext, Free> m_scaler;
};

} // namespace odo
