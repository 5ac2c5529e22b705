// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

namespace odo {

/// A frame turned as an EXIF orientation demands (CIPA DC-008, tag 274): 1 not at all, 2 mirrored, 3 by 180°,
/// 4 mirrored and by 180°, 5 mirrored and by 270° clockwise, 6 by 90° clockwise, 7 mirrored and by 90°, 8 by
/// 270°. Planes are copied sample by sample; chroma of an odd size is doubled first, because its samples
/// would cover other pixels. Any other number turns nothing. Any thread.
Frame turned(const Frame &frame, int orientation);

/// A frame that was turned as frame.orientation says, turned as another orientation says instead. Any thread.
Frame inOrientation(const Frame &frame, int orientation);

} // namespace odo
