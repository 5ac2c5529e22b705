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
           a.chromaShiftY == b.chromaShiftY && a.matrix == b.matrix && a.fullRange == b.fullRange;
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

FrameBuffer::FrameBuffer(const FrameFormat &format)
    : m_format(format), m_chromaWidth((format.width + (1 << format.chromaShiftX) - 1) >> format.chromaShiftX),
      m_chromaHeight((format.height + (1 << format.chromaShiftY) - 1) >> format.chromaShiftY),
      m_y(static_cast<std::size_t>(format.width) * format.height),
      m_u(static_cast<std::size_t>(m_chromaWidth) * m_chromaHeight),
      m_v(static_cast<std::size_t>(m_chromaWidth) * m_chromaHeight)
{
}

Frame FrameBuffer::toFrame(std::shared_ptr<FrameBuffer> buffer, std::int64_t index, Nanoseconds time)
{
    const FrameBuffer &b = *buffer;
    Frame frame;
    frame.format = b.m_format;
    frame.y = {b.m_y.data(), b.m_format.width, b.m_format.height, b.m_format.width};
    frame.u = {b.m_u.data(), b.m_chromaWidth, b.m_chromaHeight, b.m_chromaWidth};
    frame.v = {b.m_v.data(), b.m_chromaWidth, b.m_chromaHeight, b.m_chromaWidth};
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

} // namespace odo
