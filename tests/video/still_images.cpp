// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/video/still_images.h"

#include "core/video/internal/libav.h"

#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <jpeglib.h>
#include <libheif/heif.h>
#include <tiffio.h>
extern "C" {
#include <libavutil/imgutils.h>
#include <libswscale/swscale.h>
}

namespace odo::test {

RgbImage fourQuarters(int width, int height)
{
    constexpr std::array<std::array<int, 3>, 4> colours{
        {{40, 60, 90}, {200, 120, 80}, {90, 160, 60}, {210, 215, 190}}};
    RgbImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : colours[std::size_t((2 * y >= height ? 2 : 0) + (2 * x >= width ? 1 : 0))])
                image.rgb.push_back(std::uint8_t(value + 20 * x / width));
    return image;
}

RgbImage storedFor(const RgbImage &shown, int orientation)
{
    const bool swaps = orientation >= 5;
    RgbImage stored{swaps ? shown.height : shown.width, swaps ? shown.width : shown.height, {}};
    const int right = shown.width - 1, bottom = shown.height - 1;
    for (int row = 0; row < stored.height; ++row) {
        for (int column = 0; column < stored.width; ++column) {
            // of the pixel in this row and column, when shown: rows from the top, bottom, left or right
            const std::array<std::array<int, 2>, 8> positions{{{column, row},
                                                               {right - column, row},
                                                               {right - column, bottom - row},
                                                               {column, bottom - row},
                                                               {row, column},
                                                               {right - row, column},
                                                               {right - row, bottom - column},
                                                               {row, bottom - column}}};
            const auto [x, y] = positions[std::size_t(orientation - 1)];
            stored.rgb.insert(stored.rgb.end(), shown.at(x, y), shown.at(x, y) + 3);
        }
    }
    return stored;
}

Bytes codedByLibav(const RgbImage &image, const std::string &encoder, const std::string &pixelFormat,
                   const std::string &options)
{
    libav::quieten();
    const AVCodec *codec = avcodec_find_encoder_by_name(encoder.c_str());
    if (!codec)
        return {};
    const libav::CodecPtr context(avcodec_alloc_context3(codec));
    context->width = image.width;
    context->height = image.height;
    context->pix_fmt = av_get_pix_fmt(pixelFormat.c_str());
    context->time_base = {1, 1};
    context->flags |= AV_CODEC_FLAG_QSCALE;
    context->global_quality = FF_QP2LAMBDA;
    libav::Options chosen;
    av_dict_parse_string(chosen.get(), options.c_str(), "=", ",", 0);
    const libav::FramePtr frame(av_frame_alloc());
    frame->width = image.width;
    frame->height = image.height;
    frame->format = context->pix_fmt;
    frame->quality = context->global_quality;
    const libav::PacketPtr packet(av_packet_alloc());
    SwsContext *scaler = sws_getContext(
        image.width, image.height, AV_PIX_FMT_RGB24, image.width, image.height, context->pix_fmt,
        SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP, nullptr, nullptr, nullptr);
    const std::uint8_t *rows[] = {image.rgb.data()};
    const int strides[] = {3 * image.width};
    if (!scaler || av_frame_get_buffer(frame.get(), 0) < 0)
        return {};
    sws_scale(scaler, rows, strides, 0, image.height, frame->data, frame->linesize);
    sws_freeContext(scaler);
    if (avcodec_open2(context.get(), codec, chosen.get()) < 0 ||
        avcodec_send_frame(context.get(), frame.get()) < 0)
        return {};
    avcodec_send_frame(context.get(), nullptr);
    if (avcodec_receive_packet(context.get(), packet.get()) < 0)
        return {};
    return {packet->data, packet->data + packet->size};
}

Bytes heicOf(const RgbImage &image, int orientation)
{
    Bytes bytes;
    heif_context *context = heif_context_alloc();
    heif_encoder *encoder = nullptr;
    heif_image *pixels = nullptr;
    if (heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder).code == heif_error_Ok) {
        heif_encoder_set_lossy_quality(encoder, 95);
        heif_image_create(image.width, image.height, heif_colorspace_RGB, heif_chroma_interleaved_RGB,
                          &pixels);
        heif_image_add_plane(pixels, heif_channel_interleaved, image.width, image.height, 8);
        int stride = 0;
        std::uint8_t *to = heif_image_get_plane(pixels, heif_channel_interleaved, &stride);
        for (int y = 0; y < image.height; ++y)
            std::copy_n(image.at(0, y), 3 * image.width, to + std::ptrdiff_t(y) * stride);
        heif_encoding_options *options = heif_encoding_options_alloc();
        options->image_orientation = heif_orientation(orientation);
        heif_context_encode_image(context, pixels, encoder, options, nullptr);
        heif_writer writer{1, [](heif_context *, const void *data, std::size_t size, void *to_) {
                               const auto *from = static_cast<const std::uint8_t *>(data);
                               static_cast<Bytes *>(to_)->assign(from, from + size);
                               return heif_error{heif_error_Ok, heif_suberror_Unspecified, ""};
                           }};
        heif_context_write(context, &writer, &bytes);
        heif_encoding_options_free(options);
        heif_image_release(pixels);
        heif_encoder_release(encoder);
    }
    heif_context_free(context);
    return bytes;
}

