// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/video/jpeg_images.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <jpeglib.h>
#include <stdexcept>

extern "C" {
#include <libavcodec/avcodec.h>
}

namespace odo::test {

std::vector<std::uint8_t> jpegOf(const FrameFormat &format, const JpegWay &way)
{
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    // More than noise of the best quality takes, so that the library never makes a larger one.
    std::vector<std::uint8_t> coded(4096 + 6 * static_cast<std::size_t>(format.width) *
                                               static_cast<std::size_t>(format.height));
    unsigned char *bytes = coded.data();
    unsigned long size = coded.size();
    jpeg_mem_dest(&encoder, &bytes, &size);
    encoder.image_width = static_cast<JDIMENSION>(format.width);
    encoder.image_height = static_cast<JDIMENSION>(format.height);
    encoder.input_components = 3;
    encoder.in_color_space = JCS_RGB;
    jpeg_set_defaults(&encoder);
    jpeg_set_colorspace(&encoder, way.grey ? JCS_GRAYSCALE : JCS_YCbCr);
    jpeg_set_quality(&encoder, 90, TRUE);
    encoder.comp_info[0].h_samp_factor = 1 << format.chromaShiftX;
    encoder.comp_info[0].v_samp_factor = 1 << format.chromaShiftY;
    encoder.restart_in_rows = way.restartRows;
    if (way.progressive)
        jpeg_simple_progression(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    std::vector<JSAMPLE> line(3 * static_cast<std::size_t>(format.width));
    unsigned state = 7;
    for (int y = 0; y < format.height; ++y) {
        for (int x = 0; x < format.width; ++x) {
            state = state * 1664525U + 1013904223U;
            const double wave = std::sin(x * 0.13) * std::cos(y * 0.09), noise = (state >> 24) / 8.0;
            JSAMPLE *pixel = &line[3 * static_cast<std::size_t>(x)];
            pixel[0] = static_cast<JSAMPLE>(110 + 90 * wave + noise);
            pixel[1] = static_cast<JSAMPLE>(100 + 60 * std::sin(x * 0.31 + y * 0.2) + noise);
            pixel[2] = static_cast<JSAMPLE>((x / 9 + y / 7) % 2 == 0 ? 220 : 30);
        }
        JSAMPROW row = line.data();
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    if (bytes != coded.data())
        throw std::length_error("a picture that takes more than was thought of");
    coded.resize(size);
    return coded;
}

std::vector<std::uint8_t> withoutHuffmanTables(const std::vector<std::uint8_t> &jpeg)
{
    constexpr std::uint8_t tables = 0xc4, scan = 0xda;
    std::vector<std::uint8_t> bare(jpeg.begin(), jpeg.begin() + 2);
    std::size_t at = 2;
    while (jpeg[at + 1] != scan) {
        const std::size_t length = 2 + (jpeg[at + 2] << 8 | jpeg[at + 3]);
        if (jpeg[at + 1] != tables)
            bare.insert(bare.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(at),
                        jpeg.begin() + static_cast<std::ptrdiff_t>(at + length));
        at += length;
    }
    bare.insert(bare.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(at), jpeg.end());
    return bare;
}

Frame decodedByLibavcodec(const std::vector<std::uint8_t> &jpeg, const FrameFormat &format)
{
    AVCodecContext *decoder = avcodec_alloc_context3(avcodec_find_decoder(AV_CODEC_ID_MJPEG));
    avcodec_open2(decoder, nullptr, nullptr);
    AVPacket *packet = av_packet_alloc();
    av_new_packet(packet, static_cast<int>(jpeg.size()));
    std::memcpy(packet->data, jpeg.data(), jpeg.size());
    const std::shared_ptr<AVFrame> image(av_frame_alloc(), [](AVFrame *old) { av_frame_free(&old); });
    Frame frame;
    if (avcodec_send_packet(decoder, packet) == 0 && avcodec_receive_frame(decoder, image.get()) == 0) {
        const int chromaWidth = (format.width + (1 << format.chromaShiftX) - 1) >> format.chromaShiftX;
        const int chromaHeight = (format.height + (1 << format.chromaShiftY) - 1) >> format.chromaShiftY;
        frame.format = format;
        frame.y = {image->data[0], format.width, format.height, image->linesize[0]};
        frame.u = {image->data[1], chromaWidth, chromaHeight, image->linesize[1]};
        frame.v = {image->data[2], chromaWidth, chromaHeight, image->linesize[2]};
        frame.owner = image;
    }
    av_packet_free(&packet);
    avcodec_free_context(&decoder);
    return frame;
}

} // namespace odo::test
