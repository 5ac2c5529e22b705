// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/pixel_planes.h"

#include "core/video/internal/rgb_rows.h"

#include <algorithm>
#include <array>
#include <libyuv/planar_functions.h>
#include <utility>
extern "C" {
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace odo {

namespace {

constexpr std::uint8_t neutralChroma = 128;

/// How libav keeps samples.
enum class Storage {
    Planes,     ///< of 8 bits
    DeepPlanes, ///< of 9 to 16 bits in the order of this machine
    OtherYuv,   ///< packed, chroma with chroma, or halved twice
    Rgb, ///< all else that is converted to it: in a palette, black and white, deep grey of another order
    None
};

bool isPlanar(const AVPixFmtDescriptor &pixels)
{
    const int bytes = pixels.comp[0].depth > 8 ? 2 : 1, planes = std::min<int>(pixels.nb_components, 3);
    for (int i = 0; i < planes; ++i) {
        const AVComponentDescriptor &of = pixels.comp[i];
        if (of.plane != i || of.step != bytes || of.offset != 0 || of.shift != 0 ||
            of.depth != pixels.comp[0].depth)
            return false;
    }
    return pixels.nb_components != 2; // grey that is transparent
}

bool isGrey(const AVPixFmtDescriptor &pixels)
{
    return pixels.nb_components < 3;
}

Storage storageOf(AVPixelFormat format)
{
    const AVPixFmtDescriptor *pixels = av_pix_fmt_desc_get(format);
    constexpr std::uint64_t never = AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_BAYER | AV_PIX_FMT_FLAG_FLOAT,
                            notYuv = AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_BITSTREAM;
    const bool isXyz = format == AV_PIX_FMT_XYZ12LE || format == AV_PIX_FMT_XYZ12BE;
    if (!pixels || isXyz || (pixels->flags & never) != 0 || sws_isSupportedInput(format) == 0)
        return Storage::None;
    const bool isOtherOrder =
        pixels->comp[0].depth > 8 && ((pixels->flags & AV_PIX_FMT_FLAG_BE) != 0) != (AV_HAVE_BIGENDIAN != 0);
    if ((pixels->flags & notYuv) != 0 || (isGrey(*pixels) && (isOtherOrder || !isPlanar(*pixels))))
        return Storage::Rgb;
    if (isOtherOrder || !isPlanar(*pixels) || pixels->log2_chroma_w > 1 || pixels->log2_chroma_h > 1)
        return Storage::OtherYuv;
    return pixels->comp[0].depth > 8 ? Storage::DeepPlanes : Storage::Planes;
}

using Scaler = std::unique_ptr<SwsContext, void (*)(SwsContext *)>;

Scaler scalerFor(int width, int height, AVPixelFormat from, AVPixelFormat to, bool isFullRange)
{
    Scaler scaler(sws_getContext(width, height, from, width, height, to,
                                 SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr,
                                 nullptr),
                  &sws_freeContext);
    if (scaler && isFullRange) { // which libswscale knows of few formats
        const int *matrix = sws_getCoefficients(SWS_CS_ITU601);
        constexpr int unchanged = 1 << 16;
        sws_setColorspaceDetails(scaler.get(), matrix, 1, matrix, 1, 0, unchanged, unchanged);
    }
    return scaler;
}

/// Some rows in RGB; null where libswscale fails.
libav::FramePtr rgbRowsOf(const AVFrame &image, int firstRow, int rows)
{
    libav::FramePtr rgb(libav::allocated(av_frame_alloc()));
    rgb->format = AV_PIX_FMT_RGB24;
    rgb->width = image.width;
    rgb->height = rows;
    const auto pixels = static_cast<AVPixelFormat>(image.format);
    const Scaler scaler =
        scalerFor(image.width, rows, pixels, AV_PIX_FMT_RGB24, image.color_range == AVCOL_RANGE_JPEG);
    const std::uint8_t *planes[AV_NUM_DATA_POINTERS] = {};
    const bool hasPalette = (av_pix_fmt_desc_get(pixels)->flags & AV_PIX_FMT_FLAG_PAL) != 0;
    for (int i = 0; i < AV_NUM_DATA_POINTERS && image.data[i]; ++i)
        planes[i] = image.data[i] + (hasPalette && i == 1 ? 0 : std::ptrdiff_t(firstRow) * image.linesize[i]);
    const bool isDone = scaler && libav::checked(av_frame_get_buffer(rgb.get(), 0)) == 0 &&
                        libav::checked(sws_scale(scaler.get(), planes, image.linesize, 0, rows, rgb->data,
                                                 rgb->linesize)) == rows;
    return isDone ? std::move(rgb) : nullptr;
}

bool fillFromRgb(const AVFrame &image, const FramePool::Blank &to)
{
    // rows at a time, because those in RGB take as much memory again; a multiple of eight, as dithering is
    constexpr int band = 256;
    for (int first = 0; first < image.height; first += band) {
        const int rows = std::min(band, image.height - first);
        const libav::FramePtr rgb = rgbRowsOf(image, first, rows);
        if (!rgb)
            return false;
        for (int y = first; y < first + rows; ++y) {
            const std::ptrdiff_t at = std::ptrdiff_t(y) * image.width;
            convertRgbRow(rgb->data[0] + std::ptrdiff_t(y - first) * rgb->linesize[0], image.width, to.y + at,
                          to.u + at, to.v + at);
        }
    }
    return true;
}

bool fillFromOtherYuv(const AVFrame &image, const FramePool::Blank &to)
{
    const FrameFormat &format = to.frame.format;
    const Scaler scaler = scalerFor(image.width, image.height, static_cast<AVPixelFormat>(image.format),
                                    pixelsLike(format), format.fullRange);
    std::uint8_t *const planes[] = {to.y, to.u, to.v, nullptr};
    const int strides[] = {format.width, format.chromaWidth(), format.chromaWidth(), 0};
    return scaler && libav::checked(sws_scale(scaler.get(), image.data, image.linesize, 0, image.height,
                                              planes, strides)) == image.height;
}

void fillNeutral(const FramePool::Blank &to)
{
    const std::ptrdiff_t samples = to.frame.u.stride * to.frame.u.height;
    std::fill_n(to.u, samples, neutralChroma);
    std::fill_n(to.v, samples, neutralChroma);
}

bool fillFromDeep(const AVFrame &image, const FramePool::Blank &to)
{
    const AVPixFmtDescriptor &pixels = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    const int scale = 1 << (24 - pixels.comp[0].depth); // of samples to the upper 8 of 16 bits
    const auto fill = [&image, scale](int plane, const PlaneView &of, std::uint8_t *samples) {
        libyuv::Convert16To8Plane(reinterpret_cast<const std::uint16_t *>(image.data[plane]),
                                  image.linesize[plane] / 2, samples, int(of.stride), scale, of.width,
                                  of.height);
    };
    fill(0, to.frame.y, to.y);
    if (isGrey(pixels)) {
        fillNeutral(to);
    } else {
        fill(1, to.frame.u, to.u);
        fill(2, to.frame.v, to.v);
    }
    return true;
}

/// The memory of a grey frame: what the decoder gave, and chroma of ours.
struct GreyFrame
{
    libav::FramePtr luma;
    std::shared_ptr<const void> chroma;
};

Frame withNeutralChroma(libav::FramePtr avFrame, const FramePool::Blank &blank)
{
    fillNeutral(blank);
    Frame frame = blank.frame;
    frame.y = {avFrame->data[0], frame.format.width, frame.format.height, avFrame->linesize[0]};
    frame.owner = std::make_shared<GreyFrame>(GreyFrame{std::move(avFrame), blank.frame.owner});
    return frame;
}

Frame overPlanes(libav::FramePtr avFrame, const FrameFormat &format)
{
    Frame frame;
    frame.format = format;
    frame.y = {avFrame->data[0], format.width, format.height, avFrame->linesize[0]};
    frame.u = {avFrame->data[1], format.chromaWidth(), format.chromaHeight(), avFrame->linesize[1]};
    frame.v = {avFrame->data[2], format.chromaWidth(), format.chromaHeight(), avFrame->linesize[2]};
    frame.owner = std::shared_ptr<const AVFrame>(avFrame.release(), libav::Delete());
    return frame;
}

} // namespace

std::optional<FrameFormat> planesOf(AVPixelFormat pixels, const FrameFormat &stated)
{
    const Storage storage = storageOf(pixels);
    if (storage == Storage::None)
        return std::nullopt;
    if (storage == Storage::Rgb)
        return rgbFormat(stated.width, stated.height);
    const AVPixFmtDescriptor &is = *av_pix_fmt_desc_get(pixels);
    FrameFormat format = stated;
    format.chromaShiftX = isGrey(is) ? 1 : std::min<int>(is.log2_chroma_w, 1);
    format.chromaShiftY = isGrey(is) ? 1 : std::min<int>(is.log2_chroma_h, 1);
    return format;
}

AVPixelFormat pixelsLike(const FrameFormat &format)
{
    if (format.chromaShiftX == 0)
        return format.chromaShiftY == 0 ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_YUV440P;
    return format.chromaShiftY == 0 ? AV_PIX_FMT_YUV422P : AV_PIX_FMT_YUV420P;
}

int bitsOf(AVPixelFormat pixels)
{
    const AVPixFmtDescriptor *is = av_pix_fmt_desc_get(pixels);
    return !is ? 0 : (is->flags & AV_PIX_FMT_FLAG_PAL) != 0 ? 8 : is->comp[0].depth;
}

PixelPlanes::PixelPlanes(AVPixelFormat pixels, const FrameFormat &format) : m_pixels(pixels), m_frames(format)
{
}

std::optional<Frame> PixelPlanes::frameOf(libav::FramePtr avFrame) const
{
    if (avFrame->width != format().width || avFrame->height != format().height || avFrame->format != m_pixels)
        return std::nullopt;
    const Storage storage = storageOf(m_pixels);
    const bool isAsGiven = storage == Storage::Planes;
    if (isAsGiven && !isGrey(*av_pix_fmt_desc_get(m_pixels)))
        return overPlanes(std::move(avFrame), format());
    const FramePool::Blank blank = m_frames.take();
    if (isAsGiven)
        return withNeutralChroma(std::move(avFrame), blank);
    const auto fill = storage == Storage::DeepPlanes ? fillFromDeep
                      : storage == Storage::Rgb      ? fillFromRgb
                                                     : fillFromOtherYuv;
    return fill(*avFrame, blank) ? std::optional(blank.frame) : std::nullopt;
}

} // namespace odo
