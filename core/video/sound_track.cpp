// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/sound_track.h"

#include "core/base/shortage.h"
#include "core/files/file_words.h"
#include "core/video/internal/libav.h"
#include "core/video/video_input.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
extern "C" {
#include <libswresample/swresample.h>
}

namespace odo {

namespace {

constexpr auto mostSamples = std::size_t(SoundTrack::rate * SoundTrack::longestS);
constexpr double leastGapS = 0.01; ///< a stamp that is farther off tells of a gap
constexpr double stampsAveraged = 16;
constexpr double drift = 0.001; ///< s: by as much the stamps run against the count before it is corrected

Message cannotReadSound(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_read_sound", "cannot read the sound of %1")(Named::file(file));
}

struct FreeResampler
{
    void operator()(SwrContext *resampler) const { swr_free(&resampler); }
};

/// Makes one track of decoded frames of any kind.
class SoundCollector
{
public:
    /// False once it is longer than a track may be.
    bool add(const AVFrame &frame, AVRational timeBase)
    {
        if (frame.nb_samples <= 0 || frame.sample_rate <= 0)
            return true;
        if (frame.best_effort_timestamp != AV_NOPTS_VALUE)
            fitTo(double(frame.best_effort_timestamp) * av_q2d(timeBase), frame);
        if (!m_resampler || frame.sample_rate != m_rate || frame.format != m_format ||
            frame.ch_layout.nb_channels != m_channels) {
            flush();
            begin(frame);
        }
        convert(const_cast<const std::uint8_t **>(frame.extended_data), frame.nb_samples);
        m_lengthS += double(frame.nb_samples) / frame.sample_rate;
        return m_samples.size() <= mostSamples && m_lengthS <= SoundTrack::longestS;
    }
    void flush()
    {
        if (m_resampler)
            convert(nullptr, 0);
        m_resampler.reset();
    }
    bool isEmpty() const { return m_samples.empty(); }
    /// By the stream's own stamps.
    double firstS() const { return m_firstS.value_or(0); }
    std::vector<std::int16_t> take() { return std::move(m_samples); }

private:
    void begin(const AVFrame &frame)
    {
        m_rate = frame.sample_rate;
        m_format = frame.format;
        m_channels = frame.ch_layout.nb_channels;
        AVChannelLayout from{}, mono{};
        av_channel_layout_default(&from, m_channels);
        av_channel_layout_default(&mono, 1);
        SwrContext *resampler = nullptr;
        libav::checked(swr_alloc_set_opts2(&resampler, &mono, AV_SAMPLE_FMT_S16, int(SoundTrack::rate), &from,
                                           static_cast<AVSampleFormat>(m_format), m_rate, 0, nullptr));
        m_resampler.reset(resampler);
        if (m_resampler && libav::checked(swr_init(m_resampler.get())) < 0)
            m_resampler.reset(); // of an unknown layout: silent
    }
    void convert(const std::uint8_t **data, int count)
    {
        const int most = m_resampler ? swr_get_out_samples(m_resampler.get(), count) : 0;
        if (most <= 0)
            return;
        const std::size_t before = m_samples.size();
        m_samples.resize(before + std::size_t(most));
        auto *to = reinterpret_cast<std::uint8_t *>(&m_samples[before]);
        const int made = libav::checked(swr_convert(m_resampler.get(), &to, most, data, count));
        m_samples.resize(before + std::size_t(std::max(0, made)));
    }
    /// Where a frame's stamp does not follow from the count of samples, these are moved.
    void fitTo(double stampS, const AVFrame &frame)
    {
        if (!m_firstS)
            m_firstS = stampS;
        const double aheadS = stampS - *m_firstS - m_lengthS;
        const double gapS = std::max(leastGapS, 0.5 * frame.nb_samples / frame.sample_rate);
        if (!(std::abs(aheadS) < gapS)) {
            shift(aheadS);
            return;
        }
        m_aheadS += (aheadS - m_aheadS) / stampsAveraged;
        if (std::abs(m_aheadS) > drift)
            shift(m_aheadS);
    }
    void shift(double byS)
    {
        m_aheadS = 0;
        const double mostS = SoundTrack::longestS + 1;
        byS = std::clamp(std::isfinite(byS) ? byS : mostS, -m_lengthS, mostS);
        const double size = double(m_samples.size()) + byS * SoundTrack::rate;
        m_samples.resize(std::size_t(std::clamp(std::round(size), 0.0, double(mostSamples) + 1)));
        m_lengthS += byS;
    }

