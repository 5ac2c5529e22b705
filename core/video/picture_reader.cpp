// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture_reader.h"

#include "core/base/file_system.h"
#include "core/files/protected_files.h"
#include "core/base/shortage.h"
#include "core/video/jpeg_decoder.h"
#include "core/video/jpeg_file.h"
#include "core/video/picture_header.h"
#include "core/video/stream_format.h"

extern "C" {
#include <libavutil/intreadwrite.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <fstream>
#include <span>
#include <string_view>

namespace odo {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uintmax_t maximumFileBytes = 200'000'000;
/// With more, decoding and detection would take more than 500 MB.
constexpr std::int64_t mostPicturePixels = 50'000'000;

std::string cannotRead(const std::filesystem::path &file)
{
    return "cannot read the picture " + file.string();
}

/// As a packet, which a decoder takes without a copy.
Result<libav::PacketPtr> readFile(const std::filesystem::path &file)
{
    if (auto may = checkMayBeRead(file, cannotRead(file)); !may)
        return tl::unexpected(may.error());
    std::error_code error;
    const std::uintmax_t size = files::sizeOf(file, error);
    if (error || size > maximumFileBytes)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "the file is larger than 200 MB",
                    "name a picture");
    libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (libav::checked(av_new_packet(packet.get(), static_cast<int>(size))) != 0)
        throw std::bad_alloc();
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(reinterpret_cast<char *>(packet->data), static_cast<std::streamsize>(size)))
        return fail(ErrorCode::Io, cannotRead(file), "the file could not be read",
                    "check that you may read the file");
    return packet;
}

AVCodecID codecOf(PictureFormat format)
{
    switch (format) {
    case PictureFormat::Png:
        return AV_CODEC_ID_PNG;
    case PictureFormat::Jpeg:
        return AV_CODEC_ID_MJPEG;
    case PictureFormat::Bmp:
        return AV_CODEC_ID_BMP;
    case PictureFormat::Tiff:
        return AV_CODEC_ID_TIFF;
    case PictureFormat::Pbm:
        return AV_CODEC_ID_PBM;
    case PictureFormat::Pgm:
        return AV_CODEC_ID_PGM;
    case PictureFormat::Ppm:
        return AV_CODEC_ID_PPM;
    }
    return AV_CODEC_ID_NONE;
}

Bytes bytesOf(const libav::PacketPtr &file)
{
    return {file->data, static_cast<std::size_t>(file->size)};
}

/// Null when libavcodec refuses it. The file's memory is given back.
libav::FramePtr decodedByLibav(libav::PacketPtr file, PictureFormat format)
{
    libav::quieten();
    const AVCodec *codec = avcodec_find_decoder(codecOf(format));
    const libav::CodecPtr decoder(libav::allocated(avcodec_alloc_context3(codec)));
    decoder->thread_count = 1;
    decoder->max_pixels = libav::mostPixels;
    if (format != PictureFormat::Jpeg) // of which cameras write some that are not quite as they should be
        decoder->err_recognition |= AV_EF_CRCCHECK | AV_EF_EXPLODE;
    libav::FramePtr picture(libav::allocated(av_frame_alloc()));
    const bool isWhole = codec && libav::checked(avcodec_open2(decoder.get(), codec, nullptr)) == 0 &&
                         libav::checked(avcodec_send_packet(decoder.get(), file.get())) == 0 &&
                         libav::checked(avcodec_receive_frame(decoder.get(), picture.get())) == 0 &&
                         picture->decode_error_flags == 0 && (picture->flags & AV_FRAME_FLAG_CORRUPT) == 0;
    file.reset(); // the decoder's own goes with it
    return isWhole ? std::move(picture) : nullptr;
}

/// Some rows in RGB; null where libswscale does not know the picture's own format.
libav::FramePtr withRgbPixels(const AVFrame &picture, int firstRow, int rows)
{
    libav::FramePtr rgb(libav::allocated(av_frame_alloc()));
    rgb->format = AV_PIX_FMT_RGB24;
    rgb->width = picture.width;
    rgb->height = rows;
    const std::unique_ptr<SwsContext, void (*)(SwsContext *)> scaler(
        sws_getContext(picture.width, rows, static_cast<AVPixelFormat>(picture.format), rgb->width, rows, AV_PIX_FMT_RGB24,
                       SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr),
        &sws_freeContext);
    const std::uint8_t *planes[AV_NUM_DATA_POINTERS] = {};
    const bool hasPalette = (av_pix_fmt_desc_get(static_cast<AVPixelFormat>(picture.format))->flags & AV_PIX_FMT_FLAG_PAL) != 0;
    for (int i = 0; i < AV_NUM_DATA_POINTERS && picture.data[i]; ++i)
        planes[i] = picture.data[i] + (hasPalette && i == 1 ? 0 : std::ptrdiff_t(firstRow) * picture.linesize[i]);
    const bool isDone = scaler && libav::checked(av_frame_get_buffer(rgb.get(), 0)) == 0 &&
                        libav::checked(sws_scale(scaler.get(), planes, picture.linesize, 0, rows, rgb->data, rgb->linesize)) == rows;
    return isDone ? std::move(rgb) : nullptr;
}

