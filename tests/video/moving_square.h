// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <vector>

namespace odo::test {

/// When a camera takes the lines of its frames.
enum class FieldOrder { OneMoment, TopFirst, BottomFirst };

inline constexpr int squareSide = 60, squareStep = 8;

/// The square's first column at a time in frames.
inline int edgeAt(double frames)
{
    return 10 + int(squareStep * frames);
}

/// Frames of a bright square that moves to the right before a striped wall, the second field half-way to the
/// next frame.
inline std::vector<Frame> movingSquare(FieldOrder order, int count)
{
    FrameFormat format;
    format.width = 256;
    format.height = 96;
    std::vector<Frame> frames;
    for (int i = 0; i < count; ++i) {
        const auto buffer = std::make_shared<FrameBuffer>(format);
        for (int y = 0; y < format.height; ++y) {
            const bool isSecond =
                order != FieldOrder::OneMoment && (y % 2 == 0) == (order == FieldOrder::BottomFirst);
            const int left = edgeAt(i + (isSecond ? 0.5 : 0));
            for (int x = 0; x < format.width; ++x)
                buffer->yRow(y)[x] = x >= left && x < left + squareSide && y > 15 && y < 80 ? 200
                                     : y % 6 < 3                                            ? 60
                                                                                            : 90;
        }
        frames.push_back(FrameBuffer::toFrame(buffer, i, std::chrono::milliseconds(40 * i)));
    }
    return frames;
}

/// The square's first column, where all of its lines agree; else -1.
inline int leftEdge(const Frame &frame)
{
    int edge = -1;
    for (int y = 20; y < 76; ++y) {
        int x = 0;
        while (x < frame.y.width && frame.y.at(x, y) < 150)
            ++x;
        if (edge >= 0 && x != edge)
            return -1;
        edge = x;
    }
    return edge;
}

} // namespace odo::test