    std::unique_ptr<SwrContext, FreeResampler> m_resampler;
    int m_rate = 0, m_format = -1, m_channels = 0;
    std::vector<std::int16_t> m_samples;
    std::optional<double> m_firstS;
    double m_lengthS = 0; ///< of what was added
    double m_aheadS = 0;  ///< of the stamps, lately
};

Result<libav::CodecPtr> openSoundDecoder(const VideoInput &input)
{
    const AVCodecParameters &parameters = *input.sound()->codecpar;
    const AVCodec *codec = avcodec_find_decoder(parameters.codec_id);
    libav::CodecPtr decoder(codec ? libav::allocated(avcodec_alloc_context3(codec)) : nullptr);
    if (!decoder || libav::checked(avcodec_parameters_to_context(decoder.get(), &parameters)) < 0)
        return nullptr;
    decoder->pkt_timebase = input.sound()->time_base;
    decoder->thread_count = 1;
    if (libav::checked(avcodec_open2(decoder.get(), codec, nullptr)) < 0)
        return nullptr;
    return decoder;
}

/// Walks a file: decodes its sound, and learns when its first frame is shown.
class SoundReading
{
public:
    SoundReading(VideoInput &input, libav::CodecPtr decoder)
        : m_input(input), m_decoder(std::move(decoder)), m_frame(libav::allocated(av_frame_alloc()))
    {
    }
    Result<SoundTrack> read()
    {
        const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
        int error = 0;
        while (!m_isTooLong && (error = m_input.readWithSound(*packet)) >= 0) {
            if (packet->stream_index == m_input.sound()->index)
                decode(packet.get());
            else
                look(*packet);
        }
        if (error == AVERROR_EXIT)
            return cancelled(cannotReadSound(m_input.file()));
        decode(nullptr);
        m_collector.flush();
        if (m_isTooLong)
            return fail(ErrorCode::InvalidInput, cannotReadSound(m_input.file()),
                        ODO_TEXT("video.sound_too_long", "its sound is longer than %1")(
                            quantity(SoundTrack::longestS / 3600, 1, "h")),
                        ODO_TEXT("video.give_shorter_clip", "give a shorter clip"));
        if (m_collector.isEmpty() || !m_firstShownS)
            return fail(ErrorCode::InvalidInput, cannotReadSound(m_input.file()), dataAreDamaged(),
                        copyFromCamera());
        return SoundTrack{m_collector.firstS() - *m_firstShownS, m_collector.take()};
    }

private:
    void look(const AVPacket &packet)
    {
        const std::int64_t stamp = timeStampOf(packet);
        if (stamp == AV_NOPTS_VALUE || (packet.flags & AV_PKT_FLAG_CORRUPT) != 0 ||
            isNeverShown(packet, m_input.stream().codecpar->codec_id))
            return;
        const double shownS = double(stamp) * av_q2d(m_input.stream().time_base);
        m_firstShownS = std::min(shownS, m_firstShownS.value_or(shownS));
    }
    /// What a damaged packet holds stays silent: the next stamp tells of the gap.
    void decode(const AVPacket *packet)
    {
        libav::checked(avcodec_send_packet(m_decoder.get(), packet));
        while (!m_isTooLong && libav::checked(avcodec_receive_frame(m_decoder.get(), m_frame.get())) >= 0)
            m_isTooLong = !m_collector.add(*m_frame, m_input.sound()->time_base);
    }

    VideoInput &m_input;
    const libav::CodecPtr m_decoder;
    const libav::FramePtr m_frame;
    SoundCollector m_collector;
    std::optional<double> m_firstShownS;
    bool m_isTooLong = false;
};

} // namespace

Result<SoundTrack> readSound(const std::filesystem::path &file, const CancelToken &cancel)
{
    return orShortage(
        [&file] { return cannotReadSound(file); },
        [&]() -> Result<SoundTrack> {
            const auto input = ODO_TRY(VideoInput::open(file, cancel));
            if (!input->sound())
                return fail(ErrorCode::NotFound, cannotReadSound(file),
                            ODO_TEXT("video.no_sound", "it has no sound"),
                            ODO_TEXT("video.record_with_sound", "switch the camera's sound on"));
            auto decoder = ODO_TRY(openSoundDecoder(*input));
            if (!decoder)
                return fail(ErrorCode::InvalidInput, cannotReadSound(file),
                            ODO_TEXT("video.no_decoder", "there is no decoder for %1")(
                                std::string(avcodec_get_name(input->sound()->codecpar->codec_id))),
                            ODO_TEXT("video.convert_sound_to_aac", "convert its sound to AAC"));
            return SoundReading(*input, std::move(decoder)).read();
        });
}

} // namespace odo
