// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image.h"

#include "core/files/output_file.h"
#include "core/video/internal/libav.h"
#include "core/video/internal/screen_light.h"
#include "core/video/jpeg.h"

#include <algorithm>
#include <functional>
#include <libyuv/convert_argb.h>
#include <libyuv/convert_from_argb.h>
#include <libyuv/scale.h>
#include <vector>

namespace odo {

namespace {

/// Every n-th sample of sides that are longer than libyuv's 16.16-bit positions can count. No file is read
/// with such sides, but nothing keeps a camera from having them.
PlaneView thinned(const PlaneView &plane, std::vector<std::uint8_t> &samples)
{
    constexpr int longestSide = 32767;
    const int stepX = 1 + (plane.width - 1) / longestSide, stepY = 1 + (plane.height - 1) / longestSide;
    if (stepX == 1 && stepY == 1)
        return plane;
    const int width = plane.width / stepX, height = plane.height / stepY;
    samples.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            samples.push_back(plane.at(x * stepX, y * stepY));
    return {samples.data(), width, height, width};
}

/// A plane scaled to a size, or the plane itself where it has that size already.
struct ScaledPlane
{
    ScaledPlane(const PlaneView &whole, int width, int height)
    {
        if (whole.width == width && whole.height == height) {
            view = whole;
            return;
        }
        std::vector<std::uint8_t> samples;
        const PlaneView plane = thinned(whole, samples);
        memory = std::make_unique_for_overwrite<std::uint8_t[]>(static_cast<std::size_t>(width) *
                                                                static_cast<std::size_t>(height));
        // Bilinear keeps things within half a pixel of their position; over more than two source pixels it
        // would skip some and shimmer, there the average is better.
        const bool shrinksMuch = plane.width > 2 * width || plane.height > 2 * height;
        libyuv::ScalePlane(plane.data, static_cast<int>(plane.stride), plane.width, plane.height,
                           memory.get(), width, width, height,
                           shrinksMuch ? libyuv::kFilterBox : libyuv::kFilterBilinear);
        view = {memory.get(), width, height, width};
    }
    std::unique_ptr<std::uint8_t[]> memory;
    PlaneView view;
};

const libyuv::YuvConstants *matrixOf(const FrameFormat &format)
{
    if (format.matrix == YuvMatrix::Bt709)
        return format.fullRange ? &libyuv::kYuvF709Constants : &libyuv::kYuvH709Constants;
    if (format.matrix == YuvMatrix::Bt2020)
        return format.fullRange ? &libyuv::kYuvV2020Constants : &libyuv::kYuv2020Constants;
    return format.fullRange ? &libyuv::kYuvJPEGConstants : &libyuv::kYuvI601Constants;
}

} // namespace

ScreenImage toScreen(const Frame &frame, int width, int height)
{
    ScreenImage image;
    if (width <= 0 || height <= 0 || frame.y.data == nullptr)
        return image;
    image.width = width;
    image.height = height;
    image.pixels = std::make_unique_for_overwrite<std::uint32_t[]>(static_cast<std::size_t>(width) *
                                                                   static_cast<std::size_t>(height));
    auto *to = reinterpret_cast<std::uint8_t *>(image.pixels.get());
    const bool halved = frame.format.chromaShiftX == 1 && frame.format.chromaShiftY == 1;
    const int chromaWidth = halved ? (width + 1) / 2 : width,
              chromaHeight = halved ? (height + 1) / 2 : height;
    const ScaledPlane y(frame.y, width, height);
    const ScaledPlane u(frame.u, chromaWidth, chromaHeight), v(frame.v, chromaWidth, chromaHeight);
    const auto convert = halved ? libyuv::I420ToARGBMatrix : libyuv::I444ToARGBMatrix;
    convert(y.view.data, static_cast<int>(y.view.stride), u.view.data, static_cast<int>(u.view.stride),
            v.view.data, static_cast<int>(v.view.stride), to, width * 4, matrixOf(frame.format), width,
            height);
    mapToScreen({image.pixels.get(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height)},
                frame.format.transfer);
    return image;
}

Frame fromScreen(const std::uint32_t *pixels, int width, int height, std::ptrdiff_t strideBytes,
                 Nanoseconds time)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.siting = ChromaSiting::Center; // libyuv takes the mean of four pixels
    auto buffer = std::make_shared<FrameBuffer>(format);
    libyuv::ARGBToI420(reinterpret_cast<const std::uint8_t *>(pixels), static_cast<int>(strideBytes),
                       buffer->yRow(0), width, buffer->uRow(0), buffer->chromaWidth(), buffer->vRow(0),
                       buffer->chromaWidth(), width, height);
    return FrameBuffer::toFrame(std::move(buffer), 0, time);
}

