// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image_reader.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/video/frame_turn.h"
#include "core/video/internal/heif.h"
#include "core/video/internal/orientation.h"
#include "core/video/internal/pixel_planes.h"
#include "core/video/internal/rgb_rows.h"
#include "core/video/internal/riff.h"
#include "core/video/internal/tiff.h"
#include "core/video/jpeg.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string_view>
extern "C" {
#include <libavutil/intreadwrite.h>
}

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uintmax_t maximumFileBytes = 200'000'000;
/// With more, decoding and detection would take more than 500 MB.
constexpr std::int64_t mostImagePixels = 50'000'000;

Message cannotRead(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_read_picture", "cannot read the image %1")(Named::file(file));
}

/// As a packet, which a decoder takes without a copy.
Result<libav::PacketPtr> readFile(const std::filesystem::path &file)
{
    ODO_TRY(checkMayBeRead(file, cannotRead(file)));
    std::error_code error;
    const std::uintmax_t size = files::sizeOf(file, error);
    if (error || size > maximumFileBytes)
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    ODO_TEXT("video.picture_file_too_large", "the file is larger than 200 MB"),
                    ODO_TEXT("video.name_a_picture", "choose an image"));
    libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (libav::checked(av_new_packet(packet.get(), static_cast<int>(size))) != 0)
        throw std::bad_alloc();
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(reinterpret_cast<char *>(packet->data), static_cast<std::streamsize>(size)))
        return fail(ErrorCode::Io, cannotRead(file),
                    ODO_TEXT("video.file_not_read", "the file could not be read"), checkFileMayBeRead());
    return packet;
}

AVCodecID codecOf(ImageFormat format)
{
    switch (format) {
    case ImageFormat::Png:
        return AV_CODEC_ID_PNG;
    case ImageFormat::Jpeg:
        return AV_CODEC_ID_MJPEG;
    case ImageFormat::Bmp:
        return AV_CODEC_ID_BMP;
    case ImageFormat::Pbm:
        return AV_CODEC_ID_PBM;
    case ImageFormat::Pgm:
        return AV_CODEC_ID_PGM;
    case ImageFormat::Ppm:
        return AV_CODEC_ID_PPM;
    case ImageFormat::Webp:
        return AV_CODEC_ID_WEBP;
    case ImageFormat::Heif:
    case ImageFormat::Tiff:
        break;
    }
    return AV_CODEC_ID_NONE;
}

Bytes bytesOf(const libav::PacketPtr &file)
{
    return {file->data, static_cast<std::size_t>(file->size)};
}

/// Null when libavcodec refuses it. The file's memory is given back.
libav::FramePtr decodedByLibav(libav::PacketPtr file, ImageFormat format)
{
    libav::quieten();
    const AVCodec *codec = avcodec_find_decoder(codecOf(format));
    const libav::CodecPtr decoder(libav::allocated(avcodec_alloc_context3(codec)));
    decoder->thread_count = 1;
    decoder->max_pixels = libav::mostPixels;
    if (format != ImageFormat::Jpeg) // of which cameras write some that are not quite as they should be
        decoder->err_recognition |= AV_EF_CRCCHECK | AV_EF_EXPLODE;
    libav::FramePtr image(libav::allocated(av_frame_alloc()));
    const bool isWhole = codec && libav::checked(avcodec_open2(decoder.get(), codec, nullptr)) == 0 &&
                         libav::checked(avcodec_send_packet(decoder.get(), file.get())) == 0 &&
                         libav::checked(avcodec_receive_frame(decoder.get(), image.get())) == 0 &&
                         image->decode_error_flags == 0 && (image->flags & AV_FRAME_FLAG_CORRUPT) == 0;
    file.reset(); // the decoder's own goes with it
    return isWhole ? std::move(image) : nullptr;
}

std::optional<Frame> fromLibav(libav::FramePtr image)
{
    const auto pixels = image ? static_cast<AVPixelFormat>(image->format) : AV_PIX_FMT_NONE;
    const auto format = image ? planesOf(pixels, rgbFormat(image->width, image->height)) : std::nullopt;
    return format ? PixelPlanes(pixels, *format).frameOf(std::move(image)) : std::nullopt;
}

/// Whether the end of the image follows its last scan (ITU-T T.81 §B.1.1): libavcodec fills what is missing
/// with grey.
bool hasItsEnd(Bytes jpeg)
{
    const std::string_view text(reinterpret_cast<const char *>(jpeg.data()), jpeg.size());
    const std::size_t scan = text.rfind("\xff\xda"), end = text.rfind("\xff\xd9");
    return scan != std::string_view::npos && end != std::string_view::npos && scan < end;
}

