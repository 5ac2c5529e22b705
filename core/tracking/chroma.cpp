// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// Shares of red and blue in luma, and the code values of chroma for a whole one.
struct Coding
{
    double kr, kb, range;

    explicit Coding(const FrameFormat &format)
        : kr(format.matrix == YuvMatrix::Bt709 ? 0.2126 : 0.299),
          kb(format.matrix == YuvMatrix::Bt709 ? 0.0722 : 0.114),
          range(format.fullRange ? 1.0 : 224.0 / 255.0)
    {
    }
};

} // namespace

Chroma chromaOf(RgbColour colour, const FrameFormat &format)
{
    const auto [kr, kb, range] = Coding(format);
    const double luma = kr * colour.red + (1 - kr - kb) * colour.green + kb * colour.blue;
    return {range * (colour.blue - luma) / (2 * (1 - kb)), range * (colour.red - luma) / (2 * (1 - kr))};
}

RgbColour colourOf(double luma, const Chroma &chroma, const FrameFormat &format)
{
    const auto [kr, kb, range] = Coding(format);
    const double y = format.fullRange ? luma : (luma - 16) * 255.0 / 219.0;
    const double blue = y + 2 * (1 - kb) * chroma.x() / range, red = y + 2 * (1 - kr) * chroma.y() / range;
    const double green = (y - kr * red - kb * blue) / (1 - kr - kb);
    const auto channel = [](double value) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    return {channel(red), channel(green), channel(blue)};
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
