// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/jpeg_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <turbojpeg.h>

namespace odo {

namespace {

using Stretch = std::array<std::uint8_t, 256>;

/// From a limited range (H.273: luma 16 to 235, chroma 16 to 240) to the full one.
Stretch stretchOf(double zero, double span, double zeroAfter, double spanAfter)
{
    Stretch stretch{};
    for (int value = 0; value < 256; ++value) {
        const double full = zeroAfter + (value - zero) * spanAfter / span;
        stretch[static_cast<std::size_t>(value)] = static_cast<std::uint8_t>(std::clamp(std::lround(full), 0L, 255L));
    }
    return stretch;
}

const Stretch lumaStretch = stretchOf(16, 219, 0, 255), chromaStretch = stretchOf(128, 224, 128, 255);

std::optional<TJSAMP> samplingOf(const FrameFormat &format)
{
    switch (format.chromaShiftX * 2 + format.chromaShiftY) {
    case 0:
        return TJSAMP_444;
    case 1:
        return TJSAMP_440;
    case 2:
        return TJSAMP_422;
    case 3:
        return TJSAMP_420;
    default:
        return std::nullopt;
    }
}

} // namespace

struct JpegEncoder::Impl
{
    int quality = 0;
    tjhandle handle = tjInitCompress();
    std::array<std::vector<std::uint8_t>, 3> stretched;
    std::vector<std::uint8_t> coded;

    PlaneView fullRange(const PlaneView &plane, int index);
};

/// A copy of the plane, stretched.
PlaneView JpegEncoder::Impl::fullRange(const PlaneView &plane, int index)
{
    const Stretch &stretch = index == 0 ? lumaStretch : chromaStretch;
    std::vector<std::uint8_t> &copy = stretched[static_cast<std::size_t>(index)];
    copy.resize(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
    for (int y = 0; y < plane.height; ++y)
        std::transform(plane.row(y), plane.row(y) + plane.width, copy.begin() + static_cast<std::ptrdiff_t>(y) * plane.width,
                       [&](std::uint8_t value) { return stretch[value]; });
    return {copy.data(), plane.width, plane.height, plane.width};
}

JpegEncoder::JpegEncoder(int quality) : m_impl(std::make_unique<Impl>())
{
    m_impl->quality = quality;
}

JpegEncoder::~JpegEncoder()
{
    tjDestroy(m_impl->handle);
}

Result<std::vector<std::uint8_t>> JpegEncoder::encode(const Frame &frame)
{
    const FrameFormat &format = frame.format;
    const auto sampling = samplingOf(format);
    if (!sampling)
        return fail(ErrorCode::InvalidInput, "a picture cannot be coded", "JPEG does not have its layout of colours",
                    "let the camera give another format");
    std::array<PlaneView, 3> planes{frame.y, frame.u, frame.v};
    if (!format.fullRange) {
        for (int i = 0; i < 3; ++i)
            planes[static_cast<std::size_t>(i)] = m_impl->fullRange(planes[static_cast<std::size_t>(i)], i);
    }
    const unsigned char *rows[3] = {planes[0].data, planes[1].data, planes[2].data};
    const int strides[3] = {static_cast<int>(planes[0].stride), static_cast<int>(planes[1].stride), static_cast<int>(planes[2].stride)};
    std::vector<std::uint8_t> &coded = m_impl->coded;
    coded.resize(tjBufSize(format.width, format.height, *sampling));
    unsigned char *buffer = coded.data();
    unsigned long size = coded.size();
    if (tjCompressFromYUVPlanes(m_impl->handle, rows, format.width, strides, format.height, *sampling, &buffer, &size,
                                m_impl->quality, TJFLAG_NOREALLOC) != 0)
        return fail(ErrorCode::Internal, "a picture cannot be coded", tjGetErrorStr2(m_impl->handle), "let the camera give another format");
    return std::vector<std::uint8_t>(coded.begin(), coded.begin() + static_cast<std::ptrdiff_t>(size));
}

} // namespace odo
