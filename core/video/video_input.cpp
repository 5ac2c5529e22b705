// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_input.h"

#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/video/internal/libav.h"
#include "core/video/internal/orientation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>
extern "C" {
#include <libavutil/crc.h>
}

namespace odo {

namespace {

// The containers that cameras, telephones and editors write. Anything that can name another file (HLS, DASH,
// concat, SDP, image sequences, ...) is left out, and so is MXF: damaged lengths in 11 kB of it have
// libavformat ask for gigabytes and read one entry at a time, with no word in between by which it could be
// stopped.
constexpr const char *ordinaryContainers =
    "matroska,webm,mov,mp4,m4a,3gp,3g2,mj2,avi,mpegts,mpeg,mpegvideo,mjpeg,"
    "h264,hevc,m4v,ivf,flv,asf,ogg,nut,dv";

// Of those, the ones that are a codec's bare stream.
constexpr std::array<std::string_view, 5> bareStreams{"mjpeg", "h264", "hevc", "m4v", "mpegvideo"};
// What libav is to take for the frame rate of a bare stream that states none: no camera's.
constexpr AVRational unstated{98'765, 4'321};
const char *const unstatedText = "98765/4321";

int refuseOtherFiles(AVFormatContext *, AVIOContext **, const char *, int, AVDictionary **)
{
    return AVERROR(EPERM);
}

Result<void> checkFile(const std::filesystem::path &file)
{
    ODO_TRY(checkMayBeRead(file, cannotOpenVideo(file)));
    std::error_code unknown;
    if (files::sizeOf(file, unknown) == 0)
        return fail(ErrorCode::InvalidInput, cannotOpenVideo(file), fileIsEmpty(), copyFromCamera());
    return {};
}

/// The container that a file is by its name, where libav takes it for a photo.
const AVInputFormat *formatByName(const std::filesystem::path &file)
{
    const auto ending = file.extension();
    return ending == ".mjpeg" || ending == ".mjpg" ? av_find_input_format("mjpeg") : nullptr;
}

/// Whether cameras take frames at this rate, or 1000/1001 of it as in television.
bool isOrdinaryRate(double framesPerSecond)
{
    constexpr std::array ordinary{10, 12, 15, 20, 24, 25, 30, 48, 50, 60, 75, 90, 100, 120, 200, 240};
    constexpr double roundedOff = 1e-4;
    return std::ranges::any_of(ordinary, [framesPerSecond](int rate) {
        return std::abs(framesPerSecond / rate - 1) < roundedOff ||
               std::abs(framesPerSecond * 1.001 / rate - 1) < roundedOff;
    });
}

} // namespace

Result<std::unique_ptr<VideoInput>> VideoInput::open(const std::filesystem::path &file,
                                                     const CancelToken &cancel)
{
    auto input = open(file, nullptr, cancel);
    if (const AVInputFormat *named = input ? nullptr : formatByName(file))
        return open(file, named, cancel);
    return input;
}

Result<std::unique_ptr<VideoInput>> VideoInput::openedAgain() const
{
    return open(m_file, m_container->iformat, m_cancel);
}

Result<std::unique_ptr<VideoInput>> VideoInput::open(const std::filesystem::path &file,
                                                     const AVInputFormat *known, const CancelToken &cancel)
{
    libav::quieten();
    ODO_TRY(checkFile(file));
    std::unique_ptr<VideoInput> input(new VideoInput(file, cancel));
    ODO_TRY(input->openContainer(known));
    ODO_TRY(input->findStream());
    return input;
}

VideoInput::~VideoInput()
{
    avformat_close_input(&m_container);
    avio_closep(&m_io);
}

Result<void> VideoInput::openContainer(const AVInputFormat *known)
{
    libav::Options ioOptions;
    ioOptions.set("protocol_whitelist", "file");
    // "file:" keeps a name like "http:x.mkv" from being read as an address.
    const std::string address = "file:" + files::absolute(m_file).string();
    int error = libav::checked(avio_open2(&m_io, address.c_str(), AVIO_FLAG_READ, nullptr, ioOptions.get()));
    if (error < 0)
        return fail(ErrorCode::Io, cannotOpenVideo(m_file), foreignWords(libav::errorText(error)),
                    checkFileMayBeRead());

    m_container = libav::allocated(avformat_alloc_context());
    m_container->pb = m_io;
    m_container->flags |= AVFMT_FLAG_CUSTOM_IO;
    m_container->io_open = refuseOtherFiles;
    libav::Options options;
    options.set("format_whitelist", ordinaryContainers);
    options.set("protocol_whitelist", "file");
    options.set("framerate", unstatedText);
    // Frees the context when it fails. That there is no memory libav also says of damaged lengths.
    error = avformat_open_input(&m_container, nullptr, known, options.get());
    if (error < 0)
        return fail(
            ErrorCode::InvalidInput, cannotOpenVideo(m_file),
            ODO_TEXT("video.no_video_kind",
                     "it is not a supported kind of video, or its header is damaged or missing (%1)")(
                foreignWords(libav::errorText(error))),
            joined({ODO_TEXT("video.give_container", "give an MP4, MOV, MKV or AVI file"),
                    ODO_TEXT("video.copy_if_cut_short", "copy it from the camera again if it was cut short")},
                   Join::Semicolon));
    return {};
}

Result<void> VideoInput::findStream()
{
    std::vector<AVChromaLocation> stated;
    for (unsigned i = 0; i < m_container->nb_streams; ++i) {
        libav::forgetUnknownColours(*m_container->streams[i]->codecpar);
        stated.push_back(m_container->streams[i]->codecpar->chroma_location);
    }
    // It decodes frames to find out; none that are too large to read.
    std::vector<AVDictionary *> limits(m_container->nb_streams, nullptr);
    for (AVDictionary *&limit : limits)
        av_dict_set_int(&limit, "max_pixels", libav::mostPixels, 0);
    const int error = avformat_find_stream_info(m_container, limits.data());
    for (AVDictionary *&limit : limits)
        av_dict_free(&limit);
    const int best =
        error < 0 ? error : av_find_best_stream(m_container, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (best < 0 || (m_container->streams[best]->disposition & AV_DISPOSITION_ATTACHED_PIC) != 0)
        return fail(ErrorCode::InvalidInput, cannotOpenVideo(m_file),
                    ODO_TEXT("video.no_stream", "it contains no readable video stream"),
                    ODO_TEXT("video.give_camera_file", "give the file that the camera recorded"));
    m_stream = m_container->streams[best];
    libav::forgetUnknownColours(*m_stream->codecpar);
    const int sound = av_find_best_stream(m_container, AVMEDIA_TYPE_AUDIO, -1, best, nullptr, 0);
    m_sound = sound < 0 ? nullptr : m_container->streams[sound];
    if (static_cast<std::size_t>(best) < stated.size())
        m_containerChromaLocation = stated[static_cast<std::size_t>(best)];
    return {};
}

bool VideoInput::isBareStream() const
{
    return std::ranges::find(bareStreams, m_container->iformat->name) != bareStreams.end();
}

std::optional<AVRational> VideoInput::statedRate() const
{
    const AVRational rate = m_stream->r_frame_rate;
    if (rate.num <= 0 || rate.den <= 0 || av_cmp_q(rate, unstated) == 0 || !isOrdinaryRate(av_q2d(rate)))
        return std::nullopt;
    return rate;
}

int VideoInput::orientation() const
{
    std::size_t bytes = 0;
    const std::uint8_t *data = av_stream_get_side_data(m_stream, AV_PKT_DATA_DISPLAYMATRIX, &bytes);
    std::array<std::int32_t, 9> matrix{};
    if (!data || bytes < sizeof(matrix))
        return 1;
    std::memcpy(matrix.data(), data, sizeof(matrix));
    return orientationOfMatrix(matrix[0], matrix[1], matrix[3], matrix[4]);
}

std::optional<double> VideoInput::captureRate() const
{
    const AVDictionaryEntry *entry =
        av_dict_get(m_container->metadata, "com.android.capture.fps", nullptr, 0);
    const std::string_view text = entry ? entry->value : "";
    double rate = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rate);
    if (error != std::errc() || !std::isfinite(rate) || rate <= 0)
        return std::nullopt;
    return rate;
}

AVRational VideoInput::pixelAspect() const
{
    return av_guess_sample_aspect_ratio(m_container, m_stream, nullptr);
}

/// The next packet of any stream.
int VideoInput::readAny(AVPacket &packet)
{
    av_packet_unref(&packet);
    if (m_cancel.isCancelled())
        return AVERROR_EXIT;
    const int error = av_read_frame(m_container, &packet);
    if (error < 0)
        return error;
    const AVStream &from = *m_container->streams[packet.stream_index];
    const std::int64_t begin = packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts;
    if (begin != AV_NOPTS_VALUE) {
        const std::int64_t start = m_container->start_time == AV_NOPTS_VALUE ? 0 : m_container->start_time;
        const std::int64_t end =
            av_rescale_q(av_sat_add64(begin, packet.duration), from.time_base, AVRational{1, AV_TIME_BASE});
        m_lastEnd = std::max(m_lastEnd, av_sat_sub64(end, start));
    }
    return 0;
}

int VideoInput::read(AVPacket &packet)
{
    for (;;) {
        const int error = readAny(packet);
        if (error < 0 || (packet.stream_index == m_stream->index && packet.size > 0))
            return error;
    }
}

int VideoInput::readWithSound(AVPacket &packet)
{
    for (;;) {
        const int error = readAny(packet);
        if (error < 0 ||
            ((packet.stream_index == m_stream->index || (m_sound && packet.stream_index == m_sound->index)) &&
             packet.size > 0))
            return error;
    }
}

bool VideoInput::isInterlaced() const
{
    const AVCodecParserContext *parser = av_stream_get_parser(m_stream);
    return parser && parser->field_order > AV_FIELD_PROGRESSIVE;
}

bool VideoInput::seek(std::int64_t timeStamp)
{
    return av_seek_frame(m_container, m_stream->index, timeStamp, AVSEEK_FLAG_BACKWARD) >= 0;
}

namespace {

constexpr std::size_t firstPackets = 5;

constexpr AVRational nanosecondBase{1, 1'000'000'000};
constexpr std::int64_t longestVideoNs = 100LL * 24 * 3600 * 1'000'000'000LL;

void addWarning(PacketIndex &index, Message what, Message why)
{
    index.warning = joined({std::move(index.warning), joined({std::move(what), std::move(why)}, Join::Colon)},
                           Join::Semicolon);
}

struct Walk
{
    std::vector<std::int64_t> decodeTimes; ///< of shown packets
    bool ptsMissing = false, dtsMissing = false;
    bool corrupt = false;
    int endError = AVERROR_EOF;
};

Walk walkPackets(VideoInput &input, PacketIndex &index)
{
    Walk walk;
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    const AVCodecID codec = input.stream().codecpar->codec_id;
    const bool reorders = input.stream().codecpar->video_delay > 0;
    for (;;) {
        walk.endError = input.read(*packet);
        if (walk.endError < 0)
            return walk;
        if ((packet->flags & AV_PKT_FLAG_CORRUPT) != 0) {
            walk.corrupt = true;
            continue;
        }
        walk.ptsMissing |= packet->pts == AV_NOPTS_VALUE && (reorders || packet->dts == AV_NOPTS_VALUE);
        walk.dtsMissing |= packet->dts == AV_NOPTS_VALUE;
        const std::int64_t pts = timeStampOf(*packet);
        index.packets.push_back({pts, packet->dts, (packet->flags & AV_PKT_FLAG_KEY) != 0});
        index.interlacedPackets += input.isInterlaced() ? 1 : 0;
        if (codec == AV_CODEC_ID_MJPEG && index.firstJpegs.size() < firstPackets)
            index.firstJpegs.emplace_back(packet->data, packet->data + packet->size);
        if (!isNeverShown(*packet, codec)) {
            index.frames.push_back({pts, index.packets.size() - 1});
            walk.decodeTimes.push_back(packet->dts != AV_NOPTS_VALUE || reorders ? packet->dts : packet->pts);
        }
    }
}

/// Order of presentation by time stamp; of frames with one and the same time stamp only the first is kept.
void sortByPresentation(PacketIndex &index)
{
    auto &frames = index.frames;
    std::stable_sort(frames.begin(), frames.end(),
                     [](const auto &a, const auto &b) { return a.pts < b.pts; });
    const auto end = std::unique(frames.begin(), frames.end(),
                                 [](const auto &a, const auto &b) { return a.pts == b.pts; });
    if (const auto doubled = frames.end() - end; doubled > 0)
        addWarning(index, ODO_TEXT("video.frames_left_out", "%1 frames left out")(doubled),
                   ODO_TEXT("video.stamps_repeat", "their time stamps repeat that of the frame before"));
    frames.erase(end, frames.end());
}

/// What lies between two stamps of a file, of which the second is not the earlier one; a moment more than the
/// longest video where that is more, or not known: stamps may be any number.
Nanoseconds timeBetween(std::int64_t first, std::int64_t stamp, AVRational base)
{
    const std::int64_t time = av_rescale_q(av_sat_sub64(stamp, first), base, nanosecondBase);
    return Nanoseconds(time < 0 ? longestVideoNs + 1 : std::min(time, longestVideoNs + 1));
}

/// At an even rate, which the file states or nobody knows.
void timeByRate(PacketIndex &index, std::optional<AVRational> stated)
{
    constexpr AVRational madeUp{25, 1};
    index.timeSource = stated ? TimeSource::Rate : TimeSource::Nowhere;
    const AVRational interval = av_inv_q(stated.value_or(madeUp));
    index.times.clear();
    for (std::size_t i = 0; i < index.frames.size(); ++i)
        index.times.push_back(timeBetween(0, static_cast<std::int64_t>(i), interval));
}

/// Times without pts: each frame of such a file is shown at one of its decoding times, in order; failing
/// these, at an even rate.
void timeByCounting(PacketIndex &index, const Walk &walk, const AVStream &stream)
{
    index.counted = true;
    if (walk.dtsMissing) {
        const AVRational rate = stream.avg_frame_rate;
        timeByRate(index, rate.num > 0 && rate.den > 0 ? std::optional(rate) : std::nullopt);
        return;
    }
    std::vector<std::int64_t> stamps = walk.decodeTimes;
    std::sort(stamps.begin(), stamps.end());
    stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
    index.frames.resize(std::min(index.frames.size(), stamps.size()));
    for (std::size_t i = 0; i < index.frames.size(); ++i)
        index.times.push_back(timeBetween(stamps[0], stamps[i], stream.time_base));
}

void timeByStamps(PacketIndex &index, const AVStream &stream)
{
    sortByPresentation(index);
    for (const auto &frame : index.frames)
        index.times.push_back(timeBetween(index.frames.front().pts, frame.pts, stream.time_base));
}

/// The last stamp before they begin again: several that follow each other in the file lie behind several
/// before them. One alone may be damaged.
std::optional<std::int64_t> restartOf(const std::vector<std::int64_t> &decodeTimes)
{
    constexpr std::size_t several = 5;
    const auto &times = decodeTimes;
    for (std::size_t i = several; i + several <= times.size(); ++i) {
        if (times[i] >= times[i - 1])
            continue;
        const auto before = std::span(times).subspan(i - several, several),
                   after = std::span(times).subspan(i, several);
        if (std::ranges::min(after) != AV_NOPTS_VALUE && std::ranges::max(after) < std::ranges::min(before))
            return std::ranges::max(before);
    }
    return std::nullopt;
}

/// The last stamp before they stand still: several that follow each other hardly go on. Where a clock begins
/// again, editors and muxers write such stamps until it has caught up.
std::optional<std::int64_t> standstillOf(const std::vector<std::int64_t> &decodeTimes)
{
    constexpr int several = 5;
    constexpr std::int64_t hardly = 20; // part of a usual step
    std::vector<std::int64_t> steps;
    for (std::size_t i = 1; i < decodeTimes.size(); ++i)
        steps.push_back(av_sat_sub64(decodeTimes[i], decodeTimes[i - 1]));
    if (steps.empty())
        return std::nullopt;
    std::vector<std::int64_t> sorted = steps;
    const auto usual = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 3 / 4);
    std::ranges::nth_element(sorted, usual);
    int still = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        still = steps[i] >= 0 && steps[i] <= *usual / hardly && *usual > 0 ? still + 1 : 0;
        if (still == several)
            return decodeTimes[i + 1 - several];
    }
    return std::nullopt;
}

std::optional<std::int64_t> clockEndOf(const std::vector<std::int64_t> &decodeTimes)
{
    const auto restart = restartOf(decodeTimes);
    return restart ? restart : standstillOf(decodeTimes);
}

void warnIfCutShort(PacketIndex &index, const VideoInput &input, const Walk &walk)
{
    const AVFormatContext &container = input.container();
    Message why;
    if (walk.corrupt)
        why = ODO_TEXT("video.packet_damaged", "a packet is damaged");
    else if (walk.endError != AVERROR_EOF)
        why = foreignWords(libav::errorText(walk.endError));
    else if (container.duration_estimation_method != AVFMT_DURATION_FROM_BITRATE &&
             container.duration != AV_NOPTS_VALUE) {
        // Three frames and a hundredth: headers are rounded, and some count to the end of the last frame.
        const std::int64_t missing = av_sat_sub64(container.duration, input.lastEnd());
        const auto frame = index.times.back().count() / 1000 / static_cast<std::int64_t>(index.times.size());
        if (missing > 3 * frame && missing > container.duration / 100)
            why = ODO_TEXT("video.header_promises", "its header promises %1")(quantity(
                toSeconds(Nanoseconds(std::min(container.duration, longestVideoNs / 1000) * 1000)), 2, "s"));
    }
    index.endsEarly = !why.isEmpty();
    if (index.endsEarly)
        addWarning(
            index,
            ODO_TEXT("video.ends_early", "ends early at %1")(quantity(toSeconds(index.times.back()), 2, "s")),
            std::move(why));
}

} // namespace

