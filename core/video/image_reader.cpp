// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image_reader.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/video/internal/header_number.h"
#include "core/video/internal/stream_format.h"
#include "core/video/internal/tiff.h"
#include "core/video/jpeg.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
extern "C" {
#include <libavutil/intreadwrite.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
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
    case ImageFormat::Tiff:
        return AV_CODEC_ID_TIFF;
    case ImageFormat::Pbm:
        return AV_CODEC_ID_PBM;
    case ImageFormat::Pgm:
        return AV_CODEC_ID_PGM;
    case ImageFormat::Ppm:
        return AV_CODEC_ID_PPM;
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

/// Some rows in RGB; null where libswscale does not know the image's own format.
libav::FramePtr withRgbPixels(const AVFrame &image, int firstRow, int rows)
{
    libav::FramePtr rgb(libav::allocated(av_frame_alloc()));
    rgb->format = AV_PIX_FMT_RGB24;
    rgb->width = image.width;
    rgb->height = rows;
    const std::unique_ptr<SwsContext, void (*)(SwsContext *)> scaler(
        sws_getContext(image.width, rows, static_cast<AVPixelFormat>(image.format), rgb->width, rows,
                       AV_PIX_FMT_RGB24, SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr,
                       nullptr, nullptr),
        &sws_freeContext);
    const std::uint8_t *planes[AV_NUM_DATA_POINTERS] = {};
    const bool hasPalette =
        (av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format))->flags & AV_PIX_FMT_FLAG_PAL) != 0;
    for (int i = 0; i < AV_NUM_DATA_POINTERS && image.data[i]; ++i)
        planes[i] = image.data[i] + (hasPalette && i == 1 ? 0 : std::ptrdiff_t(firstRow) * image.linesize[i]);
    const bool isDone = scaler && libav::checked(av_frame_get_buffer(rgb.get(), 0)) == 0 &&
                        libav::checked(sws_scale(scaler.get(), planes, image.linesize, 0, rows, rgb->data,
                                                 rgb->linesize)) == rows;
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

FrameFormat formatOf(const AVFrame &image)
{
    FrameFormat format;
    format.width = image.width;
    format.height = image.height;
    format.chromaShiftX = format.chromaShiftY = 0;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

std::optional<Frame> fromLibav(libav::FramePtr image)
{
    if (!image)
        return std::nullopt;
    FrameFormat format = formatOf(*image);
    if (setChromaShifts(static_cast<AVPixelFormat>(image->format), format))
        return frameOf(std::move(image), format);
    const AVPixFmtDescriptor *pixels = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image->format));
    if (!pixels)
        return std::nullopt;
    // rows at a time, where none takes chroma of another; a multiple of eight, as dithering is
    constexpr int band = 256;
    const int mostRows = pixels->log2_chroma_h == 0 ? band : format.height;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int first = 0; first < format.height; first += mostRows) {
        const int rows = std::min(mostRows, format.height - first);
        const libav::FramePtr rgb = withRgbPixels(*image, first, rows);
        if (!rgb)
            return std::nullopt;
        for (int y = first; y < first + rows; ++y)
            convertRow(rgb->data[0] + std::ptrdiff_t(y - first) * rgb->linesize[0], format.width,
                       buffer->yRow(y), buffer->uRow(y), buffer->vRow(y));
    }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
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

std::optional<Frame> decode(libav::PacketPtr file, const ImageHeader &header)
{
    switch (header.format) {
    case ImageFormat::Jpeg:
        return decodeJpeg(std::move(file), header);
    case ImageFormat::Bmp:
        return decodeBmp(std::move(file));
    case ImageFormat::Tiff:
        keepPixelTags({file->data, static_cast<std::size_t>(file->size)});
        break;
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
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    ODO_TEXT("video.no_picture_format", "it is not a PNG, JPEG, BMP, TIFF or PNM image"),
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
    auto frame = decode(std::move(packet), *header);
    if (!frame)
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    ODO_TEXT("video.picture_damaged", "its content is damaged or cut short"),
                    ODO_TEXT("video.copy_again", "copy it again"));
    return std::move(*frame);
}

} // namespace

