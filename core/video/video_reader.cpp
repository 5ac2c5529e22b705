// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_reader.h"

#include "core/base/shortage.h"
#include "core/video/frame_times.h"
#include "core/video/frame_turn.h"
#include "core/video/internal/fields.h"
#include "core/video/internal/frame_stretch.h"
#include "core/video/internal/libav.h"
#include "core/video/internal/pixel_planes.h"
#include "core/video/internal/stream_format.h"
#include "core/video/jpeg.h"
#include "core/video/planes/field_motion.h"
#include "core/video/video_input.h"

#include <algorithm>

namespace odo {

/// A frame of an MJPEG stream of which only a part was decoded, with its packet.
class JpegImage : public CodedImage
{
public:
    JpegImage(libav::PacketPtr packet, std::shared_ptr<JpegDecoder> decoder)
        : m_packet(std::move(packet)), m_decoder(std::move(decoder))
    {
    }
    Result<Frame> decodeWhole() const override
    {
        Frame frame;
        if (m_decoder->decode(bytesOf(*m_packet), std::nullopt, frame) != JpegDecoder::Outcome::Decoded)
            return fail(ErrorCode::InvalidInput,
                        ODO_TEXT("video.cannot_decode_all", "cannot decode all of a frame"), dataAreDamaged(),
                        ODO_TEXT("video.sound_part_used", "its undamaged part is used"));
        return frame;
    }
    static std::span<const std::uint8_t> bytesOf(const AVPacket &packet)
    {
        return {packet.data, static_cast<std::size_t>(packet.size)};
    }

private:
    const libav::PacketPtr m_packet;
    const std::shared_ptr<JpegDecoder> m_decoder;
};

namespace {

/// Whether frames hold two fields, by what the stream or most of its packets say.
bool holdsFields(const VideoInput &input, const PacketIndex &index)
{
    const AVFieldOrder order = input.stream().codecpar->field_order;
    return (order != AV_FIELD_UNKNOWN && order != AV_FIELD_PROGRESSIVE) ||
           2 * index.interlacedPackets > index.packets.size();
}

VideoInfo describe(const VideoInput &input, const PacketIndex &index)
{
    VideoInfo info;
    info.codec = avcodec_get_name(input.stream().codecpar->codec_id);
    info.frameTimes = index.times;
    info.timeSource = index.timeSource;
    info.capturedPerSecond = input.captureRate();
    info.restartsAt = index.restartsAt;
    info.warning = index.warning;
    const FrameSpacing spacing = spacingOf(index.times);
    info.variableRate = spacing.isVariable;
    if (spacing.usual.count() > 0)
        info.framesPerSecond = 1.0 / toSeconds(spacing.usual);
    info.duration = index.times.back() + spacing.usual;
    return info;
}

Result<libav::CodecPtr> openDecoder(const VideoInput &input)
{
    const AVCodecParameters &parameters = *input.stream().codecpar;
    const Message what = cannotOpenVideo(input.file());
    const AVCodec *codec = avcodec_find_decoder(parameters.codec_id);
    if (!codec)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.no_decoder", "there is no decoder for %1")(
                        std::string(avcodec_get_name(parameters.codec_id))),
                    convertToH264());
    libav::CodecPtr decoder(libav::allocated(avcodec_alloc_context3(codec)));
    int error = libav::checked(avcodec_parameters_to_context(decoder.get(), &parameters));
    decoder->pkt_timebase = input.stream().time_base;
    decoder->thread_count = 1; // one thread a file: the views of a trial are decoded side by side
    decoder->max_pixels = libav::mostPixels;
    if (error >= 0)
        error = libav::checked(avcodec_open2(decoder.get(), codec, nullptr));
    if (error < 0)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.decoder_not_started",
                             "its decoder did not start (%1)")(foreignWords(libav::errorText(error))),
                    convertToH264());
    return decoder;
}