namespace {

using PackedImage = std::vector<unsigned char>;

constexpr int jpegQuality = 95;

tl::unexpected<Error> notPacked(ErrorCode code, Message why)
{
    return fail(code, ODO_TEXT("video.picture", "image"), std::move(why), useAnotherImage());
}

tl::unexpected<Error> notPacked()
{
    return notPacked(ErrorCode::Internal, ODO_TEXT("video.picture_not_packed", "it could not be compressed"));
}

/// Rows of grey or of red, green and blue, as a PNG: quickly, which makes it a tenth larger than it could be.
/// write(to, stride) writes them.
Result<PackedImage> packed(int width, int height, AVPixelFormat pixels,
                           const std::function<void(std::uint8_t *, int)> &write)
{
    if (width <= 0 || height <= 0)
        return notPacked();
    libav::quieten();
    const AVCodec *codec = avcodec_find_encoder(AV_CODEC_ID_PNG);
    const libav::CodecPtr encoder(libav::allocated(avcodec_alloc_context3(codec)));
    encoder->width = width;
    encoder->height = height;
    encoder->pix_fmt = pixels;
    encoder->time_base = {1, 1};
    encoder->compression_level = 1;
    libav::Options options;
    options.set("pred", "sub");
    const libav::FramePtr image(libav::allocated(av_frame_alloc()));
    image->width = width;
    image->height = height;
    image->format = pixels;
    if (libav::checked(av_frame_get_buffer(image.get(), 0)) < 0)
        return notPacked();
    write(image->data[0], image->linesize[0]);
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (!codec || libav::checked(avcodec_open2(encoder.get(), codec, options.get())) < 0 ||
        libav::checked(avcodec_send_frame(encoder.get(), image.get())) < 0 ||
        libav::checked(avcodec_receive_packet(encoder.get(), packet.get())) < 0)
        return notPacked();
    return PackedImage(packet->data, packet->data + packet->size);
}

/// Rows of a frame from an even one, at full size.
ScreenImage rowsToScreen(const Frame &frame, int first, int rows)
{
    Frame part = frame;
    const auto cut = [&](PlaneView &plane, int shift) {
        plane.data += std::ptrdiff_t(first >> shift) * plane.stride;
        plane.height = (rows + (1 << shift) - 1) >> shift;
    };
    cut(part.y, 0);
    cut(part.u, frame.format.chromaShiftY);
    cut(part.v, frame.format.chromaShiftY);
    part.format.height = rows;
    return toScreen(part, frame.format.width, rows);
}

Result<PackedImage> packedAs(const std::filesystem::path &ending, const Frame &frame)
{
    if (ending == ".png")
        return colourPng(frame);
    if (ending == ".jpg" || ending == ".jpeg")
        return JpegEncoder(jpegQuality).encode(frame);
    return notPacked(ErrorCode::InvalidInput,
                     ODO_TEXT("video.picture_format_unknown", "its format is unknown"));
}

} // namespace

Message useAnotherImage()
{
    return ODO_TEXT("video.use_another_picture", "use another image");
}

Result<void> writeImage(const Frame &frame, const OutputTarget &target)
{
    const auto bytes = packedAs(target.file.extension(), frame);
    if (!bytes)
        return fail(ErrorCode::Io, ODO_TEXT("video.picture_named", "image '%1'")(Named::file(target.file)),
                    bytes.error().why,
                    ODO_TEXT("video.check_picture_place",
                             "check the folder, the free space, and that the name ends in .png or .jpg"));
    return writeOutput(target, {reinterpret_cast<const char *>(bytes->data()), bytes->size()});
}

Result<PackedImage> colourPng(const Frame &frame)
{
    if (frame.y.data == nullptr)
        return notPacked();
    constexpr int band = 256; // rows at a time: those for a screen take four bytes a pixel
    return packed(
        frame.format.width, frame.format.height, AV_PIX_FMT_RGB24, [&](std::uint8_t *to, int stride) {
            for (int y = 0; y < frame.format.height; y += band) {
                const ScreenImage rows = rowsToScreen(frame, y, std::min(band, frame.format.height - y));
                libyuv::ARGBToRAW(reinterpret_cast<const std::uint8_t *>(rows.pixels.get()), 4 * rows.width,
                                  to + std::ptrdiff_t(y) * stride, stride, rows.width, rows.height);
            }
        });
}

Result<PackedImage> greyPng(const Frame &frame)
{
    return packed(frame.y.width, frame.y.height, AV_PIX_FMT_GRAY8, [&](std::uint8_t *to, int stride) {
        for (int y = 0; y < frame.y.height; ++y)
            std::copy_n(frame.y.row(y), frame.y.width, to + std::ptrdiff_t(y) * stride);
    });
}

} // namespace odo
