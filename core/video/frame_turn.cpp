// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_turn.h"

#include <libyuv/planar_functions.h>
#include <libyuv/rotate.h>
#include <utility>

namespace odo {

namespace {

/// First mirrored left to right, then turned clockwise.
struct Turn
{
    bool isMirrored = false;
    libyuv::RotationMode mode = libyuv::kRotate0;
};

Turn turnOf(int orientation)
{
    constexpr Turn turns[] = {{false, libyuv::kRotate0},   {true, libyuv::kRotate0},
                              {false, libyuv::kRotate180}, {true, libyuv::kRotate180},
                              {true, libyuv::kRotate270},  {false, libyuv::kRotate90},
                              {true, libyuv::kRotate90},   {false, libyuv::kRotate270}};
    return orientation >= 1 && orientation <= 8 ? turns[orientation - 1] : turns[0];
}

bool swapsSides(const Turn &turn)
{
    return turn.mode == libyuv::kRotate90 || turn.mode == libyuv::kRotate270;
}

void turnPlane(const PlaneView &plane, const Turn &turn, std::uint8_t *to, int toStride)
{
    PlaneView from = plane;
    std::vector<std::uint8_t> mirrored;
    if (turn.isMirrored) {
        mirrored.resize(std::size_t(plane.width) * std::size_t(plane.height));
        libyuv::MirrorPlane(plane.data, int(plane.stride), mirrored.data(), plane.width, plane.width,
                            plane.height);
        from = {mirrored.data(), plane.width, plane.height, plane.width};
    }
    libyuv::RotatePlane(from.data, int(from.stride), to, toStride, from.width, from.height, turn.mode);
}

/// Each chroma sample at all the pixels that it covers.
Frame withChromaAtEachPixel(const Frame &frame)
{
    FrameFormat format = frame.format;
    format.chromaShiftX = format.chromaShiftY = 0;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < format.height; ++y) {
        std::copy_n(frame.y.row(y), format.width, buffer->yRow(y));
        const int chromaRow = y >> frame.format.chromaShiftY;
        for (int x = 0; x < format.width; ++x) {
            buffer->uRow(y)[x] = frame.u.at(x >> frame.format.chromaShiftX, chromaRow);
            buffer->vRow(y)[x] = frame.v.at(x >> frame.format.chromaShiftX, chromaRow);
        }
    }
    return FrameBuffer::toFrame(std::move(buffer), frame.index, frame.time);
}

} // namespace

Frame turned(const Frame &frame, int orientation)
{
    const Turn turn = turnOf(orientation);
    if (!turn.isMirrored && turn.mode == libyuv::kRotate0)
        return frame;
    const FrameFormat &given = frame.format;
    if ((given.chromaShiftX == 1 && given.width % 2 != 0) ||
        (given.chromaShiftY == 1 && given.height % 2 != 0))
        return turned(withChromaAtEachPixel(frame), orientation);
    FrameFormat format = given;
    if (swapsSides(turn)) {
        std::swap(format.width, format.height);
        std::swap(format.chromaShiftX, format.chromaShiftY);
    }
    auto buffer = std::make_shared<FrameBuffer>(format);
    turnPlane(frame.y, turn, buffer->yRow(0), format.width);
    turnPlane(frame.u, turn, buffer->uRow(0), buffer->chromaWidth());
    turnPlane(frame.v, turn, buffer->vRow(0), buffer->chromaWidth());
    Frame result = FrameBuffer::toFrame(std::move(buffer), frame.index, frame.time);
    result.orientation = orientation;
    return result;
}

Frame inOrientation(const Frame &frame, int orientation)
{
    if (frame.orientation == orientation)
        return frame;
    // a quarter turn is undone by the opposite one, everything else by itself
    const int back = frame.orientation == 6 ? 8 : frame.orientation == 8 ? 6 : frame.orientation;
    Frame result = turned(turned(frame, back), orientation);
    result.orientation = orientation;
    return result;
}

} // namespace odo
