// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/recording_writer.h"

#include "core/video/internal/claimed_output.h"
#include "core/video/internal/libav.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace odo {

namespace {

constexpr AVRational milliseconds{1, 1000}; // Matroska's own
constexpr int clusterMs = 500;
constexpr Nanoseconds syncEach = std::chrono::milliseconds(clusterMs);

AVPixelFormat pixelFormatOf(const FrameFormat &format)
{
    if (format.chromaShiftX == 0)
        return format.chromaShiftY == 0 ? AV_PIX_FMT_YUVJ444P : AV_PIX_FMT_YUVJ440P;
    return format.chromaShiftY == 0 ? AV_PIX_FMT_YUVJ422P : AV_PIX_FMT_YUVJ420P;
}

} // namespace

struct RecordingWriter::Impl
{
    std::filesystem::path file;
    AVFormatContext *container = nullptr;
    AVStream *stream = nullptr;
    ClaimedOutput output;
    std::int64_t lastMs = -1, frameMs = 33;
    Nanoseconds synced{0};

    ~Impl() { close(); }
    tl::unexpected<Error> problem(Message why) const
    {
        return fail(
            ErrorCode::Io,
            ODO_TEXT("video.cannot_write_recording", "cannot write the recording %1")(Named::file(file)),
            std::move(why),
            ODO_TEXT("video.check_its_folder", "check that its folder may be written to and has free space"));
    }
    tl::unexpected<Error> libavProblem(int error) const
    {
        return problem(foreignWords(libav::errorText(error)));
    }
    tl::unexpected<Error> systemProblem(const std::error_code &reason) const
    {
        return problem(foreignWords(reason.message()));
    }
    Result<void> open(const FrameFormat &format);
    std::error_code close();
};

Result<void> RecordingWriter::Impl::open(const FrameFormat &format)
{
    if (const std::error_code problem = output.open(file))
        return systemProblem(problem);
    const int error = avformat_alloc_output_context2(&container, nullptr, "matroska", nullptr);
    if (error < 0)
        return libavProblem(error);
    container->pb = output.io();
    container->flags |= AVFMT_FLAG_FLUSH_PACKETS | AVFMT_FLAG_BITEXACT;
    stream = libav::allocated(avformat_new_stream(container, nullptr));
    AVCodecParameters &parameters = *stream->codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = AV_CODEC_ID_MJPEG;
    parameters.format = pixelFormatOf(format);
    parameters.width = format.width;
    parameters.height = format.height;
    parameters.color_range = AVCOL_RANGE_JPEG;
    parameters.color_space = libav::colourSpaceOf(format.matrix);
    parameters.chroma_location = format.siting == ChromaSiting::Left      ? AVCHROMA_LOC_LEFT
                                 : format.siting == ChromaSiting::TopLeft ? AVCHROMA_LOC_TOPLEFT
                                                                          : AVCHROMA_LOC_CENTER;
    stream->time_base = milliseconds;
    libav::Options muxing;
    muxing.set("cluster_time_limit", clusterMs);
    const int begun = avformat_write_header(container, muxing.get());
    return begun < 0 ? libavProblem(begun) : Result<void>();
}

/// Why what was written may not all be on the disk.
std::error_code RecordingWriter::Impl::close()
{
    avformat_free_context(container);
    container = nullptr;
    return output.close();
}

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
RecordingWriter::~RecordingWriter() = default;

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path &file,
                                                                 const FrameFormat &format,
                                                                 double nominalFramesPerSecond)
{
    libav::quieten();
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->frameMs = std::max<std::int64_t>(1, std::llround(1000 / std::max(1.0, nominalFramesPerSecond)));
    ODO_TRY(impl->open(format));
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(impl)));
}

Result<void> RecordingWriter::write(std::span<const std::uint8_t> jpeg, Nanoseconds time)
{
    Impl &d = *m_impl;
    if (!d.container)
        return d.problem(writingFailedBefore());
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    // Not owned, so that the muxer only reads it.
    packet->data =
        const_cast<std::uint8_t *>(jpeg.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
    packet->size = static_cast<int>(jpeg.size());
    packet->flags = AV_PKT_FLAG_KEY;
    packet->stream_index = d.stream->index;
    packet->pts = packet->dts = d.lastMs =
        std::max(d.lastMs + 1, std::int64_t(std::llround(toSeconds(time) * 1000)));
    packet->duration = d.frameMs;
    int error = av_write_frame(d.container, packet.get());
    const bool syncNow = time - d.synced >= syncEach;
    if (error >= 0 && syncNow)
        if (const std::error_code unsafe = d.output.syncData())
            error = AVERROR(unsafe.value());
    if (error < 0) {
        d.close(); // after a failed write to the disk, a later one may seem to succeed
        return d.libavProblem(error);
    }
    if (syncNow)
        d.synced = time;
    return {};
}

Result<void> RecordingWriter::finish()
{
    Impl &d = *m_impl;
    if (!d.container)
        return d.problem(writingFailedBefore());
    const int error = av_write_trailer(d.container);
    const std::error_code failed = d.close();
    if (error < 0)
        return d.libavProblem(error);
    return failed ? d.systemProblem(failed) : Result<void>();
}

} // namespace odo