/// The width of frames whose pixels are square, unless the project knows that they were measured as stored.
int shownWidth(const VideoInput &input, const FrameFormat &stored, const KnownRecording &known)
{
    const bool isTurned = known.orientation.value_or(input.orientation()) > 4;
    const bool isAsStored = (isTurned ? known.heightPx : known.widthPx) == stored.width &&
                            (isTurned ? known.widthPx : known.heightPx) == stored.height;
    return isAsStored ? stored.width : widthAsSeen(stored, input.pixelAspect());
}

/// The decoder found nothing wrong in it.
bool isSound(const AVFrame &avFrame)
{
    return avFrame.decode_error_flags == 0 && (avFrame.flags & AV_FRAME_FLAG_CORRUPT) == 0;
}

} // namespace

struct VideoReader::Impl
{
    std::filesystem::path file;
    std::unique_ptr<VideoInput> input;
    libav::CodecPtr decoder;
    std::shared_ptr<JpegDecoder> jpegDecoder; ///< of MJPEG; `decoder` then does what it leaves
    PacketIndex index;
    VideoInfo info;                    ///< of the frames as given
    std::optional<PixelPlanes> planes; ///< of the frames as decoded
    std::optional<FrameStretcher> stretcher;
    std::optional<FrameTurner> turner; ///< of frames that are not given as decoded

    std::size_t nextIndex = 0;       ///< of the frame that next() gives
    std::optional<Frame> ahead;      ///< decoded already, as coded: not before the next one
    Field statedFirst = Field::Top;  ///< of its fields, as the file says
    std::optional<Field> firstField; ///< of all frames, as what moves shows
    std::optional<PixelRect> region; ///< all that is requested of the next frame
    libav::PacketPtr packet{libav::allocated(av_packet_alloc())};
    bool packetWaits = false;    ///< `packet` is read but not yet given to the decoder
    std::size_t packetsRead = 0; ///< index of the next packet to read
    std::int64_t counted = 0;    ///< frames since the start, where frames are identified by counting
    bool draining = false;
    bool beganMidway = false;  ///< nothing has come out of the decoder since it began at a key frame
    bool hasChecksums = false; ///< of FFV1: known as soon as one held
    /// A frame was damaged, and those after it are predicted from it, up to the next key frame: the decoder
    /// conceals what it lacks and says nothing of it in them.
    bool isSpoiled = false;

    Message cannotDecode(std::size_t frame) const
    {
        return ODO_TEXT("video.cannot_decode_frame", "cannot decode frame %1 of %2")(frame,
                                                                                     Named::file(file));
    }
    Message cannotShow(std::int64_t frame) const
    {
        return ODO_TEXT("video.cannot_show_frame", "cannot show frame %1 of %2")(frame, Named::file(file));
    }
    Result<void> restart();
    bool startAt(std::size_t keyPacket);
    bool isWhole(const AVPacket &coded);
    bool isPredicted() const;
    void judge(const AVFrame &avFrame);
    bool readPacket();
    bool sendPacket();
    libav::FramePtr decodeNextFrame();
    std::optional<Frame> frameFrom(libav::FramePtr avFrame, std::int64_t frameNumber);
    std::optional<Frame> decodeJpegFrame();
    std::optional<Frame> decodeFrame();
    void decodeTo(std::size_t frame);
    Result<void> decodeExactly(std::size_t coded);
    Result<std::optional<Frame>> decoded(std::size_t wanted);
    Result<std::optional<Frame>> upright(std::size_t wanted);
    Result<void> judgeFields(bool isStated);
    void makeUpright(const KnownRecording &known);
    std::size_t codedFrameOf(std::size_t frame) const { return info.areFields ? frame / 2 : frame; }
    bool isAhead(std::size_t frame) const
    {
        return ahead && ahead->index == static_cast<std::int64_t>(frame);
    }
    bool isOnTheWay(std::size_t frame) const;
};

