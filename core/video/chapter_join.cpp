// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/chapter_join.h"

#include "core/video/internal/chapter.h"
#include "core/video/internal/claimed_output.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace odo {

namespace {

constexpr std::int64_t leastTicks = 10'000, mostTicks = 100'000'000; // a second
constexpr AVRational chapterNanoseconds{1, 1'000'000'000};

bool goesIntoMatroska(const VideoInput &input)
{
    const AVOutputFormat *mov = av_guess_format("mov", nullptr, nullptr);
    return std::strstr(input.container().iformat->name, "matroska") || !mov ||
           avformat_query_codec(mov, input.stream().codecpar->codec_id, FF_COMPLIANCE_NORMAL) != 1;
}

/// Ticks a second, in which the stamps of all chapters are whole numbers where that can be.
int commonTicks(const std::vector<Chapter> &chapters)
{
    std::int64_t ticks = 1;
    for (const Chapter &chapter : chapters)
        ticks = std::min(std::lcm(ticks, std::int64_t(chapter.input->stream().time_base.den)), mostTicks + 1);
    if (ticks > mostTicks)
        ticks = chapters.front().input->stream().time_base.den;
    while (ticks < leastTicks)
        ticks *= 10;
    return static_cast<int>(std::min<std::int64_t>(ticks, mostTicks));
}

constexpr std::int64_t longestSilenceS = 60;

/// Of all channels; 0 of compressed sound.
int bytesOfSample(const AVCodecParameters &parameters)
{
    constexpr int bitsOfByte = 8;
    const bool isPlain =
        parameters.codec_id >= AV_CODEC_ID_FIRST_AUDIO && parameters.codec_id < AV_CODEC_ID_ADPCM_IMA_QT;
    return isPlain
               ? av_get_bits_per_sample(parameters.codec_id) / bitsOfByte * parameters.ch_layout.nb_channels
               : 0;
}

/// Puts packets of several files behind each other.
class ChapterWriter
{
public:
    ChapterWriter(const std::vector<Chapter> &chapters, const std::filesystem::path &file)
        : m_chapters(chapters), m_file(file), m_isMatroska(goesIntoMatroska(*chapters.front().input)),
          m_hasSound(haveSameSound(chapters))
    {
    }
    ~ChapterWriter() { avformat_free_context(m_container); }
    ChapterWriter(const ChapterWriter &) = delete;
    ChapterWriter &operator=(const ChapterWriter &) = delete;

    Result<void> begin();
    Result<void> add(std::size_t chapter, const JobControl &control);
    Result<void> finish();
    bool hasSound() const { return m_hasSound; }

private:
    tl::unexpected<Error> problem(Message why) const
    {
        return fail(
            ErrorCode::Io,
            ODO_TEXT("video.cannot_write_joined",
                     "cannot write the joined recording %1")(Named::file(m_file)),
            std::move(why),
            ODO_TEXT("video.check_its_folder", "check that its folder may be written to and has free space"));
    }
    tl::unexpected<Error> libavProblem(int error) const
    {
        return problem(foreignWords(libav::errorText(error)));
    }
    Result<void> openFilter(const Chapter &chapter);
    Result<void> addStreams();
    Result<void> copyPackets(const Chapter &chapter, VideoInput &input, const JobControl &control);
    Result<void> addFrames(const Chapter &chapter, AVPacket &packet);
    Result<void> addSound(const AVStream &from, AVPacket &packet);
    Result<void> writeSilence(std::int64_t samples, int bytes);
    Result<void> write(AVPacket &packet, AVStream &to, std::int64_t shift, std::int64_t &last);
    std::int64_t inTicks(std::int64_t stamp, const AVStream &from) const
    {
        return av_rescale_q(stamp, from.time_base, m_video->time_base);
    }

    const std::vector<Chapter> &m_chapters;
    const std::filesystem::path &m_file;
    const bool m_isMatroska, m_hasSound;
    ClaimedOutput m_output;
    AVFormatContext *m_container = nullptr;
    AVStream *m_video = nullptr, *m_sound = nullptr;
    libav::FilterPtr m_filter;
    std::int64_t m_shift = 0; ///< of the chapter's stamps, in ticks of the video
    std::int64_t m_lastDts = AV_NOPTS_VALUE, m_lastSound = AV_NOPTS_VALUE;
    std::int64_t m_soundEnd = 0; ///< in samples, where they are not compressed
    bool m_isJoint = false;      ///< no sound of this chapter was written yet, and some of those before
    std::size_t m_copied = 0;
};

/// Puts the parameter sets of H.264 and HEVC into the key frames, where those of the chapters differ.
Result<void> ChapterWriter::openFilter(const Chapter &chapter)
{
    m_filter.reset();
    const AVCodecParameters &parameters = chapter.parameters();
    const char *name = parameters.codec_id == AV_CODEC_ID_H264   ? "h264_mp4toannexb"
                       : parameters.codec_id == AV_CODEC_ID_HEVC ? "hevc_mp4toannexb"
                                                                 : "null";
    if (std::ranges::all_of(m_chapters, [&](const Chapter &other) {
            return haveSameSetUp(other.parameters(), m_chapters.front().parameters());
        }))
        name = "null";
    AVBSFContext *filter = nullptr;
    int error = libav::checked(av_bsf_alloc(av_bsf_get_by_name(name), &filter));
    m_filter.reset(filter);
    if (error >= 0)
        error = libav::checked(avcodec_parameters_copy(filter->par_in, &parameters));
    if (error >= 0) {
        filter->time_base_in = chapter.input->stream().time_base;
        error = libav::checked(av_bsf_init(filter));
    }
    return error < 0 ? Result<void>(fail(ErrorCode::InvalidInput, cannotJoin(chapter.file),
                                         foreignWords(libav::errorText(error)), copyFromCamera()))
                     : Result<void>();
}

Result<void> ChapterWriter::addStreams()
{
    const Chapter &first = m_chapters.front();
    const AVStream &from = first.input->stream();
    m_video = libav::allocated(avformat_new_stream(m_container, nullptr));
    libav::checked(avcodec_parameters_copy(m_video->codecpar, m_filter->par_out));
    m_video->codecpar->codec_tag = 0;
    m_video->avg_frame_rate = from.avg_frame_rate;
    m_video->sample_aspect_ratio = from.sample_aspect_ratio;
    m_video->time_base = m_isMatroska ? AVRational{1, 1000} : AVRational{1, commonTicks(m_chapters)};
    std::size_t bytes = 0;
    if (const std::uint8_t *turn = av_stream_get_side_data(&from, AV_PKT_DATA_DISPLAYMATRIX, &bytes))
        std::memcpy(libav::allocated(av_stream_new_side_data(m_video, AV_PKT_DATA_DISPLAYMATRIX, bytes)),
                    turn, bytes);
    if (m_hasSound) {
        m_sound = libav::allocated(avformat_new_stream(m_container, nullptr));
        libav::checked(avcodec_parameters_copy(m_sound->codecpar, first.sound()->codecpar));
        m_sound->codecpar->codec_tag = 0;
        m_sound->time_base = first.sound()->time_base;
    }
    return {};
}

Result<void> ChapterWriter::begin()
{
    if (const std::error_code unopened = m_output.open(m_file))
        return problem(foreignWords(unopened.message()));
    if (const int error = libav::checked(avformat_alloc_output_context2(
            &m_container, nullptr, m_isMatroska ? "matroska" : "mov", nullptr));
        error < 0)
        return libavProblem(error);
    m_container->pb = m_output.io();
    m_container->flags |= AVFMT_FLAG_BITEXACT;
    ODO_TRY(openFilter(m_chapters.front()));
    ODO_TRY(addStreams());
    libav::Options muxing;
    if (!m_isMatroska) {
        muxing.set("video_track_timescale", m_video->time_base.den);
        muxing.set("movflags", "+write_colr");
    }
    const int error = libav::checked(avformat_write_header(m_container, muxing.get()));
    return error < 0 ? libavProblem(error) : Result<void>();
}

/// shift: in ticks of that stream. Where the sound of the chapter before goes on at the joint, that of this
/// one begins behind it; and of frames with one stamp the first is kept, as when the file is read.
Result<void> ChapterWriter::write(AVPacket &packet, AVStream &to, std::int64_t shift, std::int64_t &last)
{
    const bool reorders = to.codecpar->video_delay > 0;
    packet.pts = av_sat_add64(packet.pts, shift);
    if (!reorders)
        packet.dts = packet.pts;
    else
        packet.dts = packet.dts == AV_NOPTS_VALUE ? last : av_sat_add64(packet.dts, shift);
    if (!reorders && last != AV_NOPTS_VALUE && packet.dts <= last)
        return {};
    if (last != AV_NOPTS_VALUE)
        packet.dts = std::max(packet.dts, last + 1);
    if (packet.dts == AV_NOPTS_VALUE || packet.dts > packet.pts)
        packet.dts = packet.pts;
    last = packet.dts;
    packet.stream_index = to.index;
    packet.pos = -1;
    const int error = libav::checked(av_interleaved_write_frame(m_container, &packet));
    return error < 0 ? libavProblem(error) : Result<void>();
}

Result<void> ChapterWriter::addFrames(const Chapter &chapter, AVPacket &packet)
{
    if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0)
        return fail(ErrorCode::InvalidInput, cannotJoin(chapter.file),
                    ODO_TEXT("video.chapter_hides_frames",
                             "some of its frames are hidden, as an editor does that cuts a video"),
                    ODO_TEXT("video.give_chapter_of_camera", "give the file as the camera wrote it"));
    packet.pts = timeStampOf(packet);
    int error = libav::checked(av_bsf_send_packet(m_filter.get(), &packet));
    while (error >= 0 && (error = av_bsf_receive_packet(m_filter.get(), &packet)) >= 0) {
        av_packet_rescale_ts(&packet, chapter.input->stream().time_base, m_video->time_base);
        ODO_TRY(write(packet, *m_video, m_shift, m_lastDts));
    }
    return error < 0 && error != AVERROR(EAGAIN)
               ? Result<void>(fail(ErrorCode::InvalidInput, cannotJoin(chapter.file), dataAreDamaged(),
                                   copyFromCamera()))
               : Result<void>();
}

/// QuickTime counts the samples of sound that is not compressed, whatever their stamps say: at a joint,
/// silence fills what is missing, and what there is twice is left out.
Result<void> ChapterWriter::addSound(const AVStream &from, AVPacket &packet)
{
    if (timeStampOf(packet) == AV_NOPTS_VALUE)
        return {};
    packet.pts = timeStampOf(packet);
    av_packet_rescale_ts(&packet, from.time_base, m_sound->time_base);
    const std::int64_t shift = av_rescale_q(m_shift, m_video->time_base, m_sound->time_base);
    const int bytes = m_isMatroska ? 0 : bytesOfSample(*m_sound->codecpar);
    if (bytes > 0) {
        const std::int64_t gap = m_isJoint ? packet.pts + shift - m_soundEnd : 0;
        if (gap > 0)
            ODO_TRY(writeSilence(std::min(gap, longestSilenceS * m_sound->codecpar->sample_rate), bytes));
        const auto twice = static_cast<int>(std::clamp<std::int64_t>(-gap, 0, packet.size / bytes));
        packet.data += std::ptrdiff_t(twice) * bytes;
        packet.size -= twice * bytes;
        packet.pts = packet.dts = packet.pts + twice;
        if (packet.size == 0)
            return {};
        m_isJoint = false;
        m_soundEnd = packet.pts + shift + packet.size / bytes;
    }
    return write(packet, *m_sound, shift, m_lastSound);
}

Result<void> ChapterWriter::writeSilence(std::int64_t samples, int bytes)
{
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    if (av_new_packet(packet.get(), static_cast<int>(samples) * bytes) < 0)
        throw std::bad_alloc();
    constexpr int middleOfUnsigned = 0x80;
    std::memset(packet->data, m_sound->codecpar->codec_id == AV_CODEC_ID_PCM_U8 ? middleOfUnsigned : 0,
                static_cast<std::size_t>(packet->size));
    packet->flags = AV_PKT_FLAG_KEY;
    packet->pts = packet->dts = m_soundEnd;
    packet->duration = samples;
    return write(*packet, *m_sound, 0, m_lastSound);
}

Result<void> ChapterWriter::copyPackets(const Chapter &chapter, VideoInput &input, const JobControl &control)
{
    std::size_t all = 0;
    for (const Chapter &each : m_chapters)
        all += each.packets;
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    for (;;) {
        const int error = m_hasSound ? input.readWithSound(*packet) : input.read(*packet);
        if (error == AVERROR_EXIT)
            return cancelled(cannotJoin(chapter.file));
        if (error < 0) // where it ends early, reading it before has said so
            return {};
        if (packet->stream_index != input.stream().index) {
            ODO_TRY(addSound(*input.sound(), *packet));
        } else if ((packet->flags & AV_PKT_FLAG_CORRUPT) == 0) {
            ODO_TRY(addFrames(chapter, *packet));
            control.report(
                0.5 + 0.5 * static_cast<double>(++m_copied) / static_cast<double>(all),
                ODO_TEXT("video.joining_chapters", "joining '%1'")(Named::file(chapter.file.filename())));
        }
    }
}

/// The usual interval at the end of a chapter; of a single frame that of the others.
Nanoseconds intervalAfter(const std::vector<Chapter> &chapters, std::size_t chapter)
{
    if (chapters[chapter].usual.count() > 0)
        return chapters[chapter].usual;
    const auto other =
        std::ranges::find_if(chapters, [](const Chapter &each) { return each.usual.count() > 0; });
    return other == chapters.end() ? Nanoseconds(0) : other->usual;
}

Result<void> ChapterWriter::add(std::size_t place, const JobControl &control)
{
    const Chapter &chapter = m_chapters[place];
    const auto input = ODO_TRY(chapter.input->openedAgain());
    if (place == 0) {
        m_shift = -inTicks(chapter.firstPts, chapter.input->stream());
    } else {
        const Chapter &before = m_chapters[place - 1];
        const Nanoseconds interval = intervalAfter(m_chapters, place - 1);
        if (interval.count() == 0)
            return fail(ErrorCode::Undetermined, cannotJoin(chapter.file),
                        ODO_TEXT("video.chapters_of_one_frame", "each of the files has a single frame"),
                        ODO_TEXT("video.give_as_images", "give images as a folder, with their rate"));
        ODO_TRY(openFilter(chapter));
        m_isJoint = m_lastSound != AV_NOPTS_VALUE;
        m_shift += inTicks(before.lastPts, before.input->stream()) +
                   av_rescale_q(interval.count(), chapterNanoseconds, m_video->time_base) -
                   inTicks(chapter.firstPts, chapter.input->stream());
    }
    return copyPackets(chapter, *input, control);
}

Result<void> ChapterWriter::finish()
{
    const int error = libav::checked(av_write_trailer(m_container));
    avformat_free_context(m_container);
    m_container = nullptr;
    const std::error_code failed = m_output.close();
    if (error < 0)
        return libavProblem(error);
    return failed ? Result<void>(problem(foreignWords(failed.message()))) : Result<void>();
}

/// What the recording times say against joining a chapter to the one before. Cameras note seconds, of the
/// beginning or of the end; and some the same for all chapters.
Message timeRemark(const Chapter &before, const Chapter &chapter)
{
    constexpr double toleranceS = 3;
    if (!before.recorded || !chapter.recorded)
        return {};
    const MessageArgument beforeName = Named::file(before.file.filename());
    const double laterS = toSeconds(chapter.recorded->at - before.recorded->at);
    if (laterS < 0)
        return ODO_TEXT("video.chapter_recorded_before",
                        "by its recording time it was started before '%1', behind which it was joined; check "
                        "the order of the files")(beforeName);
    const double gapS =
        laterS - std::max(toSeconds(before.recorded->duration), toSeconds(chapter.recorded->duration));
    if (gapS <= toleranceS)
        return {};
    return ODO_TEXT("video.chapter_after_gap",
                    "by its recording time %1 are missing between '%2' and it; if so, all times behind that "
                    "are wrong")(quantity(gapS, 0, "s"), beforeName);
}

std::vector<Message> remarksOn(const std::vector<Chapter> &chapters, bool hasSound)
{
    std::vector<Message> remarks;
    const auto about = [](const Chapter &chapter, Message why) {
        return joined({ODO_TEXT("video.of_chapter", "video '%1'")(Named::file(chapter.file.filename())),
                       std::move(why)},
                      Join::Colon);
    };
    for (std::size_t i = 1; i < chapters.size(); ++i) {
        const Chapter &before = chapters[i - 1], &chapter = chapters[i];
        if (Message remark = timeRemark(before, chapter); !remark.isEmpty())
            remarks.push_back(about(chapter, std::move(remark)));
    }
    const bool someSound =
        std::ranges::any_of(chapters, [](const Chapter &each) { return each.sound() != nullptr; });
    if (someSound && !hasSound)
        remarks.push_back(about(chapters.front(), ODO_TEXT("video.sound_left_out",
                                                           "the sound was left out, because the files it is "
                                                           "joined with have none or another kind of it")));
    for (const Chapter &chapter : chapters)
        if (!chapter.warning.isEmpty())
            remarks.push_back(about(chapter, chapter.warning));
    return remarks;
}

} // namespace

Result<std::string> endingOfJoined(const std::filesystem::path &firstChapter)
{
    const auto input = ODO_TRY(VideoInput::open(firstChapter));
    return std::string(goesIntoMatroska(*input) ? ".mkv" : ".mov");
}

Result<std::vector<Message>> joinChapters(const std::vector<std::filesystem::path> &chapters,
                                          const std::filesystem::path &claimed, const JobControl &control)
{
    libav::quieten();
    const std::vector<Chapter> read = ODO_TRY(readChapters(chapters, control));
    ChapterWriter writer(read, claimed);
    ODO_TRY(writer.begin());
    for (std::size_t i = 0; i < read.size(); ++i)
        ODO_TRY(writer.add(i, control));
    ODO_TRY(writer.finish());
    return remarksOn(read, writer.hasSound());
}

} // namespace odo