Bytes tiledTiffOf(const RgbImage &image)
{
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("tiled.tiff")).toStdString();
    TIFF *tiff = TIFFOpen(file.c_str(), "w");
    constexpr int side = 64;
    for (const auto &[tag, value] : {std::pair(TIFFTAG_IMAGEWIDTH, image.width),
                                     {TIFFTAG_IMAGELENGTH, image.height},
                                     {TIFFTAG_TILEWIDTH, side},
                                     {TIFFTAG_TILELENGTH, side},
                                     {TIFFTAG_SAMPLESPERPIXEL, 3},
                                     {TIFFTAG_BITSPERSAMPLE, 8},
                                     {TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB},
                                     {TIFFTAG_COMPRESSION, COMPRESSION_LZW},
                                     {TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG}})
        TIFFSetField(tiff, std::uint32_t(tag), value);
    for (int top = 0; top < image.height; top += side) {
        for (int left = 0; left < image.width; left += side) {
            Bytes tile(3 * side * side);
            for (int y = top; y < std::min(top + side, image.height); ++y)
                std::copy_n(image.at(left, y), 3 * std::min(side, image.width - left),
                            tile.begin() + 3 * side * (y - top));
            TIFFWriteTile(tiff, tile.data(), std::uint32_t(left), std::uint32_t(top), 0, 0);
        }
    }
    TIFFClose(tiff);
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Bytes cmykJpegOf(const RgbImage &image, bool isYcck, bool isProgressive)
{
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char *memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &memory, &size);
    encoder.image_width = JDIMENSION(image.width);
    encoder.image_height = JDIMENSION(image.height);
    encoder.input_components = 4;
    encoder.in_color_space = JCS_CMYK;
    jpeg_set_defaults(&encoder);
    jpeg_set_colorspace(&encoder, isYcck ? JCS_YCCK : JCS_CMYK);
    jpeg_set_quality(&encoder, 95, TRUE);
    if (isProgressive)
        jpeg_simple_progression(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    for (int y = 0; y < image.height; ++y) {
        std::vector<JSAMPLE> line;
        for (int x = 0; x < image.width; ++x) {
            // inverted: 255 is no ink; black takes what is common to all
            const std::uint8_t *pixel = image.at(x, y);
            const int black = std::max({pixel[0], pixel[1], pixel[2], std::uint8_t(1)});
            for (int colour = 0; colour < 3; ++colour)
                line.push_back(JSAMPLE(pixel[colour] * 255 / black));
            line.push_back(JSAMPLE(black));
        }
        JSAMPROW row = line.data();
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    const Bytes bytes(memory, memory + size);
    std::free(memory);
    return bytes;
}

namespace {

/// A TIFF directory of one entry.
Bytes exifOf(int orientation, bool bigEndian)
{
    const auto value = std::uint8_t(orientation);
    return bigEndian
               ? Bytes{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 18, 0, 3, 0, 0, 0, 1, 0, value, 0, 0, 0, 0, 0, 0}
               : Bytes{'I', 'I', 42, 0, 8, 0,     0, 0, 1, 0, 18, 1, 3,
                       0,   1,   0,  0, 0, value, 0, 0, 0, 0, 0,  0, 0};
}

void append(Bytes &to, const Bytes &more)
{
    to.insert(to.end(), more.begin(), more.end());
}

/// CRC-32 of PNG's specification, annex D.
std::uint32_t checksum(const Bytes &bytes)
{
    std::uint32_t sum = 0xffffffff;
    for (const std::uint8_t byte : bytes) {
        sum ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum & 1) != 0 ? 0xedb88320U ^ (sum >> 1) : sum >> 1;
    }
    return ~sum;
}

Bytes bigEndianOf(std::uint32_t value)
{
    return {std::uint8_t(value >> 24), std::uint8_t(value >> 16), std::uint8_t(value >> 8),
            std::uint8_t(value)};
}

Bytes littleEndianOf(std::uint32_t value, int count)
{
    Bytes bytes;
    for (int i = 0; i < count; ++i)
        bytes.push_back(std::uint8_t(value >> 8 * i));
    return bytes;
}

} // namespace

Bytes jpegWithOrientation(const Bytes &jpeg, int orientation, bool bigEndian)
{
    Bytes segment{0xff, 0xe1, 0, 0, 'E', 'x', 'i', 'f', 0, 0};
    append(segment, exifOf(orientation, bigEndian));
    segment[3] = std::uint8_t(segment.size() - 2);
    Bytes result = jpeg;
    result.insert(result.begin() + 2, segment.begin(), segment.end());
    return result;
}

Bytes pngWithOrientation(const Bytes &png, int orientation)
{
    Bytes content{'e', 'X', 'I', 'f'};
    append(content, exifOf(orientation, true));
    Bytes chunk = bigEndianOf(std::uint32_t(content.size() - 4));
    append(chunk, content);
    append(chunk, bigEndianOf(checksum(content)));
    constexpr std::ptrdiff_t behindHeader = 8 + 25;
    Bytes result = png;
    result.insert(result.begin() + behindHeader, chunk.begin(), chunk.end());
    return result;
}

Bytes webpWithOrientation(const Bytes &webp, const RgbImage &image, int orientation)
{
    Bytes chunks{'W', 'E', 'B', 'P', 'V', 'P', '8', 'X', 10, 0, 0, 0, 0x08, 0, 0, 0};
    append(chunks, littleEndianOf(std::uint32_t(image.width - 1), 3));
    append(chunks, littleEndianOf(std::uint32_t(image.height - 1), 3));
    chunks.insert(chunks.end(), webp.begin() + 12, webp.end());
    const Bytes exif = exifOf(orientation, false);
    append(chunks, {'E', 'X', 'I', 'F'});
    append(chunks, littleEndianOf(std::uint32_t(exif.size()), 4));
    append(chunks, exif);
    Bytes result{'R', 'I', 'F', 'F'};
    append(result, littleEndianOf(std::uint32_t(chunks.size()), 4));
    append(result, chunks);
    return result;
}

} // namespace odo::test
