// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame.h"

#include <mutex>
#include <vector>

namespace odo {

Result<Frame> wholeFrame(const Frame &frame)
{
    if (!frame.validRegion)
        return frame;
    auto whole = frame.coded->decodeWhole();
    if (whole) {
        whole->index = frame.index;
        whole->time = frame.time;
    }
    return whole;
}

bool sameLayout(const FrameFormat &a, const FrameFormat &b)
{
    return a.width == b.width && a.height == b.height && a.chromaShiftX == b.chromaShiftX &&
           a.chromaShiftY == b.chromaShiftY && a.matrix == b.matrix && a.fullRange == b.fullRange &&
           a.transfer == b.transfer;
}

double FrameFormat::chromaOffsetX() const
{
    using enum ChromaSiting;
    if (chromaShiftX == 0)
        return 0.0;
    if (siting == Center || siting == Top || siting == Bottom)
        return 0.5;
    return siting == Right || siting == TopRight || siting == BottomRight ? 1.0 : 0.0;
}

double FrameFormat::chromaOffsetY() const
{
    using enum ChromaSiting;
    if (chromaShiftY == 0 || siting == TopLeft || siting == Top || siting == TopRight)
        return 0.0;
    return siting == BottomLeft || siting == Bottom || siting == BottomRight ? 1.0 : 0.5;
}

namespace {

std::size_t lumaBytes(const FrameFormat &format)
{
    return static_cast<std::size_t>(format.width) * static_cast<std::size_t>(format.height);
}

std::size_t chromaBytes(const FrameFormat &format)
{
    return static_cast<std::size_t>(format.chromaWidth()) * static_cast<std::size_t>(format.chromaHeight());
}

/// Planes of a format whose rows have no padding.
Frame frameOver(const FrameFormat &format, const std::uint8_t *y, const std::uint8_t *u,
                const std::uint8_t *v)
{
    const int width = format.chromaWidth(), height = format.chromaHeight();
    Frame frame;
    frame.format = format;
    frame.y = {y, format.width, format.height, format.width};
    frame.u = {u, width, height, width};
    frame.v = {v, width, height, width};
    return frame;
}

} // namespace

FrameBuffer::FrameBuffer(const FrameFormat &format)
    : m_format(format), m_chromaWidth(format.chromaWidth()), m_y(lumaBytes(format)), m_u(chromaBytes(format)),
      m_v(chromaBytes(format))
{
}

Frame FrameBuffer::toFrame(std::shared_ptr<FrameBuffer> buffer, std::int64_t index, Nanoseconds time)
{
    const FrameBuffer &b = *buffer;
    Frame frame = frameOver(b.m_format, b.m_y.data(), b.m_u.data(), b.m_v.data());
    frame.index = index;
    frame.time = time;
    frame.owner = std::move(buffer);
    return frame;
}

struct PlanePool::Shelf
{
    explicit Shelf(std::size_t size) : bytes(size) {}
    const std::size_t bytes;
    std::mutex mutex;
    std::vector<std::unique_ptr<std::uint8_t[]>> free; ///< never more than were in use at once
};

PlanePool::PlanePool(std::size_t bytes) : m_shelf(std::make_shared<Shelf>(bytes)) {}

std::shared_ptr<std::uint8_t[]> PlanePool::take() const
{
    std::unique_ptr<std::uint8_t[]> memory;
    {
        const std::lock_guard lock(m_shelf->mutex);
        if (!m_shelf->free.empty()) {
            memory = std::move(m_shelf->free.back());
            m_shelf->free.pop_back();
        }
    }
    if (!memory)
        memory = std::make_unique<std::uint8_t[]>(m_shelf->bytes);
    return {memory.release(), [shelf = m_shelf](std::uint8_t *back) {
                std::unique_ptr<std::uint8_t[]> returned(back);
                const std::lock_guard lock(shelf->mutex);
                shelf->free.push_back(std::move(returned));
            }};
}

FramePool::FramePool(const FrameFormat &format)
    : m_format(format), m_pool(lumaBytes(format) + 2 * chromaBytes(format))
{
}

FramePool::Blank FramePool::take() const
{
    const std::shared_ptr<std::uint8_t[]> memory = m_pool.take();
    std::uint8_t *y = memory.get(), *u = y + lumaBytes(m_format), *v = u + chromaBytes(m_format);
    Blank blank{frameOver(m_format, y, u, v), y, u, v};
    blank.frame.owner = memory;
    return blank;
}

} // namespace odo
