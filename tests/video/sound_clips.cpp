// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/video/sound_clips.h"

#include "core/video/internal/libav.h"

#include <algorithm>
#include <cmath>

namespace odo::test {

namespace {

constexpr int framesPerSecond = 30;

/// A file being written, of a video and a sound stream, and their coders.
class ClipWriter
{
public:
    ClipWriter(const std::filesystem::path &to, const SoundClip &clip) : m_clip(clip)
    {
        libav::quieten();
        avformat_alloc_output_context2(&m_container, nullptr, nullptr, to.c_str());
        m_good = m_container && avio_open(&m_container->pb, to.c_str(), AVIO_FLAG_WRITE) >= 0 && addVideo() &&
                 (clip.sound.empty() || addSound()) && avformat_write_header(m_container, nullptr) >= 0;
    }
    ~ClipWriter()
    {
        if (m_container && m_container->pb)
            avio_closep(&m_container->pb);
        avformat_free_context(m_container);
    }
    bool write()
    {
        const int frames = int(std::lround(m_clip.lengthS * framesPerSecond));
        for (int i = 0; m_good && i < frames; ++i)
            writeFrame(i);
        const int step = m_sound && m_sound->frame_size > 0 ? m_sound->frame_size : 1024;
        for (std::size_t i = 0; m_good && m_sound && i < m_clip.sound.size(); i += std::size_t(step))
            writeSound(i, step);
        encode(*m_video, 0, nullptr);
        if (m_sound)
            encode(*m_sound, 1, nullptr);
        return m_good && av_write_trailer(m_container) >= 0;
    }

private:
    AVStream *open(AVCodecContext &coder, const AVCodec *codec)
    {
        if ((m_container->oformat->flags & AVFMT_GLOBALHEADER) != 0)
            coder.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        if (avcodec_open2(&coder, codec, nullptr) < 0)
            return nullptr;
        AVStream *stream = avformat_new_stream(m_container, nullptr);
        stream->time_base = coder.time_base;
        avcodec_parameters_from_context(stream->codecpar, &coder);
        return stream;
    }
    bool addVideo()
    {
        const AVCodec *codec = avcodec_find_encoder_by_name("libx264");
        m_video.reset(avcodec_alloc_context3(codec));
        m_video->width = 64;
        m_video->height = 48;
        m_video->pix_fmt = AV_PIX_FMT_YUV420P;
        m_video->time_base = {1, framesPerSecond * 1000};
        m_video->framerate = {framesPerSecond, 1};
        m_video->max_b_frames = 2;
        return codec && open(*m_video, codec);
    }
    bool addSound()
    {
        const AVCodec *codec = avcodec_find_encoder_by_name(m_clip.codec.c_str());
        if (!codec)
            return false;
        m_sound.reset(avcodec_alloc_context3(codec));
        m_sound->sample_fmt = codec->sample_fmts[0];
        m_sound->sample_rate = m_clip.soundRate;
        m_sound->time_base = {1, m_clip.soundRate};
        m_sound->bit_rate = m_clip.bitRate;
        av_channel_layout_default(&m_sound->ch_layout, m_clip.channels);
        return open(*m_sound, codec) != nullptr;
    }
    void writeFrame(int number)
    {
        const libav::FramePtr image(av_frame_alloc());
        image->format = m_video->pix_fmt;
        image->width = m_video->width;
        image->height = m_video->height;
        image->pts = std::int64_t(number) * 1000 +
                     std::llround(std::max(0.0, -m_clip.soundLateS) * framesPerSecond * 1000);
        m_good = av_frame_get_buffer(image.get(), 0) >= 0;
        for (int plane = 0; plane < 3; ++plane)
            std::fill_n(image->data[plane], image->linesize[plane] * (plane == 0 ? 48 : 24), number % 200);
        encode(*m_video, 0, image.get());
    }
    void writeSound(std::size_t first, int count)
    {
        const libav::FramePtr piece(av_frame_alloc());
        piece->format = m_sound->sample_fmt;
        piece->nb_samples = std::min(count, int(m_clip.sound.size() - first));
        piece->sample_rate = m_clip.soundRate;
        av_channel_layout_copy(&piece->ch_layout, &m_sound->ch_layout);
        piece->pts = std::int64_t(first) + std::llround(std::max(0.0, m_clip.soundLateS) * m_clip.soundRate);
        m_good = av_frame_get_buffer(piece.get(), 0) >= 0;
        for (int c = 0; m_good && c < m_clip.channels; ++c)
            for (int i = 0; i < piece->nb_samples; ++i)
                put(*piece, c, i, c + 1 == m_clip.channels ? m_clip.sound[first + std::size_t(i)] : 0);
        encode(*m_sound, 1, piece.get());
    }
    void put(AVFrame &piece, int channel, int at, float value) const
    {
        if (piece.format == AV_SAMPLE_FMT_FLTP)
            reinterpret_cast<float *>(piece.extended_data[channel])[at] = value;
        else if (piece.format == AV_SAMPLE_FMT_S16)
            reinterpret_cast<std::int16_t *>(piece.data[0])[at * m_clip.channels + channel] =
                std::int16_t(std::lround(32'000 * value));
    }
    void encode(AVCodecContext &coder, int stream, const AVFrame *frame)
    {
        m_good = m_good && avcodec_send_frame(&coder, frame) >= 0;
        const libav::PacketPtr packet(av_packet_alloc());
        while (m_good && avcodec_receive_packet(&coder, packet.get()) == 0) {
            const double atS = double(packet->pts) * av_q2d(coder.time_base);
            if (stream == 1 && atS >= m_clip.gapAtS && atS < m_clip.gapAtS + m_clip.gapS)
                continue;
            packet->stream_index = stream;
            av_packet_rescale_ts(packet.get(), coder.time_base, m_container->streams[stream]->time_base);
            m_good = av_interleaved_write_frame(m_container, packet.get()) >= 0;
        }
    }

    const SoundClip &m_clip;
    AVFormatContext *m_container = nullptr;
    libav::CodecPtr m_video, m_sound;
    bool m_good = false;
};

} // namespace

bool writeSoundClip(const std::filesystem::path &to, const SoundClip &clip)
{
    return ClipWriter(to, clip).write();
}

std::vector<float> clicksAt(const std::vector<double> &timesS, double lengthS, int rate)
{
    std::vector<float> sound(std::size_t(lengthS * rate));
    for (const double timeS : timesS)
        for (int i = -rate / 500; i <= rate / 500; ++i) {
            const double t = double(i) / rate;
            const auto at = std::size_t(std::lround(timeS * rate) + i);
            if (at < sound.size())
                sound[at] =
                    float(0.9 * std::exp(-std::pow(t / 0.0004, 2)) * std::cos(2 * 3.14159 * 1500 * t));
        }
    return sound;
}

} // namespace odo::test
