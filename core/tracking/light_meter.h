// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <optional>

namespace odo {

/// How light one picture of a view is.
struct LightLevel
{
    Nanoseconds time{0};
    double level = 1;        ///< mean luma against that of the view's first picture
    double changedShare = 0; ///< of the picture: brighter than in the picture before, less what is darker; −1 to 1
};

/// Follows the light of one view from frame to frame, on some thousand luma samples of each: a lamp switched on or off
/// changes the level at once, and most of the picture with it. Of frames that hold a part of their picture the part
/// that they have in common with the one before is compared, so that where that part lies makes no difference. Costs
/// some hundredths of a millisecond a frame. Keeps a share in the last frame. One a view; one thread at a time.
class LightMeter
{
public:
    /// Every frame in order. A frame of another size, or without a part in common, is taken as light as the last.
    LightLevel measure(const Frame &frame);

private:
    std::optional<Frame> m_last;
    double m_level = 1;
};

} // namespace odo
