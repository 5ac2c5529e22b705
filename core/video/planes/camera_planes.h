// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <optional>
#include <span>

namespace odo {

/// The colours of a raw sensor's top-left 2×2 cell: its first row, then its second.
enum class BayerOrder { Rggb, Grbg, Gbrg, Bggr };

/// Planes of a raw Bayer image without guessing the missing colours: luma at full size, U and V once a 2×2
/// cell; full range, BT.601, siting Center.
///
/// Luma is the raw image smoothed by (1 2 1)/4 both ways, which removes the colour pattern wherever it
/// lies and leaves R/4 + G/2 + B/4 at its position (Alleysson, Süsstrunk and Hérault 2005, "Linear
/// demosaicing inspired by the human visual system", eq. 5), plus what BT.601 weighs otherwise, from the
/// colour differences of the cells around. These are taken from the 4×4 pixels about the middle of a cell,
/// weighed (1 3 3 1)/8 both ways: of each colour alone these weights have their centre there and the same
/// spread, so that red, green and blue of an edge coincide. Beyond the border the image is mirrored at its
/// outermost pixels, which keeps the colours' order.
///
/// raw: at least 2×2, any stride. Any thread.
Frame bayerPlanes(const PlaneView &raw, BayerOrder order, std::int64_t index, Nanoseconds time);

/// A look at rows of packed colours of 8 bits, three bytes a pixel.
struct RgbView
{
    enum class Order { Rgb, Bgr };
    const std::uint8_t *data = nullptr;
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0; ///< bytes from one row to the next
    Order order = Order::Rgb;
};

/// Planes of an image of packed colours: luma at full size, U and V the mean of each 2×2 pixels, so that
/// they lie in their middle (siting Center; of an odd last column or row, of what there is); full range,
/// BT.601 as JFIF 1.02 defines it. Any thread.
Frame rgbPlanes(const RgbView &image, std::int64_t index, Nanoseconds time);

/// Planes of an image without colours: luma as it is, no chroma (128, 4:2:0); full range. Any thread.
Frame monoPlanes(const PlaneView &image, std::int64_t index, Nanoseconds time);

/// The memory layout of luma and chroma. Yuyv, Uyvy: 4:2:2, samples in the order of the name. Nv12:
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

/// Takes images of one packed format apart into planes (libyuv). Chroma lies midway between the luma
/// samples it belongs to, which is where the V4L2 interface puts it ("Color Sample Location"). Any thread,
/// one at a time.
class PackedPlanes
{
public:
    explicit PackedPlanes(const PackedFormat &format);
    /// Index and time are left as they are. nullopt when there are fewer bytes than an image has.
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