/// BT.601 at full range as JFIF 1.02 defines it, in 16-bit fixed point.
void convertRow(const std::uint8_t *rgb, int width, std::uint8_t *y, std::uint8_t *u, std::uint8_t *v)
{
    constexpr int half = 1 << 15, middle = (128 << 16) + half - 1; // -1 keeps pure blue and red at 255
    for (int x = 0; x < width; ++x, rgb += 3) {
        const int r = rgb[0], g = rgb[1], b = rgb[2];
        y[x] = static_cast<std::uint8_t>((19595 * r + 38470 * g + 7471 * b + half) >> 16);
        u[x] = static_cast<std::uint8_t>((-11059 * r - 21709 * g + 32768 * b + middle) >> 16);
        v[x] = static_cast<std::uint8_t>((32768 * r - 27439 * g - 5329 * b + middle) >> 16);
    }
}

FrameFormat formatOf(const AVFrame &picture)
{
    FrameFormat format;
    format.width = picture.width;
    format.height = picture.height;
    format.chromaShiftX = format.chromaShiftY = 0;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

std::optional<Frame> fromLibav(libav::FramePtr picture)
{
    if (!picture)
        return std::nullopt;
    FrameFormat format = formatOf(*picture);
    if (setChromaShifts(static_cast<AVPixelFormat>(picture->format), format))
        return frameOf(std::move(picture), format);
    const AVPixFmtDescriptor *pixels = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(picture->format));
    if (!pixels)
        return std::nullopt;
    constexpr int band = 256; // rows at a time, where none takes chroma of another; a multiple of eight, as dithering is
    const int mostRows = pixels->log2_chroma_h == 0 ? band : format.height;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int first = 0; first < format.height; first += mostRows) {
        const int rows = std::min(mostRows, format.height - first);
        const libav::FramePtr rgb = withRgbPixels(*picture, first, rows);
        if (!rgb)
            return std::nullopt;
        for (int y = first; y < first + rows; ++y)
            convertRow(rgb->data[0] + std::ptrdiff_t(y - first) * rgb->linesize[0], format.width, buffer->yRow(y),
                       buffer->uRow(y), buffer->vRow(y));
    }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

/// Whether the end of the picture follows its last scan (ITU-T T.81 §B.1.1): libavcodec fills what is missing
/// with grey.
bool hasItsEnd(Bytes jpeg)
{
    const std::string_view text(reinterpret_cast<const char *>(jpeg.data()), jpeg.size());
    const std::size_t scan = text.rfind("\xff\xda"), end = text.rfind("\xff\xd9");
    return scan != std::string_view::npos && end != std::string_view::npos && scan < end;
}

/// As the pictures of a video: what is suitable by libjpeg-turbo, which tells what is damaged.
std::optional<Frame> decodeJpeg(libav::PacketPtr file, const PictureHeader &header)
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
    return isCut ? std::nullopt : fromLibav(decodedByLibav(std::move(file), PictureFormat::Bmp));
}

std::optional<Frame> decode(libav::PacketPtr file, const PictureHeader &header)
{
    switch (header.format) {
    case PictureFormat::Jpeg:
        return decodeJpeg(std::move(file), header);
    case PictureFormat::Bmp:
        return decodeBmp(std::move(file));
    default:
        return fromLibav(decodedByLibav(std::move(file), header.format));
    }
}

Result<Frame> readPictureChecked(const std::filesystem::path &file)
{
    auto packet = readFile(file);
    if (!packet)
        return tl::unexpected(packet.error());
    const auto header = pictureHeader(bytesOf(*packet));
    if (!header)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "it is no PNG, JPEG, BMP, TIFF or PNM picture",
                    "convert it to PNG or JPEG");
    if (libav::isTooLarge(header->width, header->height) || std::int64_t(header->width) * header->height > mostPicturePixels)
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    "it says that it has " + std::to_string(header->width) + "x" +
                        std::to_string(header->height) + " pixels; more than 50 megapixels or 32000 pixels a side are not read",
                    "make it smaller");
    auto frame = decode(std::move(*packet), *header);
    if (!frame)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "its content is damaged or cut short",
                    "copy it again");
    return std::move(*frame);
}

} // namespace

Result<Frame> readPicture(const std::filesystem::path &file)
{
    return orShortage(cannotRead(file), [&file] { return readPictureChecked(file); });
}

} // namespace odo
