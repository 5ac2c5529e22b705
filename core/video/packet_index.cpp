// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/packet_index.h"

#include <algorithm>
#include <cstdio>

namespace odo {

namespace {

constexpr std::size_t firstPackets = 5;

constexpr AVRational nanosecondBase{1, 1'000'000'000};
constexpr std::int64_t longestVideoNs = 100LL * 24 * 3600 * 1'000'000'000LL;

/// A VP8 packet may hold a picture that is only referred to and never shown (RFC 6386 §9.1: bit 4,
/// show_frame).
bool isNeverShown(const AVPacket &packet, AVCodecID codec)
{
    if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0)
        return true;
    return codec == AV_CODEC_ID_VP8 && (packet.data[0] & 0x10) == 0;
}

void addWarning(PacketIndex &index, const std::string &text)
{
    index.warning += (index.warning.empty() ? "" : "; ") + text;
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
        if (codec == AV_CODEC_ID_MJPEG && index.firstJpegs.size() < firstPackets)
            index.firstJpegs.emplace_back(packet->data, packet->data + packet->size);
        if (!isNeverShown(*packet, codec)) {
            index.frames.push_back({pts, index.packets.size() - 1});
            walk.decodeTimes.push_back(packet->dts);
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
        addWarning(index,
                   std::to_string(doubled) + " frames left out: their time stamps repeat the frame before");
    frames.erase(end, frames.end());
}

/// What lies between two stamps of a file, of which the second is not the earlier one; a moment more than the longest video where that
/// is more, or cannot be told: stamps may be any number.
Nanoseconds timeBetween(std::int64_t first, std::int64_t stamp, AVRational base)
{
    const std::int64_t time = av_rescale_q(av_sat_sub64(stamp, first), base, nanosecondBase);
    return Nanoseconds(time < 0 ? longestVideoNs + 1 : std::min(time, longestVideoNs + 1));
}

std::vector<std::int64_t> evenTimes(std::size_t count)
{
    std::vector<std::int64_t> times(count);
    for (std::size_t i = 0; i < count; ++i)
        times[i] = static_cast<std::int64_t>(i);
    return times;
}

/// Times without pts: each frame of such a file is shown at one of its decoding times, in order; failing
/// these, at an even rate.
void timeByCounting(PacketIndex &index, const Walk &walk, const AVStream &stream)
{
    index.counted = true;
    std::vector<std::int64_t> stamps = walk.decodeTimes;
    AVRational base = stream.time_base;
    if (walk.dtsMissing) {
        const AVRational rate = stream.avg_frame_rate.num > 0 ? stream.avg_frame_rate : stream.r_frame_rate;
        base = rate.num > 0 ? av_inv_q(rate) : AVRational{1, 25};
        stamps = evenTimes(index.frames.size());
        char text[120];
        std::snprintf(text, sizeof text, "the file has no time stamps: an even %.3f frames/s is assumed",
                      1.0 / av_q2d(base));
        addWarning(index, text);
    }
    std::sort(stamps.begin(), stamps.end());
    stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
    index.frames.resize(std::min(index.frames.size(), stamps.size()));
    for (std::size_t i = 0; i < index.frames.size(); ++i)
        index.times.push_back(timeBetween(stamps[0], stamps[i], base));
}

void timeByStamps(PacketIndex &index, const AVStream &stream)
{
    sortByPresentation(index);
    for (const auto &frame : index.frames)
        index.times.push_back(timeBetween(index.frames.front().pts, frame.pts, stream.time_base));
}

void warnIfCutShort(PacketIndex &index, const VideoInput &input, const Walk &walk)
{
    const AVFormatContext &container = input.container();
    std::string why;
    if (walk.corrupt)
        why = "a packet there is damaged";
    else if (walk.endError != AVERROR_EOF)
        why = libav::errorText(walk.endError);
    else if (container.duration_estimation_method != AVFMT_DURATION_FROM_BITRATE &&
             container.duration != AV_NOPTS_VALUE) {
        // Three frames and a hundredth: headers are rounded, and some count to the end of the last frame.
        const std::int64_t missing = av_sat_sub64(container.duration, input.lastEnd());
        const auto frame = index.times.back().count() / 1000 / static_cast<std::int64_t>(index.times.size());
        if (missing > 3 * frame && missing > container.duration / 100)
            why = "its header promises " + secondsText(toSeconds(Nanoseconds(std::min(container.duration, longestVideoNs / 1000) * 1000)));
    }
    if (!why.empty())
        addWarning(index, "ends early at " + secondsText(toSeconds(index.times.back())) + ": " + why);
}

} // namespace

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
        return cancelled("cannot open the video " + input.file().string());
    if (index.frames.empty())
        return fail(ErrorCode::InvalidInput, "cannot open the video " + input.file().string(),
                    "not one whole frame is in it", "copy it from the camera again");
    if (walk.ptsMissing)
        timeByCounting(index, walk, input.stream());
    else
        timeByStamps(index, input.stream());
    if (index.times.back().count() > longestVideoNs)
        return fail(ErrorCode::InvalidInput, "cannot open the video " + input.file().string(),
                    "its time stamps span " + secondsText(toSeconds(index.times.back())),
                    "copy it from the camera again");
    warnIfCutShort(index, input, walk);
    return index;
}

} // namespace odo
