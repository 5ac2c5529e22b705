// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/video/foreign_files.h"

#include "core/video/internal/libav.h"

#include <algorithm>
#include <cstring>
#include <functional>

extern "C" {
#include <libavutil/pixdesc.h>
}

namespace odo::test {

namespace {

/// A container being written; closed when it goes.
struct Output
{
    explicit Output(const std::filesystem::path &to)
    {
        libav::quieten();
        avformat_alloc_output_context2(&container, nullptr, nullptr, to.c_str());
        if (container && avio_open(&container->pb, to.c_str(), AVIO_FLAG_WRITE) < 0)
            container->pb = nullptr;
    }
    ~Output()
    {
        if (container && container->pb)
            avio_closep(&container->pb);
        avformat_free_context(container);
    }
    AVFormatContext *container = nullptr;
};

void fill(AVFrame &image, int number)
{
    for (int plane = 0; plane < 4 && image.data[plane]; ++plane) {
        const bool chroma = plane > 0;
        const bool pairs = chroma && image.format == AV_PIX_FMT_NV12;
        const int height = chroma ? image.height / 2 : image.height;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < (pairs ? image.width : image.linesize[plane]); ++x)
                image.data[plane][static_cast<std::ptrdiff_t>(y) * image.linesize[plane] + x] =
                    static_cast<std::uint8_t>(40 + 20 * plane + number + (pairs && x % 2 != 0 ? 100 : 0));
    }
}

void shiftBottomField(AVFrame &image)
{
    for (int plane = 0; plane < 4 && image.data[plane]; ++plane)
        for (int y = 1; y < (plane > 0 ? image.height / 2 : image.height); y += 2)
            for (int x = 0; x < image.linesize[plane]; ++x)
                image.data[plane][static_cast<std::ptrdiff_t>(y) * image.linesize[plane] + x] += 50;
}

/// AVI's muxer wants start codes and does not ask for them itself, as others do.
libav::FilterPtr annexBFilter(const AVCodecParameters &parameters, bool needed)
{
    AVBSFContext *filter = nullptr;
    av_bsf_alloc(av_bsf_get_by_name(needed ? "h264_mp4toannexb" : "null"), &filter);
    avcodec_parameters_copy(filter->par_in, &parameters);
    av_bsf_init(filter);
    return libav::FilterPtr(filter);
}

bool encodeTo(Output &out, AVCodecContext &encoder, AVFrame *image)
{
    if (avcodec_send_frame(&encoder, image) < 0)
        return false;
    const libav::PacketPtr packet(av_packet_alloc());
    while (avcodec_receive_packet(&encoder, packet.get()) == 0) {
        av_packet_rescale_ts(packet.get(), encoder.time_base, out.container->streams[0]->time_base);
        if (av_write_frame(out.container, packet.get()) < 0)
            return false;
    }
    return true;
}

void setDisplayMatrix(AVStream &stream, const std::array<int, 4> &turn)
{
    constexpr std::int32_t one = 1 << 16, last = 1 << 30; // fixed point, 16 and 30 bits behind it
    const std::array<std::int32_t, 9> matrix{
        one * turn[0], one * turn[1], 0, one * turn[2], one * turn[3], 0, 0, 0, last};
    if (std::uint8_t *data = av_stream_new_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, sizeof(matrix)))
        std::memcpy(data, matrix.data(), sizeof(matrix));
}

constexpr int silenceRate = 8000;

void addSilence(AVFormatContext &container)
{
    AVStream *stream = avformat_new_stream(&container, nullptr);
    stream->codecpar->codec_type = AVMEDIA_TYPE_AUDIO;
    stream->codecpar->codec_id = AV_CODEC_ID_PCM_S16LE;
    stream->codecpar->sample_rate = silenceRate;
    stream->codecpar->format = AV_SAMPLE_FMT_S16;
    av_channel_layout_default(&stream->codecpar->ch_layout, 1);
    stream->codecpar->bits_per_coded_sample = 16;
    stream->codecpar->block_align = 2;
    stream->time_base = {1, silenceRate};
}

/// As long as a frame.
bool writeSilence(AVFormatContext &container, AVRational frameRate)
{
    AVStream *stream = container.streams[1];
    const auto samples = static_cast<int>(av_rescale_q(1, av_inv_q(frameRate), {1, silenceRate}));
    const libav::PacketPtr packet(av_packet_alloc());
    if (av_new_packet(packet.get(), 2 * samples) < 0)
        return false;
    std::memset(packet->data, 0, static_cast<std::size_t>(packet->size));
    packet->stream_index = 1;
    packet->pts = packet->dts = stream->nb_frames > 0 ? AV_NOPTS_VALUE : 0;
    packet->duration = samples;
    packet->flags = AV_PKT_FLAG_KEY;
    return av_interleaved_write_frame(&container, packet.get()) >= 0;
}

} // namespace

