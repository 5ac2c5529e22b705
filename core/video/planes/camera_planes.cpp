// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/camera_planes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <libyuv/convert.h>
#include <libyuv/planar_functions.h>

namespace odo {

namespace {

// Colour differences and the correction of luma are kept in 1/64 of a code value; the sum of (1 3 3 1)(1 3 3
// 1) over the pixels of one colour is 16, over both kinds of green 32.
constexpr int fraction = 64;
constexpr int differenceScale = fraction / 16;
// BT.601 in 1/65536: Cb and Cr of R − G and B − G, and what is missing of luma when it is R/4 + G/2 + B/4.
constexpr int blueOfRed = -11058, blueOfBlue = 32768, redOfRed = 32768, redOfBlue = -5329;
constexpr int lumaOfRed = 3211, lumaOfBlue = -8913; // 0.299 − 0.25, 0.114 − 0.25

/// Of what lies outside: the pixel that stands for it. It is of the same colour.
int mirrored(int i, int count)
{
    if (i < 0)
        i = -i;
    return i < count ? i : 2 * (count - 1) - i;
}

bool redIsRight(BayerOrder order)
{
    return order == BayerOrder::Grbg || order == BayerOrder::Bggr;
}
bool redIsBelow(BayerOrder order)
{
    return order == BayerOrder::Gbrg || order == BayerOrder::Bggr;
}

std::uint8_t toCode(int value)
{
    return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// Works row by row; keeps the sums of one row.
class BayerSplitter
{
public:
    BayerSplitter(const PlaneView &raw, BayerOrder order, FrameBuffer &frame)
        : m_raw(raw), m_order(order), m_frame(frame), m_column(static_cast<std::size_t>(raw.width) + 4),
          m_second(m_column.size()), m_cells(static_cast<std::size_t>(frame.chromaWidth()) + 2),
          m_missing(static_cast<std::size_t>(frame.chromaWidth()) *
                    static_cast<std::size_t>(frame.chromaHeight()))
    {
    }

    void splitChroma()
    {
        for (int cy = 0; cy < m_frame.chromaHeight(); ++cy)
            splitChromaRow(cy);
    }
    void smoothLuma()
    {
        for (int y = 0; y < m_raw.height; ++y)
            smoothLumaRow(y);
    }

private:
    static constexpr int margin = 2; ///< of the row of sums, on both sides

    const std::uint8_t *row(int y) const { return m_raw.row(mirrored(y, m_raw.height)); }
    void mirrorMargins(std::vector<int> &sums) const
    {
        for (const int x : {-2, -1, m_raw.width, m_raw.width + 1})
            sums[static_cast<std::size_t>(x + margin)] =
                sums[static_cast<std::size_t>(mirrored(x, m_raw.width) + margin)];
    }
    void splitChromaRow(int cy);
    void smoothLumaRow(int y);
    void gatherMissing(int y);

    const PlaneView &m_raw;
    const BayerOrder m_order;
    FrameBuffer &m_frame;
    std::vector<int> m_column, m_second; ///< weighted sums over rows, a column each
    std::vector<int>
        m_cells; ///< what luma misses in this row, in 1/256, a cell each, with one more on both sides
    std::vector<std::int16_t> m_missing; ///< of luma, in the middle of each cell
};

void BayerSplitter::splitChromaRow(int cy)
{
    const std::uint8_t *above = row(2 * cy - 1), *first = row(2 * cy), *second = row(2 * cy + 1),
                       *below = row(2 * cy + 2);
    // Rows 2cy and 2cy + 2 have the same two colours, and so have 2cy − 1 and 2cy + 1.
    for (int x = 0; x < m_raw.width; ++x) {
        m_column[static_cast<std::size_t>(x + margin)] = 3 * first[x] + below[x];
        m_second[static_cast<std::size_t>(x + margin)] = above[x] + 3 * second[x];
    }
    mirrorMargins(m_column);
    mirrorMargins(m_second);
    const std::vector<int> &withRed = redIsBelow(m_order) ? m_second : m_column,
                           &withBlue = redIsBelow(m_order) ? m_column : m_second;
    const int red = redIsRight(m_order);
    std::uint8_t *u = m_frame.uRow(cy), *v = m_frame.vRow(cy);
    for (int cx = 0; cx < m_frame.chromaWidth(); ++cx) {
        const auto left = static_cast<std::size_t>(2 * cx + margin);
        const auto even = [left](const std::vector<int> &sums) { return 3 * sums[left] + sums[left + 2]; };
        const auto odd = [left](const std::vector<int> &sums) { return sums[left - 1] + 3 * sums[left + 1]; };
        const int twiceGreen = red ? even(withRed) + odd(withBlue) : odd(withRed) + even(withBlue);
        const int redMore = (2 * (red ? odd(withRed) : even(withRed)) - twiceGreen) * differenceScale / 2;
        const int blueMore = (2 * (red ? even(withBlue) : odd(withBlue)) - twiceGreen) * differenceScale / 2;
        constexpr int shift = 22,
                      middle = (128 << shift) + (1 << (shift - 1)) - 1; // -1 keeps pure blue and red at 255
        u[cx] = toCode((blueOfRed * redMore + blueOfBlue * blueMore + middle) >> shift);
        v[cx] = toCode((redOfRed * redMore + redOfBlue * blueMore + middle) >> shift);
        m_missing[static_cast<std::size_t>(cy) * static_cast<std::size_t>(m_frame.chromaWidth()) +
                  static_cast<std::size_t>(cx)] =
            static_cast<std::int16_t>((lumaOfRed * redMore + lumaOfBlue * blueMore + (1 << 15)) >> 16);
    }
}

/// What luma misses lies in the middle of the cells: between them in proportion, a quarter and three quarters
/// of the way.
void BayerSplitter::gatherMissing(int y)
{
    const int width = m_frame.chromaWidth(), last = m_frame.chromaHeight() - 1;
    const int near = y / 2, far = std::clamp(y % 2 == 0 ? near - 1 : near + 1, 0, last);
    const std::int16_t *nearRow = m_missing.data() + static_cast<std::ptrdiff_t>(near) * width;
    const std::int16_t *farRow = m_missing.data() + static_cast<std::ptrdiff_t>(far) * width;
    for (int cx = 0; cx < width; ++cx)
        m_cells[static_cast<std::size_t>(cx) + 1] = 3 * nearRow[cx] + farRow[cx];
    m_cells.front() = m_cells[1];
    m_cells.back() = m_cells[static_cast<std::size_t>(width)];
}

void BayerSplitter::smoothLumaRow(int y)
{
    const std::uint8_t *above = row(y - 1), *at = row(y), *below = row(y + 1);
    for (int x = 0; x < m_raw.width; ++x)
        m_column[static_cast<std::size_t>(x + margin)] = above[x] + 2 * at[x] + below[x];
    mirrorMargins(m_column);
    gatherMissing(y);
    std::uint8_t *luma = m_frame.yRow(y);
    const int *sums = m_column.data() + margin, *cells = m_cells.data() + 1;
    // Sixteenths of the smoothed image in 1/1024, and of the correction likewise.
    constexpr int half = 512, shift = 10;
    for (int x = 0; x < m_raw.width; ++x) {
        const int cx = x / 2, missing = 3 * cells[cx] + cells[x % 2 == 0 ? cx - 1 : cx + 1];
        luma[x] = toCode((fraction * (sums[x - 1] + 2 * sums[x] + sums[x + 1]) + missing + half) >> shift);
    }
}

} // namespace

Frame bayerPlanes(const PlaneView &raw, BayerOrder order, std::int64_t index, Nanoseconds time)
{
    assert(raw.width >= 2 && raw.height >= 2);
    FrameFormat format;
    format.width = raw.width;
    format.height = raw.height;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    auto frame = std::make_shared<FrameBuffer>(format);
    BayerSplitter splitter(raw, order, *frame);
    splitter.splitChroma();
    splitter.smoothLuma();
    return FrameBuffer::toFrame(std::move(frame), index, time);
}

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

Block blockAt(const RgbView &image, int cx, int cy, int redAt)
{
    Block sum{0, 0, 0};
    for (const int y : {2 * cy, std::min(2 * cy + 1, image.height - 1)}) {
        for (const int x : {2 * cx, std::min(2 * cx + 1, image.width - 1)}) {
            const std::uint8_t *pixel = image.data + y * image.stride + std::ptrdiff_t{3} * x;
            sum.red += pixel[redAt];
            sum.green += pixel[1];
            sum.blue += pixel[2 - redAt];
        }
    }
    return sum;
}

} // namespace

Frame rgbPlanes(const RgbView &image, std::int64_t index, Nanoseconds time)
{
    auto frame = std::make_shared<FrameBuffer>(formatOf(image.width, image.height));
    const int redAt = image.order == RgbView::Order::Rgb ? 0 : 2;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t *pixel = image.data + y * image.stride;
        std::uint8_t *luma = frame->yRow(y);
        for (int x = 0; x < image.width; ++x, pixel += 3)
            luma[x] = static_cast<std::uint8_t>(
                (19595 * pixel[redAt] + 38470 * pixel[1] + 7471 * pixel[2 - redAt] + (1 << 15)) >> 16);
    }
    constexpr int shift = 18,
                  middle = (128 << shift) + (1 << (shift - 1)) - 1; // -1 keeps pure blue and red at 255
    for (int cy = 0; cy < frame->chromaHeight(); ++cy) {
        std::uint8_t *u = frame->uRow(cy), *v = frame->vRow(cy);
        for (int cx = 0; cx < frame->chromaWidth(); ++cx) {
            const Block sum = blockAt(image, cx, cy, redAt);
            u[cx] = static_cast<std::uint8_t>(
                (-11059 * sum.red - 21709 * sum.green + 32768 * sum.blue + middle) >> shift);
            v[cx] = static_cast<std::uint8_t>(
                (32768 * sum.red - 27439 * sum.green - 5329 * sum.blue + middle) >> shift);
        }
    }
    return FrameBuffer::toFrame(std::move(frame), index, time);
}

