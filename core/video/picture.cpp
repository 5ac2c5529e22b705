// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture.h"

#include <libyuv/convert_argb.h>
#include <libyuv/convert_from_argb.h>
#include <libyuv/scale.h>

#include <vector>

namespace odo {

namespace {

/// Every n-th sample of sides that are longer than libyuv's places of 16.16 bits can count. No file is read
/// with such sides, but nothing keeps a camera from having them.
PlaneView thinned(const PlaneView &plane, std::vector<std::uint8_t> &samples)
{
    constexpr int longestSide = 32767;
    const int stepX = 1 + (plane.width - 1) / longestSide, stepY = 1 + (plane.height - 1) / longestSide;
    if (stepX == 1 && stepY == 1)
        return plane;
    const int width = plane.width / stepX, height = plane.height / stepY;
    samples.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            samples.push_back(plane.at(x * stepX, y * stepY));
    return {samples.data(), width, height, width};
}

/// A plane scaled to a size, or the plane itself where it has that size already.
struct ScaledPlane
{
    ScaledPlane(const PlaneView &whole, int width, int height)
    {
        if (whole.width == width && whole.height == height) {
            view = whole;
            return;
        }
        std::vector<std::uint8_t> samples;
        const PlaneView plane = thinned(whole, samples);
        memory = std::make_unique_for_overwrite<std::uint8_t[]>(static_cast<std::size_t>(width) *
                                                                static_cast<std::size_t>(height));
        // Bilinear keeps things within half a pixel of their place; over more than two source pixels it would
        // skip some and shimmer, there the average is better.
        const bool shrinksMuch = plane.width > 2 * width || plane.height > 2 * height;
        libyuv::ScalePlane(plane.data, static_cast<int>(plane.stride), plane.width, plane.height,
                           memory.get(), width, width, height,
                           shrinksMuch ? libyuv::kFilterBox : libyuv::kFilterBilinear);
        view = {memory.get(), width, height, width};
    }
    std::unique_ptr<std::uint8_t[]> memory;
    PlaneView view;
};

const libyuv::YuvConstants *matrixOf(const FrameFormat &format)
{
    if (format.matrix == YuvMatrix::Bt709)
        return format.fullRange ? &libyuv::kYuvF709Constants : &libyuv::kYuvH709Constants;
    return format.fullRange ? &libyuv::kYuvJPEGConstants : &libyuv::kYuvI601Constants;
}

} // namespace

ScreenPicture toScreen(const Frame &frame, int width, int height)
{
    ScreenPicture picture;
    if (width <= 0 || height <= 0 || frame.y.data == nullptr)
        return picture;
    picture.width = width;
    picture.height = height;
    picture.pixels = std::make_unique_for_overwrite<std::uint32_t[]>(static_cast<std::size_t>(width) *
                                                                     static_cast<std::size_t>(height));
    auto *to = reinterpret_cast<std::uint8_t *>(picture.pixels.get());
    const bool halved = frame.format.chromaShiftX == 1 && frame.format.chromaShiftY == 1;
    const int chromaWidth = halved ? (width + 1) / 2 : width,
              chromaHeight = halved ? (height + 1) / 2 : height;
    const ScaledPlane y(frame.y, width, height);
    const ScaledPlane u(frame.u, chromaWidth, chromaHeight), v(frame.v, chromaWidth, chromaHeight);
    const auto convert = halved ? libyuv::I420ToARGBMatrix : libyuv::I444ToARGBMatrix;
    convert(y.view.data, static_cast<int>(y.view.stride), u.view.data, static_cast<int>(u.view.stride),
            v.view.data, static_cast<int>(v.view.stride), to, width * 4, matrixOf(frame.format), width,
            height);
    return picture;
}

Frame fromScreen(const std::uint32_t *pixels, int width, int height, std::ptrdiff_t strideBytes,
                 Nanoseconds time)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.siting = ChromaSiting::Center; // libyuv takes the mean of four pixels
    auto buffer = std::make_shared<FrameBuffer>(format);
    libyuv::ARGBToI420(reinterpret_cast<const std::uint8_t *>(pixels), static_cast<int>(strideBytes),
                       buffer->yRow(0), width, buffer->uRow(0), buffer->chromaWidth(), buffer->vRow(0),
                       buffer->chromaWidth(), width, height);
    return FrameBuffer::toFrame(std::move(buffer), 0, time);
}

} // namespace odo
