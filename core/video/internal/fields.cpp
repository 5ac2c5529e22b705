// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/fields.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace odo {

namespace {

/// One plane of a field; row: gives the memory of a line.
template <class Row>
void fillPlane(const PlaneView &from, int firstKept, const Row &row)
{
    const auto bytes = static_cast<std::size_t>(from.width);
    for (int y = firstKept; y < from.height; y += 2)
        std::memcpy(row(y), from.row(y), bytes);
    for (int y = 1 - firstKept; y < from.height; y += 2) {
        const int above = y > 0 ? y - 1 : y + 1, below = y + 1 < from.height ? y + 1 : y - 1;
        if (above >= from.height || below < 0)
            continue; // a single line
        const std::span before(from.row(above), bytes), behind(from.row(below), bytes);
        std::ranges::transform(before, behind, row(y), [](std::uint8_t a, std::uint8_t b) {
            return static_cast<std::uint8_t>((a + b + 1) / 2);
        });
    }
}

} // namespace

Field firstFieldOf(const AVFrame &avFrame, AVFieldOrder ofStream)
{
    if (avFrame.interlaced_frame != 0)
        return avFrame.top_field_first != 0 ? Field::Top : Field::Bottom;
    // libav's programs write these two of a mixed order for the order of display alone
    return ofStream == AV_FIELD_BB || ofStream == AV_FIELD_BT ? Field::Bottom : Field::Top;
}

Frame fieldOf(const Frame &frame, Field field)
{
    const auto buffer = std::make_shared<FrameBuffer>(frame.format);
    const int firstKept = field == Field::Top ? 0 : 1;
    fillPlane(frame.y, firstKept, [&](int y) { return buffer->yRow(y); });
    fillPlane(frame.u, firstKept, [&](int y) { return buffer->uRow(y); });
    fillPlane(frame.v, firstKept, [&](int y) { return buffer->vRow(y); });
    return FrameBuffer::toFrame(buffer, frame.index, frame.time);
}

} // namespace odo
