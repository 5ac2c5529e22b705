// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_pictures.h"

#include "core/video/camera_planes.h"
#include "core/video/jpeg.h"

#include <algorithm>
#include <array>
#include <linux/videodev2.h>

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// In the order of preference: coded pictures leave room on the bus for a second camera, grey ones have no
/// colour to track.
constexpr std::array<std::uint32_t, 12> readable{
    V4L2_PIX_FMT_MJPEG,  V4L2_PIX_FMT_JPEG,   V4L2_PIX_FMT_YUYV,   V4L2_PIX_FMT_UYVY,
    V4L2_PIX_FMT_NV12,   V4L2_PIX_FMT_RGB24,  V4L2_PIX_FMT_BGR24,  V4L2_PIX_FMT_SRGGB8,
    V4L2_PIX_FMT_SGRBG8, V4L2_PIX_FMT_SGBRG8, V4L2_PIX_FMT_SBGGR8, V4L2_PIX_FMT_GREY};

std::optional<PackedLayout> packedLayout(std::uint32_t fourcc)
{
    switch (fourcc) {
    case V4L2_PIX_FMT_YUYV:
        return PackedLayout::Yuyv;
    case V4L2_PIX_FMT_UYVY:
        return PackedLayout::Uyvy;
    case V4L2_PIX_FMT_NV12:
        return PackedLayout::Nv12;
    default:
        return std::nullopt;
    }
}

std::optional<BayerOrder> bayerOrder(std::uint32_t fourcc)
{
    switch (fourcc) {
    case V4L2_PIX_FMT_SRGGB8:
        return BayerOrder::Rggb;
    case V4L2_PIX_FMT_SGRBG8:
        return BayerOrder::Grbg;
    case V4L2_PIX_FMT_SGBRG8:
        return BayerOrder::Gbrg;
    case V4L2_PIX_FMT_SBGGR8:
        return BayerOrder::Bggr;
    default:
        return std::nullopt;
    }
}

/// What the driver leaves open follows from the colour space, by the rules of the interface.
PackedFormat packedFormat(const v4l2_pix_format &format, PackedLayout layout)
{
    const __u32 encoding = format.ycbcr_enc != V4L2_YCBCR_ENC_DEFAULT
                               ? format.ycbcr_enc
                               : __u32(V4L2_MAP_YCBCR_ENC_DEFAULT(format.colorspace));
    const __u32 quantization = format.quantization != V4L2_QUANTIZATION_DEFAULT
                                   ? format.quantization
                                   : __u32(V4L2_MAP_QUANTIZATION_DEFAULT(false, format.colorspace, encoding));
    PackedFormat packed{layout, static_cast<int>(format.width), static_cast<int>(format.height),
                        static_cast<int>(format.bytesperline)};
    packed.matrix = encoding == V4L2_YCBCR_ENC_709 || encoding == V4L2_YCBCR_ENC_XV709 ? YuvMatrix::Bt709
                                                                                       : YuvMatrix::Bt601;
    packed.fullRange = quantization == V4L2_QUANTIZATION_FULL_RANGE;
    return packed;
}

/// Reads pictures that are not coded.
std::function<Frame(Bytes)> rawReader(const v4l2_pix_format &format)
{
    const int width = static_cast<int>(format.width), height = static_cast<int>(format.height);
    const auto stride = static_cast<std::ptrdiff_t>(format.bytesperline);
    if (const auto layout = packedLayout(format.pixelformat)) {
        const auto planes = std::make_shared<PackedPlanes>(packedFormat(format, *layout));
        return [planes](Bytes bytes) { return *planes->toPlanes(bytes); };
    }
    if (const auto order = bayerOrder(format.pixelformat))
        return [=](Bytes bytes) { return bayerPlanes({bytes.data(), width, height, stride}, *order, 0, {}); };
    if (format.pixelformat == V4L2_PIX_FMT_GREY)
        return [=](Bytes bytes) { return monoPlanes({bytes.data(), width, height, stride}, 0, {}); };
    const auto order = format.pixelformat == V4L2_PIX_FMT_RGB24 ? RgbView::Order::Rgb : RgbView::Order::Bgr;
    return [=](Bytes bytes) { return rgbPlanes({bytes.data(), width, height, stride, order}, 0, {}); };
}

bool isCoded(std::uint32_t fourcc)
{
    return fourcc == V4L2_PIX_FMT_MJPEG || fourcc == V4L2_PIX_FMT_JPEG;
}

bool areAlike(const FrameFormat &a, const FrameFormat &b)
{
    return a.chromaShiftX == b.chromaShiftX && a.chromaShiftY == b.chromaShiftY;
}

} // namespace

int v4l2FormatRank(std::uint32_t fourcc)
{
    const auto found = std::ranges::find(readable, fourcc);
    return found == readable.end() ? -1 : static_cast<int>(found - readable.begin());
}

V4l2Pictures::V4l2Pictures(const v4l2_pix_format &format)
    : m_width(static_cast<int>(format.width)), m_height(static_cast<int>(format.height)),
      m_leastBytes(isCoded(format.pixelformat) ? 0 : format.sizeimage)
{
    if (!isCoded(format.pixelformat))
        m_raw = rawReader(format);
}

std::optional<V4l2Picture> V4l2Pictures::read(Bytes buffer)
{
    if (!m_raw)
        return readJpeg(buffer);
    if (buffer.size() < m_leastBytes)
        return std::nullopt;
    return V4l2Picture{m_raw(buffer), nullptr};
}

std::optional<V4l2Picture> V4l2Pictures::readJpeg(Bytes buffer)
{
    const auto format = jpegFormat(buffer);
    if (!format || format->width != m_width || format->height != m_height)
        return std::nullopt;
    if (!m_decoder || !areAlike(*format, m_jpegFormat)) {
        m_decoder = std::make_unique<JpegDecoder>(*format);
        m_jpegFormat = *format;
    }
    V4l2Picture picture{{}, std::make_shared<const std::vector<std::uint8_t>>(withHuffmanTables(buffer))};
    if (m_decoder->decode(*picture.jpeg, std::nullopt, picture.frame) != JpegDecoder::Outcome::Decoded)
        return std::nullopt;
    return picture;
}

} // namespace odo
