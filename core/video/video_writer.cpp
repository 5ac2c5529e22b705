// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_writer.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/files/output_file.h"
#include "core/video/internal/claimed_output.h"
#include "core/video/internal/libav.h"
#include "core/video/internal/video_encoder.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace odo {

namespace {

constexpr std::size_t headBytes = 8192; // the muxer writes Info and Tags before the first cluster

Message cannotWrite(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_write", "cannot write the video %1")(Named::file(file));
}

} // namespace

/// libav's Matroska muxer counts in milliseconds and nothing else, which would shift frames by up to half of
/// one. So the writer hands it microseconds as if they were milliseconds, and this turns the finished file
/// into the truth: it sets TimestampScale (RFC 9559 §5.1.2.9) to 1000 ns and the DURATION tag to the real
/// duration. The file must have been written without CRC-32 elements.
Result<void> setMicrosecondScale(const std::filesystem::path &file, Nanoseconds duration)
{
    using namespace std::string_literals;
    static const std::string milliseconds =
        "\x2a\xd7\xb1\x83\x0f\x42\x40"s; // TimestampScale, 3 bytes, 1 000 000 ns
    static const std::string microseconds = "\x2a\xd7\xb1\x83\x00\x03\xe8"s; // 1000 ns
    static const std::string tag = "DURATION\x44\x87"s; // a SimpleTag's name, then TagString
    constexpr std::size_t durationLetters = 18;         // "00:00:12.345678000"

    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    std::string head(headBytes, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    const std::size_t scaleAt = head.find(milliseconds);
    if (scaleAt == std::string::npos)
        return fail(ErrorCode::Internal, cannotWrite(file),
                    ODO_TEXT("video.no_time_scale",
                             "its time scale was not found where the muxer should have put it"),
                    ODO_TEXT("video.report_bug", "report this as a bug"));
    stream.seekp(static_cast<std::streamoff>(scaleAt));
    stream.write(microseconds.data(), static_cast<std::streamsize>(microseconds.size()));

    if (const std::size_t tagAt = head.find(tag); tagAt != std::string::npos) {
        const long long ns = duration.count();
        const long long seconds = ns / 1'000'000'000;
        char text[40];
        std::snprintf(text, sizeof text, "%02lld:%02lld:%02lld.%09lld", seconds / 3600 % 100,
                      seconds / 60 % 60, seconds % 60, ns % 1'000'000'000);
        stream.seekp(static_cast<std::streamoff>(tagAt + tag.size() + 1)); // after the length byte
        stream.write(text, durationLetters);
    }
    stream.close();
    if (!stream)
        return fail(ErrorCode::Io, cannotWrite(file),
                    ODO_TEXT("video.header_not_rewritten", "its header could not be rewritten"),
                    ODO_TEXT("video.check_room", "check the free disk space"));
    return {};
}

namespace {

// A block's time stamp is 16 bits relative to its cluster's; in microseconds that is 32 ms.
constexpr int longestMatroskaClusterUs = 30'000;

} // namespace

FileKind videoKind(const std::filesystem::path &file)
{
    return file.extension() == ".mkv" ? FileKind::Matroska : FileKind::Mp4;
}

struct VideoWriter::Impl
{
    std::filesystem::path file;
    std::unique_ptr<OutputFile> output; ///< null: of a claimed file
    ClaimedOutput claimed;
    std::filesystem::path written; ///< until it is finished
    FrameFormat format;
    VideoWriterOptions options;
    bool matroska = false;
    libav::CodecPtr encoder;
    libav::FilterPtr filter;
    AVFormatContext *container = nullptr;
    AVStream *stream = nullptr;
    bool failed = false;
    bool started = false;
    Nanoseconds firstTime{0}, lastTime{0};
    std::int64_t lastUs = 0;

    ~Impl() { closeFile(); }
    tl::unexpected<Error> problem(int error) const
    {
        return fail(ErrorCode::Io, cannotWrite(file), foreignWords(libav::errorText(error)),
                    ODO_TEXT("video.check_the_folder",
                             "check that the folder exists, may be written to and has free space"));
    }
    Result<void> openContainer(const OutputTarget &target);
    Result<void> openClaimed();
    Result<void> addStream();
    Result<void> encode(const AVFrame *avFrame);
    Result<void> mux(AVPacket *packet) const;
    Result<void> muxThroughFilter(AVPacket *packet);
    int closeFile();
    Nanoseconds duration() const;
};

Result<void> VideoWriter::Impl::openContainer(const OutputTarget &target)
{
    const std::string extension = file.extension().string();
    matroska = videoKind(file) == FileKind::Matroska;
    if (!matroska && extension != ".mp4")
        return fail(ErrorCode::InvalidInput, cannotWrite(file),
                    ODO_TEXT("video.no_known_ending", "its name ends with neither .mkv nor .mp4"),
                    ODO_TEXT("video.give_known_ending", "give it one of these endings"));
    if (options.codec == VideoCodec::Ffv1 && !matroska)
        return fail(ErrorCode::InvalidInput, cannotWrite(file),
                    ODO_TEXT("video.no_ffv1_in_mp4", "MP4 cannot contain FFV1"),
                    ODO_TEXT("video.use_mkv", "use the ending .mkv"));
    output = ODO_TRY(OutputFile::open(target, videoKind(file)));
    written = output->temporary();
    const std::string name = "file:" + written.string(); // absolute
    int error =
        avformat_alloc_output_context2(&container, nullptr, matroska ? "matroska" : "mp4", name.c_str());
    if (error < 0)
        return problem(error);
    container->flags |= AVFMT_FLAG_BITEXACT;
    error = avio_open2(&container->pb, name.c_str(), AVIO_FLAG_WRITE, nullptr, nullptr);
    if (error < 0)
        return problem(error);
    return {};
}

Result<void> VideoWriter::Impl::openClaimed()
{
    matroska = true;
    written = file;
    if (const std::error_code unopened = claimed.open(file))
        return problem(AVERROR(unopened.value()));
    if (const int error = avformat_alloc_output_context2(&container, nullptr, "matroska", nullptr); error < 0)
        return problem(error);
    container->flags |= AVFMT_FLAG_BITEXACT;
    container->pb = claimed.io();
    return {};
}

Result<void> VideoWriter::Impl::addStream()
{
    if (matroska)
        options.maxBFrames = 0; // their time stamps would lie before their cluster's, out of reach of 16 bits
    auto opened =
        ODO_TRY(openEncoder(format, options, (container->oformat->flags & AVFMT_GLOBALHEADER) != 0));
    encoder = std::move(opened);
    auto described = ODO_TRY(describeStream(*encoder, format));
    filter = std::move(described.filter);
    stream = libav::allocated(avformat_new_stream(container, nullptr));
    avcodec_parameters_copy(stream->codecpar, described.parameters.get());
    stream->codecpar->codec_tag = 0;
    stream->time_base = encodingTimeBase;
    stream->avg_frame_rate = encoder->framerate;
    libav::Options muxing;
    if (matroska) {
        muxing.set("cluster_time_limit", longestMatroskaClusterUs);
        muxing.set("write_crc32", 0);
    } else {
        muxing.set("video_track_timescale", encodingTimeBase.den);
        muxing.set("movflags", "+faststart+write_colr");
    }
    if (const int error = avformat_write_header(container, muxing.get()); error < 0)
        return problem(error);
    return {};
}

Result<void> VideoWriter::Impl::mux(AVPacket *packet) const
{
    packet->stream_index = stream->index;
    if (packet->duration == 0)
        packet->duration = std::llround(encodingTimeBase.den / options.nominalFramesPerSecond);
    if (!matroska) // there, the muxer's "milliseconds" are our microseconds
        av_packet_rescale_ts(packet, encodingTimeBase, stream->time_base);
    if (const int error = av_write_frame(container, packet); error < 0)
        return problem(error);
    return {};
}

Result<void> VideoWriter::Impl::muxThroughFilter(AVPacket *packet)
{
    if (!filter)
        return mux(packet);
    if (const int error = av_bsf_send_packet(filter.get(), packet); error < 0)
        return problem(error);
    while (av_bsf_receive_packet(filter.get(), packet) == 0)
        ODO_TRY(mux(packet));
    return {};
}

Result<void> VideoWriter::Impl::encode(const AVFrame *avFrame)
{
    if (const int error = avcodec_send_frame(encoder.get(), avFrame); error < 0)
        return problem(error);
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    for (;;) {
        const int error = avcodec_receive_packet(encoder.get(), packet.get());
        if (error == AVERROR(EAGAIN) || error == AVERROR_EOF)
            return {};
        if (error < 0)
            return problem(error);
        ODO_TRY(muxThroughFilter(packet.get()));
    }
}

int VideoWriter::Impl::closeFile()
{
    int error = 0;
    if (claimed.io()) {
        const std::error_code unsafe = claimed.close();
        error = unsafe ? AVERROR(unsafe.value()) : 0;
    } else if (container && container->pb) {
        error = avio_closep(&container->pb);
    }
    avformat_free_context(container);
    container = nullptr;
    return error;
}

Nanoseconds VideoWriter::Impl::duration() const
{
    return lastTime - firstTime + fromSeconds(1.0 / options.nominalFramesPerSecond);
}

VideoWriter::VideoWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoWriter::~VideoWriter() = default;

Result<std::unique_ptr<VideoWriter::Impl>> VideoWriter::prepared(const std::filesystem::path &file,
                                                                 const FrameFormat &format,
                                                                 const VideoWriterOptions &options)
{
    libav::quieten();
    if (!(options.nominalFramesPerSecond > 0.0 && options.nominalFramesPerSecond <= 100'000.0))
        return fail(ErrorCode::InvalidInput, cannotWrite(file),
                    ODO_TEXT("video.rate_not_positive", "its frame rate is not positive"),
                    ODO_TEXT("video.give_rate", "give the frames per second, e.g. 30"));
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->format = format;
    impl->options = options;
    return impl;
}

Result<std::unique_ptr<VideoWriter>>
VideoWriter::create(const OutputTarget &target, const FrameFormat &format, const VideoWriterOptions &options)
{
    auto impl = ODO_TRY(prepared(target.file, format, options));
    ODO_TRY(impl->openContainer(target));
    ODO_TRY(impl->addStream());
    return std::unique_ptr<VideoWriter>(new VideoWriter(std::move(impl)));
}

Result<std::unique_ptr<VideoWriter>> VideoWriter::createClaimed(const std::filesystem::path &claimed,
                                                                const FrameFormat &format,
                                                                const VideoWriterOptions &options)
{
    auto impl = ODO_TRY(prepared(claimed, format, options));
    ODO_TRY(impl->openClaimed());
    ODO_TRY(impl->addStream());
    return std::unique_ptr<VideoWriter>(new VideoWriter(std::move(impl)));
}

Result<void> VideoWriter::write(const Frame &frame)
{
    Impl &d = *m_impl;
    const Message what =
        ODO_TEXT("video.cannot_write_frame", "cannot write a frame to the video %1")(Named::file(d.file));
    if (d.failed)
        return fail(ErrorCode::Io, what, writingFailedBefore(),
                    ODO_TEXT("video.start_video_again", "start the video again"));
    if (!sameLayout(frame.format, d.format) || frame.format.siting != d.format.siting)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.format_differs", "its format differs from the video's"),
                    ODO_TEXT("video.write_one_format", "write one format to a file"));
    if (!d.started)
        d.firstTime = frame.time;
    const std::int64_t timeUs =
        std::llround(static_cast<double>((frame.time - d.firstTime).count()) / 1000.0);
    if (d.started && timeUs <= d.lastUs)
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("video.time_not_after", "its time is not later than that of the frame before"),
            ODO_TEXT("video.write_in_order", "write the frames in order, at least a microsecond apart"));
    auto avFrame = ODO_TRY(avFrameOf(frame, *d.encoder, timeUs));
    d.started = true;
    d.lastUs = timeUs;
    d.lastTime = frame.time;
    auto encoded = d.encode(avFrame.get());
    d.failed = !encoded;
    return encoded;
}

Result<void> VideoWriter::finish()
{
    Impl &d = *m_impl;
    const Message what = ODO_TEXT("video.cannot_finish", "cannot finish the video %1")(Named::file(d.file));
    if (!d.container || d.failed)
        return fail(ErrorCode::Io, what,
                    d.failed ? writingFailedBefore() : ODO_TEXT("video.is_finished", "it is finished"),
                    ODO_TEXT("video.start_it_again", "start it again"));
    if (!d.started)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.no_frame_written", "no frame was written to it"),
                    ODO_TEXT("video.write_at_least_one", "write at least one"));
    ODO_TRY(d.encode(nullptr));
    if (const int error = av_write_trailer(d.container); error < 0)
        return d.problem(error);
    if (const int error = d.closeFile(); error < 0)
        return d.problem(error);
    if (d.matroska)
        ODO_TRY(setMicrosecondScale(d.written, d.duration()));
    return d.output ? d.output->commit() : Result<void>();
}

} // namespace odo
