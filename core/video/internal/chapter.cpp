// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/chapter.h"

#include "core/base/units.h"
#include "core/video/frame_turn.h"
#include "core/video/internal/stream_format.h"

#include <algorithm>
#include <array>
#include <span>
extern "C" {
#include <libavutil/parseutils.h>
#include <libavutil/pixdesc.h>
}

namespace odo {

namespace {

/// Codecs whose frames hold all that their decoder needs, or whose parameter sets can be put into them.
constexpr std::array setUpInFrames{AV_CODEC_ID_H264,   AV_CODEC_ID_HEVC,      AV_CODEC_ID_MJPEG,
                                   AV_CODEC_ID_PRORES, AV_CODEC_ID_VP8,       AV_CODEC_ID_VP9,
                                   AV_CODEC_ID_AV1,    AV_CODEC_ID_MPEG2VIDEO};

MessageArgument nameOf(const std::filesystem::path &file)
{
    return Named::file(file.filename());
}

Message joinOneRecording()
{
    return ODO_TEXT("video.join_one_recording",
                    "join only the files into which a camera has split one recording");
}

std::string pixelsOf(const AVCodecParameters &parameters)
{
    const char *name = av_get_pix_fmt_name(static_cast<AVPixelFormat>(parameters.format));
    return name ? name : "unknown";
}

/// What makes frames of another kind than the first chapter's; empty: nothing.
Message differenceOf(const Chapter &chapter, const Chapter &first)
{
    const AVCodecParameters &own = chapter.parameters(), &its = first.parameters();
    if (own.codec_id != its.codec_id)
        return ODO_TEXT("video.chapter_codec", "its codec is %1, that of '%2' is %3")(
            std::string(avcodec_get_name(own.codec_id)), nameOf(first.file),
            std::string(avcodec_get_name(its.codec_id)));
    if (own.width != its.width || own.height != its.height)
        return ODO_TEXT("video.chapter_size", "its frames are %1, those of '%2' are %3")(
            sizeText(own.width, own.height), nameOf(first.file), sizeText(its.width, its.height));
    if (own.format != its.format)
        return ODO_TEXT("video.chapter_pixels", "its pixel format is %1, that of '%2' is %3")(
            pixelsOf(own), nameOf(first.file), pixelsOf(its));
    const int ownTurn = chapter.input->orientation(), itsTurn = first.input->orientation();
    if (ownTurn != itsTurn && isMirroring(ownTurn) == isMirroring(itsTurn))
        return ODO_TEXT("video.chapter_turn", "its frames are to be turned by %1°, those of '%2' by %3°")(
            clockwiseDegreesOf(ownTurn), nameOf(first.file), clockwiseDegreesOf(itsTurn));
    if (ownTurn != itsTurn)
        return ODO_TEXT("video.chapter_mirrored",
                        "its frames and those of '%1' are not mirrored alike")(nameOf(first.file));
    if (!haveSameSetUp(own, its) && std::ranges::find(setUpInFrames, own.codec_id) == setUpInFrames.end())
        return ODO_TEXT("video.chapter_set_up",
                        "its encoder was set up in another way than that of '%1'")(nameOf(first.file));
    return {};
}

std::optional<Nanoseconds> recordedAt(const VideoInput &input)
{
    const AVDictionaryEntry *entry = av_dict_get(input.container().metadata, "creation_time", nullptr, 0);
    std::int64_t microseconds = 0;
    if (!entry || av_parse_time(&microseconds, entry->value, 0) < 0 || microseconds <= 0)
        return std::nullopt;
    constexpr std::int64_t most = 4'200'000'000'000'000; // the year 2103
    return Nanoseconds(std::min(microseconds, most) * 1000);
}

Result<void> checkTimesOf(const Chapter &chapter, const PacketIndex &index)
{
    const Message what = cannotJoin(chapter.file);
    if (index.timeSource != TimeSource::Stamps || (index.counted && chapter.parameters().video_delay > 0))
        return fail(ErrorCode::Undetermined, what,
                    ODO_TEXT("video.chapter_without_stamps", "its frames have no time stamps of their own"),
                    ODO_TEXT("video.put_into_mp4",
                             "put each file into MP4 first, e.g. ffmpeg -i FILE -c copy NEW.mp4"));
    if (index.restartsAt)
        return fail(ErrorCode::Undetermined, what,
                    ODO_TEXT("video.chapter_restarts", "its time stamps begin again or stand still after %1")(
                        quantity(toSeconds(*index.restartsAt), 2, "s")),
                    ODO_TEXT("video.cut_chapter_there", "cut it there, and give both parts"));
    return {};
}

Result<Chapter> readChapter(const std::filesystem::path &file, const JobControl &control)
{
    Chapter chapter;
    chapter.file = file;
    chapter.input = ODO_TRY(VideoInput::open(file, control.cancel));
    ODO_TRY(streamFormat(*chapter.input)); // one that is read at all
    const PacketIndex index = ODO_TRY(indexPackets(*chapter.input));
    ODO_TRY(checkTimesOf(chapter, index));
    const auto [first, last] = std::ranges::minmax(index.packets, {}, &PacketIndex::Packet::pts);
    chapter.firstPts = first.pts;
    chapter.lastPts = last.pts;
    chapter.usual = spacingOf(index.times).usual;
    chapter.packets = index.packets.size();
    chapter.warning = index.warning;
    chapter.endsEarly = index.endsEarly;
    if (const auto at = recordedAt(*chapter.input))
        chapter.recorded = RecordedSpan{*at, index.times.back() + chapter.usual};
    return chapter;
}

std::span<const std::uint8_t> setUpOf(const AVCodecParameters &parameters)
{
    return {parameters.extradata, static_cast<std::size_t>(std::max(0, parameters.extradata_size))};
}

} // namespace

std::optional<RecordedSpan> recordedSpan(const std::filesystem::path &file)
{
    const auto input = VideoInput::open(file);
    const auto at = input ? recordedAt(**input) : std::nullopt;
    if (!at || (*input)->container().duration <= 0)
        return std::nullopt;
    return RecordedSpan{*at, Nanoseconds((*input)->container().duration * 1000)};
}

Message cannotJoin(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_join", "cannot join '%1' to a recording")(nameOf(file));
}

bool haveSameSetUp(const AVCodecParameters &a, const AVCodecParameters &b)
{
    return std::ranges::equal(setUpOf(a), setUpOf(b));
}

bool haveSameSound(const std::vector<Chapter> &chapters)
{
    return std::ranges::all_of(chapters, [&](const Chapter &chapter) {
        if (!chapter.sound() || !chapters.front().sound())
            return false;
        const AVCodecParameters &own = *chapter.sound()->codecpar, &its = *chapters.front().sound()->codecpar;
        return own.codec_id == its.codec_id && own.sample_rate == its.sample_rate &&
               own.ch_layout.nb_channels == its.ch_layout.nb_channels && own.format == its.format &&
               haveSameSetUp(own, its);
    });
}

Result<std::vector<Chapter>> readChapters(const std::vector<std::filesystem::path> &files,
                                          const JobControl &control)
{
    std::vector<Chapter> chapters;
    for (const std::filesystem::path &file : files) {
        control.report(0.5 * static_cast<double>(chapters.size()) / static_cast<double>(files.size()),
                       ODO_TEXT("video.reading_chapter", "reading '%1'")(nameOf(file)));
        auto chapter = ODO_TRY(readChapter(file, control));
        const bool isLast = chapters.size() + 1 == files.size();
        if (Message difference = chapters.empty() ? Message() : differenceOf(chapter, chapters.front());
            !difference.isEmpty())
            return fail(ErrorCode::InvalidInput, cannotJoin(file), std::move(difference), joinOneRecording());
        if (!isLast && chapter.endsEarly)
            return fail(ErrorCode::InvalidInput, cannotJoin(file), std::move(chapter.warning),
                        ODO_TEXT("video.copy_chapter_again",
                                 "copy it from the camera again: what follows it would get wrong times"));
        chapters.push_back(std::move(chapter));
    }
    return chapters;
}

} // namespace odo
