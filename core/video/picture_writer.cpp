// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture_writer.h"

#include "core/files/output_file.h"
#include "core/video/internal/libav.h"
#include "core/video/jpeg.h"
#include "core/video/picture.h"

#include <algorithm>
#include <functional>
#include <libyuv/convert_from_argb.h>

namespace odo {

namespace {

using PackedPicture = std::vector<unsigned char>;

constexpr int jpegQuality = 95;

tl::unexpected<Error> notPacked(ErrorCode code, Message why)
{
    return fail(code, ODO_TEXT("video.picture", "picture"), std::move(why), useAnotherPicture());
}

tl::unexpected<Error> notPacked()
{
    return notPacked(ErrorCode::Internal, ODO_TEXT("video.picture_not_packed", "it could not be packed"));
}

/// Rows of grey or of red, green and blue, as a PNG: quickly, which makes it a tenth larger than it could be.
/// write(to, stride) writes them.
Result<PackedPicture> packed(int width, int height, AVPixelFormat pixels,
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
    const libav::FramePtr picture(libav::allocated(av_frame_alloc()));
    picture->width = width;
    picture->height = height;
    picture->format = pixels;
    if (libav::checked(av_frame_get_buffer(picture.get(), 0)) < 0)
        return notPacked();
    write(picture->data[0], picture->linesize[0]);
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (!codec || libav::checked(avcodec_open2(encoder.get(), codec, options.get())) < 0 ||
        libav::checked(avcodec_send_frame(encoder.get(), picture.get())) < 0 ||
        libav::checked(avcodec_receive_packet(encoder.get(), packet.get())) < 0)
        return notPacked();
    return PackedPicture(packet->data, packet->data + packet->size);
}

/// Rows of a frame from an even one, at full size.
ScreenPicture rowsToScreen(const Frame &frame, int first, int rows)
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

Result<PackedPicture> packedAs(const std::filesystem::path &ending, const Frame &frame)
{
    if (ending == ".png")
        return colourPng(frame);
    if (ending == ".jpg" || ending == ".jpeg")
        return JpegEncoder(jpegQuality).encode(frame);
    return notPacked(ErrorCode::InvalidInput,
                     ODO_TEXT("video.picture_format_unknown", "its format is not known"));
}

} // namespace

Message useAnotherPicture()
{
    return ODO_TEXT("video.use_another_picture", "use another picture");
}

Result<void> writePicture(const Frame &frame, const OutputTarget &target)
{
    const auto bytes = packedAs(target.file.extension(), frame);
    if (!bytes)
        return fail(ErrorCode::Io, ODO_TEXT("video.picture_named", "picture '%1'")(Named::file(target.file)),
                    bytes.error().why,
                    ODO_TEXT("video.check_picture_place",
                             "check the folder, the free space, and that the name ends in .png or .jpg"));
    return writeOutput(target, {reinterpret_cast<const char *>(bytes->data()), bytes->size()});
}

Result<PackedPicture> colourPng(const Frame &frame)
{
    if (frame.y.data == nullptr)
        return notPacked();
    constexpr int band = 256; // rows at a time: those for a screen take four bytes a pixel
    return packed(
        frame.format.width, frame.format.height, AV_PIX_FMT_RGB24, [&](std::uint8_t *to, int stride) {
            for (int y = 0; y < frame.format.height; y += band) {
                const ScreenPicture rows = rowsToScreen(frame, y, std::min(band, frame.format.height - y));
                libyuv::ARGBToRAW(reinterpret_cast<const std::uint8_t *>(rows.pixels.get()), 4 * rows.width,
                                  to + std::ptrdiff_t(y) * stride, stride, rows.width, rows.height);
            }
        });
}

Result<PackedPicture> greyPng(const Frame &frame)
{
    return packed(frame.y.width, frame.y.height, AV_PIX_FMT_GRAY8, [&](std::uint8_t *to, int stride) {
        for (int y = 0; y < frame.y.height; ++y)
            std::copy_n(frame.y.row(y), frame.y.width, to + std::ptrdiff_t(y) * stride);
    });
}

} // namespace odo
