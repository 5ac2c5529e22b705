// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/rgb_planes.h"

#include <algorithm>

namespace odo {

namespace {

FrameFormat formatOf(int width, int height)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

/// Sums of four pixels of each colour.
struct Block
{
    int red, green, blue;
};

Block blockAt(const RgbView &picture, int cx, int cy, int redAt)
{
    Block sum{0, 0, 0};
    for (const int y : {2 * cy, std::min(2 * cy + 1, picture.height - 1)}) {
        for (const int x : {2 * cx, std::min(2 * cx + 1, picture.width - 1)}) {
            const std::uint8_t *pixel = picture.data + y * picture.stride + std::ptrdiff_t{3} * x;
            sum.red += pixel[redAt];
            sum.green += pixel[1];
            sum.blue += pixel[2 - redAt];
        }
    }
    return sum;
}

} // namespace

Frame rgbPlanes(const RgbView &picture, std::int64_t index, Nanoseconds time)
{
    auto frame = std::make_shared<FrameBuffer>(formatOf(picture.width, picture.height));
    const int redAt = picture.order == RgbView::Order::Rgb ? 0 : 2;
    for (int y = 0; y < picture.height; ++y) {
        const std::uint8_t *pixel = picture.data + y * picture.stride;
        std::uint8_t *luma = frame->yRow(y);
        for (int x = 0; x < picture.width; ++x, pixel += 3)
            luma[x] = static_cast<std::uint8_t>(
                (19595 * pixel[redAt] + 38470 * pixel[1] + 7471 * pixel[2 - redAt] + (1 << 15)) >> 16);
    }
    constexpr int shift = 18,
                  middle = (128 << shift) + (1 << (shift - 1)) - 1; // -1 keeps pure blue and red at 255
    for (int cy = 0; cy < frame->chromaHeight(); ++cy) {
        std::uint8_t *u = frame->uRow(cy), *v = frame->vRow(cy);
        for (int cx = 0; cx < frame->chromaWidth(); ++cx) {
            const Block sum = blockAt(picture, cx, cy, redAt);
            u[cx] = static_cast<std::uint8_t>(
                (-11059 * sum.red - 21709 * sum.green + 32768 * sum.blue + middle) >> shift);
            v[cx] = static_cast<std::uint8_t>(
                (32768 * sum.red - 27439 * sum.green - 5329 * sum.blue + middle) >> shift);
        }
    }
    return FrameBuffer::toFrame(std::move(frame), index, time);
}

Frame monoPlanes(const PlaneView &picture, std::int64_t index, Nanoseconds time)
{
    auto frame = std::make_shared<FrameBuffer>(formatOf(picture.width, picture.height));
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.row(y), picture.width, frame->yRow(y));
    for (int cy = 0; cy < frame->chromaHeight(); ++cy) {
        std::fill_n(frame->uRow(cy), frame->chromaWidth(), std::uint8_t{128});
        std::fill_n(frame->vRow(cy), frame->chromaWidth(), std::uint8_t{128});
    }
    return FrameBuffer::toFrame(std::move(frame), index, time);
}

} // namespace odo