/// From the very beginning, in a way that works with every container.
Result<void> VideoReader::Impl::restart()
{
    input = ODO_TRY(input->openedAgain());
    avcodec_flush_buffers(decoder.get());
    packetsRead = 0;
    counted = 0;
    packetWaits = draining = beganMidway = isSpoiled = false;
    ahead.reset();
    return {};
}

/// Makes this packet the next one that is decoded. False when the container could not seek there; then the
/// position of the input is unknown.
bool VideoReader::Impl::startAt(std::size_t keyPacket)
{
    const PacketIndex::Packet &key = index.packets[keyPacket];
    const bool byDecodeTime = std::string_view(input->container().iformat->name).starts_with("mov");
    if (!input->seek(byDecodeTime && key.dts != AV_NOPTS_VALUE ? key.dts : key.pts))
        return false;
    std::int64_t frameNumber = -1;
    do {
        if (input->read(*packet) < 0)
            return false;
        // They follow one another as in the index, which a search for each would take long to find in a large
        // file.
        const auto next = static_cast<std::size_t>(frameNumber + 1);
        const bool follows = frameNumber >= 0 && next < index.packets.size() &&
                             index.packets[next].pts == timeStampOf(*packet);
        frameNumber = follows ? frameNumber + 1 : index.packetOf(timeStampOf(*packet));
        if (frameNumber > static_cast<std::int64_t>(keyPacket))
            return false;
        packetsRead = static_cast<std::size_t>(std::max<std::int64_t>(frameNumber, 0)) + 1;
    } while (timeStampOf(*packet) != key.pts);
    avcodec_flush_buffers(decoder.get());
    packetWaits = true;
    draining = isSpoiled = false;
    beganMidway = keyPacket > 0;
    ahead.reset();
    return true;
}

bool VideoReader::Impl::isWhole(const AVPacket &coded)
{
    if (decoder->codec_id != AV_CODEC_ID_FFV1)
        return true;
    const bool checked = ffv1ChecksumsHold({coded.data, static_cast<std::size_t>(coded.size)});
    hasChecksums |= checked;
    return checked || !hasChecksums;
}

/// Whether a codec predicts frames from others.
bool VideoReader::Impl::isPredicted() const
{
    const AVCodecDescriptor *codec = avcodec_descriptor_get(decoder->codec_id);
    return codec && (codec->props & AV_CODEC_PROP_INTRA_ONLY) == 0;
}

void VideoReader::Impl::judge(const AVFrame &avFrame)
{
    if (!isSound(avFrame))
        isSpoiled = isPredicted();
    else if (avFrame.key_frame != 0)
        isSpoiled = false;
}

/// The next packet to decode; false at the end.
bool VideoReader::Impl::readPacket()
{
    if (!packetWaits) {
        if (input->read(*packet) < 0)
            return false;
        ++packetsRead;
    }
    packetWaits = false;
    if (packet->pts == AV_NOPTS_VALUE)
        packet->pts = packet->dts;
    return true;
}

/// Gives the decoder one more packet, or the word that there is none. False when it has all.
bool VideoReader::Impl::sendPacket()
{
    if (draining)
        return false;
    if (!readPacket()) {
        draining = true;
        avcodec_send_packet(decoder.get(), nullptr);
        return true;
    }
    // A damaged packet is refused; its frame is then missing in what comes out, which next() reports.
    if (!isWhole(*packet) || libav::checked(avcodec_send_packet(decoder.get(), packet.get())) < 0)
        isSpoiled = isPredicted();
    av_packet_unref(packet.get());
    return true;
}

libav::FramePtr VideoReader::Impl::decodeNextFrame()
{
    libav::FramePtr avFrame(libav::allocated(av_frame_alloc()));
    for (;;) {
        const int error = libav::checked(avcodec_receive_frame(decoder.get(), avFrame.get()));
        if (error == 0)
            return avFrame;
        if (error == AVERROR_EOF || (error == AVERROR(EAGAIN) && !sendPacket()))
            return nullptr;
    }
}