Result<Frame> readImage(const std::filesystem::path &file)
{
    return orShortage(cannotRead(file), [&file] { return readImageChecked(file); });
}

namespace {

bool startsWith(Bytes file, std::string_view magic)
{
    return std::string_view(reinterpret_cast<const char *>(file.data()), file.size()).starts_with(magic);
}

/// Walks the segments up to the first start of frame (ITU-T T.81 §B.1). A stuffed zero (ff 00) is no marker:
/// a decoder would search for the next one among the bytes that it would cover as a segment.
StatedSize jpegSize(Bytes file)
{
    std::size_t at = 2;
    while (at + 9 < file.size()) {
        const std::uint8_t marker = file[at + 1];
        if (file[at] != 0xff || marker == 0x00)
            return {};
        if (marker == 0xff || marker == 0x01 ||
            (marker >= 0xd0 && marker <= 0xd7)) { // fill byte or bare marker
            at += marker == 0xff ? 1 : 2;
            continue;
        }
        const bool startOfFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (startOfFrame)
            return {numberAt(file, at + 7, 2, true), numberAt(file, at + 5, 2, true)};
        at += 2 + numberAt(file, at + 2, 2, true);
    }
    return {};
}

/// "P5 640 480 255", with comments from # to the end of a line. The magic and each number end with white
/// space (the Netpbm formats' own rule): where they do not, decoders disagree on what is a comment.
StatedSize pnmSize(Bytes file)
{
    std::uint32_t numbers[2] = {};
    std::size_t at = 2;
    const auto isSpace = [&] { return at < file.size() && std::isspace(file[at]) != 0; };
    for (std::uint32_t &value : numbers) {
        if (!isSpace())
            return {};
        while (isSpace() || (at < file.size() && file[at] == '#'))
            if (file[at++] == '#')
                while (at < file.size() && file[at] != '\n' && file[at] != '\r')
                    ++at;
        for (int digits = 0; at < file.size() && std::isdigit(file[at]) != 0 && digits < 9; ++at, ++digits)
            value = value * 10 + (file[at] - '0');
    }
    return isSpace() ? StatedSize{numbers[0], numbers[1]} : StatedSize{};
}

/// Rows from the top have a negative height.
StatedSize bmpSize(Bytes file)
{
    const auto height = static_cast<std::int32_t>(numberAt(file, 22, 4, false));
    return {numberAt(file, 18, 4, false),
            static_cast<std::uint32_t>(height < 0 ? -std::int64_t(height) : height)};
}

ImageHeader header(ImageFormat format, StatedSize size)
{
    return {format, size.width, size.height};
}

ImageHeader statedHeader(Bytes file)
{
    using namespace std::string_view_literals;
    if (startsWith(file, "\x89PNG\r\n\x1a\n"sv))
        return header(ImageFormat::Png, {numberAt(file, 16, 4, true), numberAt(file, 20, 4, true)});
    if (startsWith(file, "\xff\xd8\xff"sv))
        return header(ImageFormat::Jpeg, jpegSize(file));
    if (startsWith(file, "BM"sv))
        return header(ImageFormat::Bmp, bmpSize(file));
    if (startsWith(file, "II*\0"sv) || startsWith(file, "MM\0*"sv))
        return header(ImageFormat::Tiff, tiffSize(file));
    if (file.size() > 2 && file[0] == 'P' && file[1] >= '1' && file[1] <= '6') {
        constexpr ImageFormat formats[] = {ImageFormat::Pbm, ImageFormat::Pgm, ImageFormat::Ppm};
        return header(formats[(file[1] - '1') % 3], pnmSize(file));
    }
    return {};
}

} // namespace

std::optional<ImageHeader> imageHeader(Bytes file)
{
    const ImageHeader stated = statedHeader(file);
    return stated.width > 0 && stated.height > 0 ? std::optional(stated) : std::nullopt;
}

} // namespace odo