/// As the images of a video: what is suitable by libjpeg-turbo, which reports damage.
std::optional<Frame> decodeJpeg(libav::PacketPtr file, const ImageHeader &header)
{
    const Bytes bytes = bytesOf(file);
    const auto format = jpegFormat(bytes);
    const bool isAsStated = format && std::uint32_t(format->width) == header.width &&
                            std::uint32_t(format->height) == header.height;
    if (isAsStated && format->chromaShiftX <= 1 && format->chromaShiftY <= 1) {
        Frame frame;
        const auto outcome = JpegDecoder(*format).decode(bytes, std::nullopt, frame);
        if (outcome != JpegDecoder::Outcome::NotSuitable)
            return outcome == JpegDecoder::Outcome::Decoded ? std::optional(std::move(frame)) : std::nullopt;
    }
    return hasItsEnd(bytes) ? fromLibav(decodedByLibav(std::move(file), header.format)) : std::nullopt;
}

/// What is shorter than its file header says is cut: libavcodec takes its rows for ones without padding.
std::optional<Frame> decodeBmp(libav::PacketPtr file)
{
    constexpr std::size_t fileSizeAt = 2;
    const bool isCut = bytesOf(file).size() < AV_RL32(file->data + fileSizeAt);
    return isCut ? std::nullopt : fromLibav(decodedByLibav(std::move(file), ImageFormat::Bmp));
}

/// Luma from 16 to 235 and chroma from 16 to 240, stretched in place to 0 to 255 (H.273 §8.3).
void stretchToFullRange(AVFrame &image)
{
    const auto stretched = [](int limited, int low, int span, int middle) {
        return std::uint8_t(std::clamp((2 * 255 * (limited - low) + span) / (2 * span) + middle, 0, 255));
    };
    std::array<std::uint8_t, 256> luma{}, chroma{};
    for (int i = 0; i < 256; ++i) {
        luma[std::size_t(i)] = i <= 16 ? std::uint8_t(0) : stretched(i, 16, 219, 0);
        chroma[std::size_t(i)] = stretched(i, 16, 224, 0);
    }
    for (int plane = 0; plane < 3; ++plane) {
        const auto &table = plane == 0 ? luma : chroma;
        const int width = plane == 0 ? image.width : AV_CEIL_RSHIFT(image.width, 1);
        const int height = plane == 0 ? image.height : AV_CEIL_RSHIFT(image.height, 1);
        for (int y = 0; y < height; ++y) {
            std::uint8_t *row = image.data[plane] + std::ptrdiff_t(y) * image.linesize[plane];
            std::transform(row, row + width, row, [&](std::uint8_t value) { return table[value]; });
        }
    }
}

/// Lossy ones are 4:2:0 of limited range (RFC 9649 §2.5); what is transparent is read as if it were not.
std::optional<Frame> decodeWebp(libav::PacketPtr file)
{
    if (isCutWebp(bytesOf(file)))
        return std::nullopt;
    libav::FramePtr image = decodedByLibav(std::move(file), ImageFormat::Webp);
    const bool isLossy =
        image && (image->format == AV_PIX_FMT_YUV420P || image->format == AV_PIX_FMT_YUVA420P);
    if (isLossy) {
        if (libav::checked(av_frame_make_writable(image.get())) != 0)
            return std::nullopt;
        stretchToFullRange(*image);
        image->format = AV_PIX_FMT_YUV420P;
    }
    return fromLibav(std::move(image));
}

std::optional<Frame> decode(libav::PacketPtr file, const ImageHeader &header)
{
    switch (header.format) {
    case ImageFormat::Webp:
        return decodeWebp(std::move(file));
    case ImageFormat::Heif:
        return decodeHeif(bytesOf(file));
    case ImageFormat::Jpeg:
        return decodeJpeg(std::move(file), header);
    case ImageFormat::Bmp:
        return decodeBmp(std::move(file));
    case ImageFormat::Tiff:
        return decodeTiff(bytesOf(file));
    default:
        break;
    }
    return fromLibav(decodedByLibav(std::move(file), header.format));
}

Result<Frame> readImageChecked(const std::filesystem::path &file)
{
    auto packet = ODO_TRY(readFile(file));
    const auto header = imageHeader(bytesOf(packet));
    if (!header)
        return fail(
            ErrorCode::InvalidInput, cannotRead(file),
            ODO_TEXT("video.no_picture_format", "it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image"),
            ODO_TEXT("video.convert_to_png", "convert it to PNG or JPEG"));
    if (libav::isTooLarge(header->width, header->height) ||
        std::int64_t(header->width) * header->height > mostImagePixels)
        return fail(
            ErrorCode::InvalidInput, cannotRead(file),
            joined({ODO_TEXT("video.picture_claims_size", "its header says that it has %1 pixels")(
                        std::to_string(header->width) + "x" + std::to_string(header->height)),
                    ODO_TEXT("video.largest_picture", "the limit is 50 megapixels and 32000 pixels a side")},
                   Join::Semicolon),
            ODO_TEXT("video.make_smaller", "make it smaller"));
    const int orientation = statedOrientation(header->format, bytesOf(packet));
    const auto frame = decode(std::move(packet), *header);
    if (!frame)
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    ODO_TEXT("video.picture_damaged", "its content is damaged or cut short"),
                    ODO_TEXT("video.copy_again", "copy it again"));
    return turned(*frame, orientation);
}

} // namespace

Result<Frame> readImage(const std::filesystem::path &file)
{
    return orShortage(cannotRead(file), [&file] { return readImageChecked(file); });
}

} // namespace odo