/// What libavcodec made as a frame, if it is sound.
std::optional<Frame> VideoReader::Impl::frameFrom(libav::FramePtr avFrame, std::int64_t frameNumber)
{
    if (frameNumber < 0 || frameNumber >= static_cast<std::int64_t>(index.frames.size()) ||
        !isSound(*avFrame))
        return std::nullopt;
    const Field first = firstFieldOf(*avFrame, input->stream().codecpar->field_order);
    auto frame = planes->frameOf(std::move(avFrame));
    if (!frame)
        return std::nullopt;
    statedFirst = first;
    frame->index = frameNumber;
    frame->time = index.times[static_cast<std::size_t>(frameNumber)];
    return frame;
}

/// The next good frame of an MJPEG stream, where every packet is a frame by itself; nullopt at the end.
std::optional<Frame> VideoReader::Impl::decodeJpegFrame()
{
    while (readPacket()) {
        const std::int64_t frameNumber = index.counted ? counted++ : index.frameOf(packet->pts);
        if (frameNumber < 0 || frameNumber >= static_cast<std::int64_t>(index.frames.size()))
            continue;
        Frame frame;
        const auto outcome = jpegDecoder->decode(JpegImage::bytesOf(*packet), region, frame);
        if (outcome == JpegDecoder::Outcome::Decoded) {
            frame.index = frameNumber;
            frame.time = index.times[static_cast<std::size_t>(frameNumber)];
            if (frame.validRegion)
                frame.coded = std::make_shared<JpegImage>(
                    libav::PacketPtr(libav::allocated(av_packet_clone(packet.get()))), jpegDecoder);
            return frame;
        }
        libav::FramePtr avFrame(libav::allocated(av_frame_alloc()));
        if (outcome == JpegDecoder::Outcome::NotSuitable &&
            libav::checked(avcodec_send_packet(decoder.get(), packet.get())) == 0 &&
            libav::checked(avcodec_receive_frame(decoder.get(), avFrame.get())) == 0)
            if (auto found = frameFrom(std::move(avFrame), frameNumber))
                return found;
    }
    return std::nullopt;
}

/// The next good frame with its index; nullopt at the end.
std::optional<Frame> VideoReader::Impl::decodeFrame()
{
    if (jpegDecoder)
        return decodeJpegFrame();
    while (libav::FramePtr avFrame = decodeNextFrame()) {
        const std::int64_t frameNumber = index.counted ? counted++ : index.frameOf(avFrame->pts);
        judge(*avFrame);
        if (isSpoiled)
            continue;
        if (auto frame = frameFrom(std::move(avFrame), frameNumber))
            return frame;
    }
    return std::nullopt;
}

/// Fills `ahead` with the first frame that is not before this one.
void VideoReader::Impl::decodeTo(std::size_t frame)
{
    while (!ahead || ahead->index < static_cast<std::int64_t>(frame)) {
        ahead = decodeFrame();
        if (!ahead)
            return;
    }
}

/// Has a frame as coded `ahead`, when all before it are behind.
Result<void> VideoReader::Impl::decodeExactly(std::size_t coded)
{
    decodeTo(coded);
    if (beganMidway && !isAhead(coded)) {
        // What the container calls a key frame was none (gradual refresh): only the long way is exact.
        ODO_TRY(restart());
        decodeTo(coded);
    }
    beganMidway = false;
    if (!isAhead(coded) && input->isCancelled())
        return cancelled(cannotDecode(coded));
    if (!isAhead(coded))
        return fail(ErrorCode::InvalidInput, cannotDecode(coded), dataAreDamaged(),
                    ODO_TEXT("video.frame_left_out", "it is left out"));
    return {};
}

