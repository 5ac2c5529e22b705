// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture_writer.h"

#include "core/files/output_file.h"
#include "core/video/jpeg_encoder.h"
#include "core/video/libav.h"
#include "core/video/picture.h"

#include <libyuv/convert_from_argb.h>

namespace odo {

namespace {

using PackedPicture = std::vector<unsigned char>;

constexpr int jpegQuality = 95;

tl::unexpected<Error> notPacked()
{
    return fail(ErrorCode::Internal, "picture", "it could not be packed", "use another picture");
}

/// Rows of grey or of red, green and blue, as a PNG: quickly, which makes it a tenth larger than it could be.
Result<PackedPicture> packed(const PlaneView &rows, AVPixelFormat pixels)
{
    libav::quieten();
    const AVCodec *codec = avcodec_find_encoder(AV_CODEC_ID_PNG);
    const libav::CodecPtr encoder(libav::allocated(avcodec_alloc_context3(codec)));
    encoder->width = rows.width;
    encoder->height = rows.height;
    encoder->pix_fmt = pixels;
    encoder->time_base = {1, 1};
    encoder->compression_level = 1;
    libav::Options options;
    options.set("pred", "sub");
    const libav::FramePtr picture(libav::allocated(av_frame_alloc()));
    picture->width = rows.width;
    picture->height = rows.height;
    picture->format = pixels;
    picture->data[0] = const_cast<std::uint8_t *>(rows.data); // NOLINT(cppcoreguidelines-pro-type-const-cast): is only read
    picture->linesize[0] = static_cast<int>(rows.stride);
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (!codec || libav::checked(avcodec_open2(encoder.get(), codec, options.get())) < 0 ||
        libav::checked(avcodec_send_frame(encoder.get(), picture.get())) < 0 ||
        libav::checked(avcodec_receive_packet(encoder.get(), packet.get())) < 0)
        return notPacked();
    return PackedPicture(packet->data, packet->data + packet->size);
}

Result<PackedPicture> packedAs(const std::filesystem::path &ending, const Frame &frame)
{
    if (ending == ".png")
        return colourPng(frame);
    if (ending == ".jpg" || ending == ".jpeg")
        return JpegEncoder(jpegQuality).encode(frame);
    return fail(ErrorCode::InvalidInput, "picture", "its format is not known", "use another picture");
}

} // namespace

Result<void> writePicture(const Frame &frame, const OutputTarget &target)
{
    const auto bytes = packedAs(target.file.extension(), frame);
    if (!bytes)
        return fail(ErrorCode::Io, "picture '" + target.file.string() + "'", bytes.error().why,
                    "check the folder, the free space, and that the name ends in .png or .jpg");
    return writeOutput(target, {reinterpret_cast<const char *>(bytes->data()), bytes->size()});
}

Result<PackedPicture> colourPng(const Frame &frame)
{
    const ScreenPicture picture = toScreen(frame, frame.format.width, frame.format.height);
    if (!picture.pixels)
        return notPacked();
    const int stride = 3 * picture.width;
    PackedPicture rgb(static_cast<std::size_t>(stride) * static_cast<std::size_t>(picture.height));
    libyuv::ARGBToRAW(reinterpret_cast<const std::uint8_t *>(picture.pixels.get()), 4 * picture.width,
                      rgb.data(), stride, picture.width, picture.height);
    return packed({rgb.data(), picture.width, picture.height, stride}, AV_PIX_FMT_RGB24);
}

Result<PackedPicture> greyPng(const Frame &frame)
{
    return packed(frame.y, AV_PIX_FMT_GRAY8);
}

} // namespace odo
