// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/units.h"
#include "core/video/frame_times.h"
#include "core/video/internal/libav.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// One local file opened by libav's demuxer, giving the packets of its first real video stream. The file is
/// opened by us, only ordinary containers may be recognised in it, and the demuxer is refused every other
/// file, so a playlist or a reference inside the file leads nowhere. Not thread-safe.
class VideoInput
{
public:
    /// cancel: once it is cancelled, read() ends with AVERROR_EXIT. Errors: missing, a folder or device,
    /// unreadable, not a video, no video stream.
    static Result<std::unique_ptr<VideoInput>> open(const std::filesystem::path &file,
                                                    const CancelToken &cancel = {});
    /// The same file from its beginning, taken for the container that it was found to be.
    Result<std::unique_ptr<VideoInput>> openedAgain() const;
    ~VideoInput();
    VideoInput(const VideoInput &) = delete;
    VideoInput &operator=(const VideoInput &) = delete;

    const std::filesystem::path &file() const { return m_file; }
    bool isCancelled() const { return m_cancel.isCancelled(); }
    const AVFormatContext &container() const { return *m_container; }
    const AVStream &stream() const { return *m_stream; }
    /// The sound that goes with it; null where the file has none.
    const AVStream *sound() const { return m_sound; }
    /// It is a codec's bare stream, which holds no time stamps; those that libav gives it are made up.
    bool isBareStream() const;
    /// The frame rate that the headers of a bare stream state, frames/s: not what libav takes where they
    /// state none, nor the tick of a clock, which is as good as any number (H.264 §E.2.1).
    std::optional<AVRational> statedRate() const;
    /// Chroma location that the container itself states; the parameters of the stream hold what the decoder
    /// assumed.
    AVChromaLocation containerChromaLocation() const { return m_containerChromaLocation; }

    /// How a decoded frame is to be turned before it is shown, as the container's display matrix says,
    /// numbered as in EXIF (frame_turn.h); 1 where it says nothing.
    int orientation() const;

    /// Frames a second at which the camera took them, as Android's recorder notes it in the container
    /// (com.android.capture.fps); nothing where that is no rate.
    std::optional<double> captureRate() const;
    /// Width to height of a pixel, as the container says, or else the codec; 0 where neither does.
    AVRational pixelAspect() const;

    /// The next packet of the video stream. 0, AVERROR_EOF or another error of libav.
    int read(AVPacket &packet);
    /// The same of the video or the sound stream.
    int readWithSound(AVPacket &packet);
    /// Whether the headers of the packet read last say that it holds two fields, of two moments. Of codecs
    /// that say it nowhere but in the file's header: false.
    bool isInterlaced() const;
    /// Latest end of any packet of any stream read so far, in AV_TIME_BASE units since the container's start.
    std::int64_t lastEnd() const { return m_lastEnd; }
    /// Asks the demuxer to go to the key frame at or before this time stamp of the stream. Where it really
    /// went is only known from the next packet.
    bool seek(std::int64_t timeStamp);

private:
    VideoInput(std::filesystem::path file, CancelToken cancel)
        : m_file(std::move(file)), m_cancel(std::move(cancel))
    {
    }
    static Result<std::unique_ptr<VideoInput>> open(const std::filesystem::path &file,
                                                    const AVInputFormat *known, const CancelToken &cancel);
    Result<void> openContainer(const AVInputFormat *known);
    Result<void> findStream();
    int readAny(AVPacket &packet);

    std::filesystem::path m_file;
    CancelToken m_cancel;
    AVIOContext *m_io = nullptr;
    AVFormatContext *m_container = nullptr;
    AVStream *m_stream = nullptr;
    AVStream *m_sound = nullptr;
    AVChromaLocation m_containerChromaLocation = AVCHROMA_LOC_UNSPECIFIED;
    std::int64_t m_lastEnd = 0;
};

/// All packets of a video stream in the order of the file, and the frames that they hold in order of
/// presentation.
struct PacketIndex
{
    struct Packet
    {
        std::int64_t pts = AV_NOPTS_VALUE; ///< dts where the file gives no other
        std::int64_t dts = AV_NOPTS_VALUE;
        bool key = false;
    };
    struct ShownFrame
    {
        std::int64_t pts = AV_NOPTS_VALUE;
        std::size_t packet = 0; ///< index in `packets`
    };
    std::vector<Packet> packets;
    std::vector<ShownFrame> frames; ///< by pts, each once; empty pts where `counted`
    std::vector<Nanoseconds> times; ///< of `frames`, since the first, strictly increasing
    /// Packets do not say when their frame is shown: frames can only be identified by counting from the
    /// start.
    bool counted = false;
    TimeSource timeSource = TimeSource::Stamps;
    /// How long after the first frame its clock starts again, or stands still: what follows is stamped as if
    /// it came before, or at once.
    std::optional<Nanoseconds> restartsAt;
    /// empty, or such as "ends early at 12.40 s: …"
    Message warning;
    bool endsEarly = false;                            ///< as the warning says
    std::size_t interlacedPackets = 0;                 ///< whose headers say that the frame holds two fields
    std::vector<std::vector<std::uint8_t>> firstJpegs; ///< of MJPEG: the first packets

    /// The packet to begin decoding with so that this frame comes out: the last key frame before it both in
    /// the file and in presentation (frames that follow a key frame in the file but are shown before it need
    /// the key frame before that).
    std::size_t keyPacketFor(std::size_t frame) const;
    /// The index of the frame with this time stamp; -1 when there is none.
    std::int64_t frameOf(std::int64_t pts) const;
    /// The index of the packet with this time stamp; -1 when there is none.
    std::int64_t packetOf(std::int64_t pts) const;
};

/// Reads the input from its current position (its start) to its end, without decoding. Error Cancelled,
/// beside those of a file without a frame.
Result<PacketIndex> indexPackets(VideoInput &input);

/// The time stamp that identifies a packet: pts, else dts.
std::int64_t timeStampOf(const AVPacket &packet);

/// Whether no frame is shown of a packet of a video stream: an edit list cuts it off, or it is only referred
/// to.
bool isNeverShown(const AVPacket &packet, AVCodecID codec);

/// Whether every slice of an FFV1 packet carries a CRC and it holds. libav's decoder hides a slice whose CRC
/// fails behind the frame before and reports nothing, so it must be checked beforehand. A packet coded
/// without CRCs gives false too. Source: RFC 9043 §4.5 and §4.9 (slice footer: 24 bits of size, error status,
/// CRC parity).
bool ffv1ChecksumsHold(std::span<const std::uint8_t> packet);

} // namespace odo
