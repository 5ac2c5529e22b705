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

bool turnsNothing(const Turn &turn)
{
    return !turn.isMirrored && turn.mode == libyuv::kRotate0;
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

bool hasOddChroma(const FrameFormat &format)
{
    return (format.chromaShiftX == 1 && format.width % 2 != 0) ||
           (format.chromaShiftY == 1 && format.height % 2 != 0);
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

/// The siting with these offsets (FrameFormat::chromaOffsetX).
ChromaSiting sitingAt(double x, double y)
{
    using enum ChromaSiting;
    constexpr ChromaSiting sitings[3][3] = {
        {TopLeft, Top, TopRight}, {Left, Center, Right}, {BottomLeft, Bottom, BottomRight}};
    return sitings[std::size_t(2 * y)][std::size_t(2 * x)];
}

/// Of chroma whose columns and rows are all whole. Siting that is not stated is turned as what it is taken
/// for.
ChromaSiting turnedSiting(const FrameFormat &format, const Turn &turn)
{
    if (format.chromaShiftX == 0 && format.chromaShiftY == 0)
        return format.siting;
    double x = format.chromaShiftX != 0 ? format.chromaOffsetX() : 0.5,
           y = format.chromaShiftY != 0 ? format.chromaOffsetY() : 0.5;
    if (turn.isMirrored)
        x = 1 - x;
    switch (turn.mode) {
    case libyuv::kRotate90:
        return sitingAt(1 - y, x);
    case libyuv::kRotate180:
        return sitingAt(1 - x, 1 - y);
    case libyuv::kRotate270:
        return sitingAt(y, 1 - x);
    default:
        return sitingAt(x, y);
    }
}

} // namespace

FrameFormat turnedFormat(const FrameFormat &given, int orientation)
{
    const Turn turn = turnOf(orientation);
    FrameFormat format = given;
    if (turnsNothing(turn))
        return format;
    if (hasOddChroma(format))
        format.chromaShiftX = format.chromaShiftY = 0;
    format.siting = turnedSiting(format, turn);
    if (turn.mode == libyuv::kRotate90 || turn.mode == libyuv::kRotate270) {
        std::swap(format.width, format.height);
        std::swap(format.chromaShiftX, format.chromaShiftY);
    }
    return format;
}

FrameTurner::FrameTurner(const FrameFormat &format, int orientation)
    : m_orientation(orientation), m_frames(turnedFormat(format, orientation))
{
}

Frame FrameTurner::turned(const Frame &given) const
{
    const Turn turn = turnOf(m_orientation);
    if (turnsNothing(turn))
        return given;
    const Frame frame = hasOddChroma(given.format) ? withChromaAtEachPixel(given) : given;
    auto [result, y, u, v] = m_frames.take();
    turnPlane(frame.y, turn, y, result.y.width);
    turnPlane(frame.u, turn, u, result.u.width);
    turnPlane(frame.v, turn, v, result.v.width);
    result.index = given.index;
    result.time = given.time;
    result.orientation = m_orientation;
    return result;
}

Frame turned(const Frame &frame, int orientation)
{
    return FrameTurner(frame.format, orientation).turned(frame);
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

int clockwiseDegreesOf(int orientation)
{
    return int(turnOf(orientation).mode); // libyuv names them by their degrees
}

bool isMirroring(int orientation)
{
    return turnOf(orientation).isMirrored;
}

} // namespace odo
