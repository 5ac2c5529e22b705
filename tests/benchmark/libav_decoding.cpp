// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/libav_decoding.h"

#include "core/video/internal/libav.h"
#include "tests/benchmark/cpu_clock.h"

namespace odo::test {

namespace {

struct CloseInput
{
    void operator()(AVFormatContext *input) const { avformat_close_input(&input); }
};

} // namespace

PureDecoding decodeByLibavcodec(const std::filesystem::path &file)
{
    PureDecoding result;
    AVFormatContext *opened = nullptr;
    if (avformat_open_input(&opened, file.c_str(), nullptr, nullptr) < 0)
        return result;
    const std::unique_ptr<AVFormatContext, CloseInput> input(opened);
    const AVCodec *codec = nullptr;
    if (avformat_find_stream_info(opened, nullptr) < 0)
        return result;
    const int stream = av_find_best_stream(opened, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
    if (stream < 0)
        return result;
    const libav::CodecPtr decoder(avcodec_alloc_context3(codec));
    avcodec_parameters_to_context(decoder.get(), opened->streams[stream]->codecpar);
    decoder->thread_count = 1;
    if (avcodec_open2(decoder.get(), codec, nullptr) < 0)
        return result;
    const libav::PacketPtr packet(av_packet_alloc());
    const libav::FramePtr image(av_frame_alloc());
    const double begin = threadCpuS();
    for (bool more = true; more;) {
        more = av_read_frame(opened, packet.get()) >= 0;
        if (more && packet->stream_index != stream) {
            av_packet_unref(packet.get());
            continue;
        }
        avcodec_send_packet(decoder.get(), more ? packet.get() : nullptr);
        av_packet_unref(packet.get());
        while (avcodec_receive_frame(decoder.get(), image.get()) == 0)
            ++result.frames;
    }
    result.seconds = threadCpuS() - begin;
    return result;
}

} // namespace odo::test
