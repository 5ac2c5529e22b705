// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma.h"

#include <algorithm>

namespace odo {

Chroma chromaOf(RgbColour colour, const FrameFormat &format)
{
    const bool bt709 = format.matrix == YuvMatrix::Bt709;
    const double kr = bt709 ? 0.2126 : 0.299;
    const double kb = bt709 ? 0.0722 : 0.114;
    const double luma = kr * colour.red + (1 - kr - kb) * colour.green + kb * colour.blue;
    const double range = format.fullRange ? 1.0 : 224.0 / 255.0;
    return {range * (colour.blue - luma) / (2 * (1 - kb)), range * (colour.red - luma) / (2 * (1 - kr))};
}

ChromaRect ChromaRect::grownBy(int samples) const
{
    return {left - samples, top - samples, right + samples, bottom + samples};
}

ChromaRect ChromaRect::clippedTo(const ChromaRect &other) const
{
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

ChromaGrid::ChromaGrid(const Frame &frame)
    : u(frame.u), v(frame.v), scale(1 << frame.format.chromaShiftX, 1 << frame.format.chromaShiftY),
      offset(frame.format.chromaOffsetX(), frame.format.chromaOffsetY())
{
}

} // namespace odo
