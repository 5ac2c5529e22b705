// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/packed_planes.h"

#include <libyuv/convert.h>
#include <libyuv/planar_functions.h>

namespace odo {

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