// A VP8 packet may hold a frame that is only referred to and never shown (RFC 6386 §9.1: bit 4, show_frame).
bool isNeverShown(const AVPacket &packet, AVCodecID codec)
{
    if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0)
        return true;
    return codec == AV_CODEC_ID_VP8 && (packet.data[0] & 0x10) == 0;
}

std::int64_t timeStampOf(const AVPacket &packet)
{
    return packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts;
}

std::size_t PacketIndex::keyPacketFor(std::size_t frame) const
{
    for (std::size_t i = frames[frame].packet; i > 0; --i)
        if (packets[i].key && packets[i].pts <= frames[frame].pts)
            return i;
    return 0;
}

std::int64_t PacketIndex::frameOf(std::int64_t pts) const
{
    const auto at =
        std::lower_bound(frames.begin(), frames.end(), pts,
                         [](const ShownFrame &frame, std::int64_t value) { return frame.pts < value; });
    return at != frames.end() && at->pts == pts ? at - frames.begin() : -1;
}

std::int64_t PacketIndex::packetOf(std::int64_t pts) const
{
    const auto at = std::find_if(packets.begin(), packets.end(),
                                 [pts](const Packet &packet) { return packet.pts == pts; });
    return at != packets.end() ? at - packets.begin() : -1;
}