Result<std::optional<Frame>> VideoReader::Impl::decoded(std::size_t wanted)
{
    ODO_TRY(decodeExactly(codedFrameOf(wanted)));
    if (!info.areFields)
        return std::exchange(ahead, std::nullopt);
    const bool isFirst = wanted % 2 == 0, isTop = firstField.value_or(statedFirst) == Field::Top;
    Frame frame = fieldOf(*ahead, isTop == isFirst ? Field::Top : Field::Bottom);
    frame.index = static_cast<std::int64_t>(wanted);
    frame.time = info.frameTimes[wanted];
    return frame;
}

Result<std::optional<Frame>> VideoReader::Impl::upright(std::size_t wanted)
{
    auto frame = decoded(wanted);
    if (stretcher && frame && *frame)
        **frame = stretcher->stretched(**frame);
    if (turner && frame && *frame)
        **frame = turner->turned(**frame);
    return frame;
}

/// Has the frames stretched and turned, as the container says or as they were measured.
void VideoReader::Impl::makeUpright(const KnownRecording &known)
{
    info.format = planes->format();
    if (const int width = shownWidth(*input, info.format, known); width != info.format.width) {
        stretcher.emplace(info.format, width);
        info.format = stretcher->format();
    }
    info.orientation = known.orientation.value_or(input->orientation());
    if (info.orientation != 1) {
        turner.emplace(info.format, info.orientation);
        info.format = turner->format();
    }
}

/// Gives fields from now on if the frames hold two of different moments, by what moves in them; where too
/// little does, by what the file says. Begins anew.
Result<void> VideoReader::Impl::judgeFields(bool isStated)
{
    constexpr std::size_t mostFrames = 500;
    FieldMotion motion;
    for (std::size_t i = 0; i < std::min(mostFrames, index.frames.size()) && !motion.isClear(); ++i) {
        const auto frame = decoded(i);
        if (!frame && frame.error().code != ErrorCode::InvalidInput)
            return tl::unexpected(frame.error());
        if (frame) // else it is damaged
            motion.add(**frame);
    }
    ODO_TRY(restart());
    using enum FieldMotion::Kind;
    const FieldMotion::Kind kind = motion.kind();
    info.areFields = kind == Unknown ? isStated : kind != Progressive;
    if (kind == TopFirst || kind == BottomFirst)
        firstField = kind == TopFirst ? Field::Top : Field::Bottom;
    if (info.areFields)
        info.frameTimes = fieldTimes(index.times);
    return {};
}

/// Whether decoding on is the shortest way to this frame.
bool VideoReader::Impl::isOnTheWay(std::size_t frame) const
{
    return frame >= nextIndex && (index.counted || index.keyPacketFor(codedFrameOf(frame)) <= packetsRead);
}