bool remux(const std::filesystem::path &from, const std::filesystem::path &to, const std::array<int, 4> &turn,
           const std::string &recordedAt, bool withSound)
{
    AVFormatContext *input = nullptr;
    if (avformat_open_input(&input, from.c_str(), nullptr, nullptr) < 0)
        return false;
    avformat_find_stream_info(input, nullptr);
    Output out(to);
    bool good = out.container && out.container->pb;
    if (good) {
        AVStream *stream = avformat_new_stream(out.container, nullptr);
        avcodec_parameters_copy(stream->codecpar, input->streams[0]->codecpar);
        stream->codecpar->codec_tag = 0;
        stream->avg_frame_rate = input->streams[0]->avg_frame_rate;
        stream->time_base = av_inv_q(stream->avg_frame_rate);
        if (turn != std::array<int, 4>{})
            setDisplayMatrix(*stream, turn);
        if (!recordedAt.empty())
            av_dict_set(&out.container->metadata, "creation_time", recordedAt.c_str(), 0);
        if (withSound)
            addSilence(*out.container);
        good = avformat_write_header(out.container, nullptr) >= 0;
        const libav::FilterPtr startCodes =
            annexBFilter(*input->streams[0]->codecpar, to.extension() == ".avi");
        const libav::PacketPtr packet(av_packet_alloc());
        while (good && av_read_frame(input, packet.get()) >= 0) {
            good = av_bsf_send_packet(startCodes.get(), packet.get()) >= 0 &&
                   av_bsf_receive_packet(startCodes.get(), packet.get()) >= 0;
            av_packet_rescale_ts(packet.get(), input->streams[0]->time_base, stream->time_base);
            good = av_interleaved_write_frame(out.container, packet.get()) >= 0;
            good = good && (!withSound || writeSilence(*out.container, stream->avg_frame_rate));
        }
        good = good && av_write_trailer(out.container) >= 0;
    }
    avformat_close_input(&input);
    return good;
}

bool writeRaw(const std::filesystem::path &to, const RawVideo &video)
{
    Output out(to);
    const AVCodec *codec = avcodec_find_encoder_by_name(video.encoder.c_str());
    if (!out.container || !out.container->pb || !codec)
        return false;
    const libav::CodecPtr encoder(avcodec_alloc_context3(codec));
    encoder->width = video.width;
    encoder->height = video.height;
    encoder->time_base = {1, video.ticksPerSecond};
    encoder->framerate = {video.ticksPerSecond, 1};
    encoder->pix_fmt = av_get_pix_fmt(video.pixelFormat.c_str());
    if (video.isInterlaced) {
        encoder->flags |= AV_CODEC_FLAG_INTERLACED_DCT | AV_CODEC_FLAG_INTERLACED_ME;
        encoder->field_order = AV_FIELD_TT;
    }
    encoder->color_range = static_cast<AVColorRange>(video.range);
    encoder->colorspace = static_cast<AVColorSpace>(video.matrix);
    encoder->color_trc = static_cast<AVColorTransferCharacteristic>(video.transfer);
    libav::Options coding, muxing;
    for (const auto &[name, value] : video.coding)
        coding.set(name, value);
    for (const auto &[name, value] : video.muxing)
        muxing.set(name, value);
    encoder->sample_aspect_ratio = {video.aspectWidth, video.aspectHeight};
    if ((out.container->oformat->flags & AVFMT_GLOBALHEADER) != 0)
        encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (avcodec_open2(encoder.get(), codec, coding.get()) < 0)
        return false;
    AVStream *stream = avformat_new_stream(out.container, nullptr);
    avcodec_parameters_from_context(stream->codecpar, encoder.get());
    stream->avg_frame_rate = encoder->framerate;
    stream->time_base = encoder->time_base;
    stream->sample_aspect_ratio = encoder->sample_aspect_ratio;
    if (video.turn != std::array<int, 4>{})
        setDisplayMatrix(*stream, video.turn);
    for (const auto &[name, value] : video.metadata)
        av_dict_set(&out.container->metadata, name, value, 0);
    bool good = avformat_write_header(out.container, muxing.get()) >= 0;
    for (int i = 0; good && i < video.frames; ++i) {
        const libav::FramePtr image(av_frame_alloc());
        image->format = encoder->pix_fmt;
        image->width = encoder->width;
        image->height = encoder->height;
        image->pts = video.ticks.empty() ? i * video.interval : video.ticks[std::size_t(i)];
        good = av_frame_get_buffer(image.get(), 0) >= 0;
        video.fill(*image, i);
        image->interlaced_frame = image->top_field_first = video.isInterlaced ? 1 : 0;
        good = good && encodeTo(out, *encoder, image.get());
    }
    return good && encodeTo(out, *encoder, nullptr) && av_write_trailer(out.container) >= 0;
}

bool writeRaw(const std::filesystem::path &to, const std::string &encoderName, const std::string &pixelFormat,
              int frames, std::int64_t interval, int width, int ticksPerSecond, bool isInterlaced)
{
    return writeRaw(to, {encoderName, pixelFormat, frames, width, width * 3 / 4, ticksPerSecond, interval,
                         isInterlaced, [isInterlaced](AVFrame &image, int number) {
                             fill(image, number);
                             if (isInterlaced)
                                 shiftBottomField(image);
                         }});
}

bool writeLuma(const std::filesystem::path &to, const std::vector<Frame> &frames, bool isInterlaced)
{
    const PlaneView &first = frames.front().y;
    return writeRaw(to, {"ffv1", "gray", int(frames.size()), first.width, first.height, 25, 1, isInterlaced,
                         [&frames](AVFrame &image, int number) {
                             const PlaneView &luma = frames[std::size_t(number)].y;
                             for (int y = 0; y < luma.height; ++y)
                                 std::copy_n(luma.row(y), luma.width,
                                             image.data[0] + std::ptrdiff_t(y) * image.linesize[0]);
                         }});
}

} // namespace odo::test
