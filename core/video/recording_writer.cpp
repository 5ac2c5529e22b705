// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/recording_writer.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_handle.h"
#include "core/video/internal/libav.h"

#include <algorithm>
#include <cerrno>
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

constexpr int bufferBytes = 1 << 16;

} // namespace

struct RecordingWriter::Impl
{
    std::filesystem::path file;
    AVFormatContext *container = nullptr;
    AVStream *stream = nullptr;
    FileHandle handle;
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
    Result<void> openFile();
    Result<void> open(const FrameFormat &format);
    std::error_code close();
    /// As libav calls it. It opens no file by its name, which could be another one's by then.
    static int writeToFile(void *impl, std::uint8_t *bytes, int count);
    static std::int64_t seekInFile(void *impl, std::int64_t offset, int whence);
};

/// Never through a link, nor over what is there: the name may be claimed, with nothing in the file yet.
Result<void> RecordingWriter::Impl::openFile()
{
    auto opened =
        FileHandle::openOrCreate(file, FileHandle::Use::Write, FileHandle::Permissions::UserDefault);
    if (!opened)
        return systemProblem(opened.error());
    handle = std::move(*opened);
    const auto there = handle.status();
    if (!there)
        return systemProblem(there.error());
    return there->bytes > 0 || there->kind != files::Kind::File
               ? systemProblem(std::make_error_code(std::errc::file_exists))
               : Result<void>();
}

Result<void> RecordingWriter::Impl::open(const FrameFormat &format)
{
    ODO_TRY(openFile());
    const int error = avformat_alloc_output_context2(&container, nullptr, "matroska", nullptr);
    if (error < 0)
        return libavProblem(error);
    auto *buffer = static_cast<unsigned char *>(libav::allocated(av_malloc(bufferBytes)));
    container->pb = avio_alloc_context(buffer, bufferBytes, 1, this, nullptr, writeToFile, seekInFile);
    if (!container->pb) {
        av_free(buffer);
        return libavProblem(AVERROR(ENOMEM));
    }
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

int RecordingWriter::Impl::writeToFile(void *impl, std::uint8_t *bytes, int count)
{
    const auto *begin = reinterpret_cast<const char *>(bytes);
    const std::error_code problem =
        static_cast<Impl *>(impl)->handle.write({begin, static_cast<std::size_t>(count)});
    return problem ? AVERROR(problem.value()) : count;
}

std::int64_t RecordingWriter::Impl::seekInFile(void *impl, std::int64_t offset, int whence)
{
    if ((whence & AVSEEK_SIZE) != 0)
        return AVERROR(ENOSYS);
    const auto at = static_cast<Impl *>(impl)->handle.seek(offset, whence & ~AVSEEK_FORCE);
    return at ? *at : AVERROR(at.error().value());
}

/// Why what was written may not all be on the disk.
std::error_code RecordingWriter::Impl::close()
{
    std::error_code failed;
    if (container && container->pb) {
        avio_flush(container->pb);
        if (container->pb->error < 0)
            failed.assign(AVUNERROR(container->pb->error), std::generic_category());
        av_freep(static_cast<void *>(&container->pb->buffer));
        avio_context_free(&container->pb);
    }
    avformat_free_context(container);
    container = nullptr;
    if (handle.isOpen())
        if (const std::error_code unsafe = handle.sync())
            failed = unsafe;
    handle = {};
    return failed;
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
        if (const std::error_code unsafe = d.handle.syncData())
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