VideoReader::VideoReader(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoReader::~VideoReader() = default;

Result<std::unique_ptr<VideoReader>> VideoReader::open(const std::filesystem::path &file,
                                                       const CancelToken &cancel, const KnownRecording &known)
{
    return orShortage(cannotOpenVideo(file), [&] { return openChecked(file, cancel, known); });
}

Result<std::unique_ptr<VideoReader>> VideoReader::openChecked(const std::filesystem::path &file,
                                                              const CancelToken &cancel,
                                                              const KnownRecording &known)
{
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    auto input = ODO_TRY(VideoInput::open(file, cancel));
    auto format = ODO_TRY(streamFormat(*input));
    auto decoder = ODO_TRY(openDecoder(*input));
    auto index = ODO_TRY(indexPackets(*input));
    auto pixels = static_cast<AVPixelFormat>(input->stream().codecpar->format);
    judgeByMost(index.firstJpegs, format, pixels);
    index.firstJpegs.clear();
    const bool isStated = holdsFields(*input, index);
    const std::size_t frames = index.frames.size();
    const bool mayBeFields = isStated ? known.frames != frames : known.frames == 2 * frames;
    impl->planes.emplace(pixels, format);
    impl->info = describe(*input, index);
    impl->info.bitDepth = bitsOf(pixels);
    impl->input = std::move(input);
    impl->index = std::move(index);
    impl->decoder = std::move(decoder);
    impl->makeUpright(known);
    if (impl->decoder->codec_id == AV_CODEC_ID_MJPEG)
        impl->jpegDecoder = std::make_shared<JpegDecoder>(format);
    ODO_TRY(impl->restart());
    if (mayBeFields)
        ODO_TRY(impl->judgeFields(isStated));
    return std::unique_ptr<VideoReader>(new VideoReader(std::move(impl)));
}

bool VideoReader::lacksTimes(const std::filesystem::path &file)
{
    const auto input = orShortage(cannotOpenVideo(file), [&] { return VideoInput::open(file); });
    return input && (*input)->isBareStream() && !(*input)->statedRate();
}

bool VideoReader::isShownOtherwise(const std::filesystem::path &file, const KnownRecording &known)
{
    const auto input = orShortage(cannotOpenVideo(file), [&] { return VideoInput::open(file); });
    if (!input)
        return false;
    const auto format = streamFormat(**input);
    return (known.orientation && *known.orientation != (*input)->orientation()) ||
           (format && shownWidth(**input, *format, known) != shownWidth(**input, *format, {}));
}

const VideoInfo &VideoReader::info() const
{
    return m_impl->info;
}

bool VideoReader::decodesRegions() const
{
    return m_impl->jpegDecoder && !m_impl->info.areFields && !m_impl->stretcher && !m_impl->turner;
}

Result<std::optional<Frame>> VideoReader::next(const std::optional<PixelRect> &region)
{
    Impl &d = *m_impl;
    d.region = decodesRegions() ? region : std::nullopt;
    if (d.nextIndex >= d.info.frameTimes.size())
        return std::nullopt;
    const std::size_t wanted = d.nextIndex++;
    return orShortage([&d, wanted] { return d.cannotDecode(wanted); },
                      [&d, wanted] { return d.upright(wanted); });
}

Result<void> VideoReader::seek(std::int64_t frameIndex)
{
    Impl &d = *m_impl;
    if (frameIndex < 0 || frameIndex >= static_cast<std::int64_t>(d.info.frameTimes.size()))
        return fail(ErrorCode::InvalidInput, d.cannotShow(frameIndex),
                    ODO_TEXT("video.frames_it_has", "it has frames 0 to %1")(d.info.frameTimes.size() - 1),
                    ODO_TEXT("video.choose_one_of_these", "choose one of these"));
    const auto frame = static_cast<std::size_t>(frameIndex);
    return orShortage([&d, frameIndex] { return d.cannotShow(frameIndex); },
                      [&d, frame]() -> Result<void> {
                          if (!d.isOnTheWay(frame) &&
                              (d.index.counted || !d.startAt(d.index.keyPacketFor(d.codedFrameOf(frame)))))
                              ODO_TRY(d.restart());
                          d.nextIndex = frame;
                          return {};
                      });
}

std::int64_t VideoReader::keyFrameBefore(std::int64_t frameIndex) const
{
    const PacketIndex &index = m_impl->index;
    if (index.counted || frameIndex < 0 ||
        frameIndex >= static_cast<std::int64_t>(m_impl->info.frameTimes.size()))
        return 0;
    const std::size_t coded = m_impl->codedFrameOf(static_cast<std::size_t>(frameIndex));
    const std::int64_t key = index.frameOf(index.packets[index.keyPacketFor(coded)].pts);
    return std::clamp<std::int64_t>(m_impl->info.areFields ? 2 * key : key, 0, frameIndex);
}

Result<Frame> VideoReader::frameAt(std::int64_t frameIndex)
{
    ODO_TRY(seek(frameIndex));
    auto frame = ODO_TRY(next());
    return std::move(*frame);
}

} // namespace odo