Result<PacketIndex> indexPackets(VideoInput &input)
{
    PacketIndex index;
    const Walk walk = walkPackets(input, index);
    if (walk.endError == AVERROR_EXIT)
        return cancelled(cannotOpenVideo(input.file()));
    if (index.frames.empty())
        return fail(ErrorCode::InvalidInput, cannotOpenVideo(input.file()),
                    ODO_TEXT("video.no_whole_frame", "it contains no complete frame"), copyFromCamera());
    if (walk.ptsMissing)
        timeByCounting(index, walk, input.stream());
    else
        timeByStamps(index, input.stream());
    if (input.isBareStream())
        timeByRate(index, input.statedRate());
    else if (const auto restart = clockEndOf(walk.decodeTimes))
        index.restartsAt = timeBetween(walk.decodeTimes.front(), *restart, input.stream().time_base);
    if (index.times.back().count() > longestVideoNs)
        return fail(ErrorCode::InvalidInput, cannotOpenVideo(input.file()),
                    ODO_TEXT("video.stamps_span",
                             "its time stamps span %1")(quantity(toSeconds(index.times.back()), 2, "s")),
                    copyFromCamera());
    warnIfCutShort(index, input, walk);
    return index;
}

bool ffv1ChecksumsHold(std::span<const std::uint8_t> packet)
{
    constexpr std::size_t footer = 8;
    const AVCRC *table = av_crc_get_table(AV_CRC_32_IEEE);
    while (packet.size() >= footer) { // only the footers give the start of slices: from the last to the first
        const auto foot = packet.last(footer);
        const std::size_t size = (static_cast<std::size_t>(foot[0]) << 16 | foot[1] << 8 | foot[2]) + footer;
        if (size > packet.size() || av_crc(table, 0, packet.last(size).data(), size) != 0)
            return false;
        packet = packet.first(packet.size() - size);
    }
    return packet.empty();
}

} // namespace odo
