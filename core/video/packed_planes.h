// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"
#include "core/video/plane_pool.h"

#include <optional>
#include <span>

namespace odo {

/// How a camera lays luma and chroma into memory. Yuyv, Uyvy: 4:2:2, samples in the order of the name. Nv12:
/// 4:2:0, a plane of luma, then one of U and V in turn.
enum class PackedLayout { Yuyv, Uyvy, Nv12 };

struct PackedFormat
{
    PackedLayout layout = PackedLayout::Yuyv;
    int width = 0, height = 0;
    int stride = 0; ///< bytes from one row to the next, also of Nv12's chroma
    YuvMatrix matrix = YuvMatrix::Bt601;
    bool fullRange = false;
};

/// Takes pictures of one packed format apart into planes (libyuv). Chroma lies midway between the luma
/// samples it belongs to, which is where the V4L2 interface puts it ("Color Sample Location"). Any thread,
/// one at a time.
class PackedPlanes
{
public:
    explicit PackedPlanes(const PackedFormat &format);
    /// Index and time are left as they are. nullopt when there are fewer bytes than a picture has.
    std::optional<Frame> toPlanes(std::span<const std::uint8_t> packed) const;

private:
    std::size_t packedBytes() const;
    std::size_t lumaBytes() const;
    void split(const std::uint8_t *packed, std::uint8_t *y, std::uint8_t *u, std::uint8_t *v) const;

    const PackedFormat m_packed;
    FrameFormat m_format;
    int m_chromaWidth = 0, m_chromaHeight = 0;
    mutable PlanePool m_pool;
};

} // namespace odo