Frame monoPlanes(const PlaneView &image, std::int64_t index, Nanoseconds time)
{
    auto frame = std::make_shared<FrameBuffer>(formatOf(image.width, image.height));
    for (int y = 0; y < image.height; ++y)
        std::copy_n(image.row(y), image.width, frame->yRow(y));
    for (int cy = 0; cy < frame->chromaHeight(); ++cy) {
        std::fill_n(frame->uRow(cy), frame->chromaWidth(), std::uint8_t{128});
        std::fill_n(frame->vRow(cy), frame->chromaWidth(), std::uint8_t{128});
    }
    return FrameBuffer::toFrame(std::move(frame), index, time);
}

namespace {

FrameFormat formatOf(const PackedFormat &packed)
{
    FrameFormat format;
    format.width = packed.width;
    format.height = packed.height;
    format.chromaShiftX = 1;
    format.chromaShiftY = packed.layout == PackedLayout::Nv12 ? 1 : 0;
    format.siting = ChromaSiting::Center;
    format.matrix = packed.matrix;
    format.fullRange = packed.fullRange;
    return format;
}

std::size_t product(int a, int b)
{
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

std::size_t planeBytes(const FrameFormat &format)
{
    const int chromaWidth = (format.width + 1) / 2,
              chromaHeight = (format.height + (1 << format.chromaShiftY) - 1) >> format.chromaShiftY;
    return product(format.width, format.height) + 2 * product(chromaWidth, chromaHeight);
}

} // namespace

PackedPlanes::PackedPlanes(const PackedFormat &format)
    : m_packed(format), m_format(formatOf(format)), m_chromaWidth((m_format.width + 1) / 2),
      m_chromaHeight((m_format.height + (1 << m_format.chromaShiftY) - 1) >> m_format.chromaShiftY),
      m_pool(planeBytes(m_format))
{
}

std::size_t PackedPlanes::packedBytes() const
{
    const int rows =
        m_packed.layout == PackedLayout::Nv12 ? m_packed.height + m_chromaHeight : m_packed.height;
    return product(m_packed.stride, rows);
}

std::size_t PackedPlanes::lumaBytes() const
{
    return product(m_format.width, m_format.height);
}

void PackedPlanes::split(const std::uint8_t *packed, std::uint8_t *y, std::uint8_t *u, std::uint8_t *v) const
{
    const int width = m_packed.width, height = m_packed.height, stride = m_packed.stride;
    switch (m_packed.layout) {
    case PackedLayout::Yuyv:
        libyuv::YUY2ToI422(packed, stride, y, width, u, m_chromaWidth, v, m_chromaWidth, width, height);
        break;
    case PackedLayout::Uyvy:
        libyuv::UYVYToI422(packed, stride, y, width, u, m_chromaWidth, v, m_chromaWidth, width, height);
        break;
    case PackedLayout::Nv12:
        libyuv::CopyPlane(packed, stride, y, width, width, height);
        libyuv::SplitUVPlane(packed + product(stride, height), stride, u, m_chromaWidth, v, m_chromaWidth,
                             m_chromaWidth, m_chromaHeight);
        break;
    }
}

std::optional<Frame> PackedPlanes::toPlanes(std::span<const std::uint8_t> packed) const
{
    if (packed.size() < packedBytes())
        return std::nullopt;
    const std::shared_ptr<std::uint8_t[]> memory = m_pool.take();
    std::uint8_t *y = memory.get(), *u = y + lumaBytes(), *v = u + product(m_chromaWidth, m_chromaHeight);
    split(packed.data(), y, u, v);
    Frame frame;
    frame.format = m_format;
    frame.y = {y, m_format.width, m_format.height, m_format.width};
    frame.u = {u, m_chromaWidth, m_chromaHeight, m_chromaWidth};
    frame.v = {v, m_chromaWidth, m_chromaHeight, m_chromaWidth};
    frame.owner = memory;
    return frame;
}

} // namespace odo
