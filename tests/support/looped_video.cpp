// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/looped_video.h"

#include "core/video/internal/libav.h"

#include <algorithm>
#include <vector>

namespace odo::test {

namespace {

struct CloseInput
{
    void operator()(AVFormatContext *input) const { avformat_close_input(&input); }
};
struct CloseOutput
{
    void operator()(AVFormatContext *output) const
    {
        avio_closep(&output->pb);
        avformat_free_context(output);
    }
};
using Output = std::unique_ptr<AVFormatContext, CloseOutput>;

Output openOutput(const std::filesystem::path &to, const AVStream &like)
{
    AVFormatContext *opened = nullptr;
    avformat_alloc_output_context2(&opened, nullptr, nullptr, to.c_str());
    Output output(opened);
    if (!output || avio_open(&output->pb, to.c_str(), AVIO_FLAG_WRITE) < 0)
        return nullptr;
    AVStream *stream = avformat_new_stream(output.get(), nullptr);
    avcodec_parameters_copy(stream->codecpar, like.codecpar);
    stream->codecpar->codec_tag = 0;
    stream->time_base = like.time_base;
    return avformat_write_header(output.get(), nullptr) < 0 ? nullptr : std::move(output);
}

/// How long one round lasts, in the stream's own units.
std::int64_t lengthOf(const std::vector<libav::PacketPtr> &packets)
{
    std::vector<std::int64_t> times;
    for (const libav::PacketPtr &packet : packets)
        times.push_back(packet->pts);
    std::sort(times.begin(), times.end());
    return 2 * times.back() - times[times.size() - 2] - times.front();
}

} // namespace

bool loopVideo(const std::filesystem::path &from, const std::filesystem::path &to, int times)
{
    AVFormatContext *opened = nullptr;
    if (avformat_open_input(&opened, from.c_str(), nullptr, nullptr) < 0)
        return false;
    const std::unique_ptr<AVFormatContext, CloseInput> input(opened);
    if (avformat_find_stream_info(opened, nullptr) < 0)
        return false;
    std::vector<libav::PacketPtr> packets;
    for (libav::PacketPtr packet(av_packet_alloc()); av_read_frame(opened, packet.get()) >= 0;
         packet.reset(av_packet_alloc())) {
        if (packet->stream_index == 0)
            packets.push_back(std::move(packet));
    }
    const AVStream &stream = *opened->streams[0];
    const Output output = packets.size() < 2 ? nullptr : openOutput(to, stream);
    if (!output)
        return false;
    const std::int64_t length = lengthOf(packets);
    const libav::PacketPtr copy(av_packet_alloc());
    for (int round = 0; round < times; ++round) {
        for (const libav::PacketPtr &packet : packets) {
            av_packet_ref(copy.get(), packet.get());
            copy->pts += round * length;
            copy->dts += round * length;
            av_packet_rescale_ts(copy.get(), stream.time_base, output->streams[0]->time_base);
            if (av_interleaved_write_frame(output.get(), copy.get()) < 0)
                return false;
        }
    }
    return av_write_trailer(output.get()) == 0;
}

} // namespace odo::test
