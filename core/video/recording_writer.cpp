// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/recording_writer.h"

#include "core/base/file_system.h"
#include "core/video/libav.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

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
    int descriptor = -1; ///< of the same file, for fdatasync
    std::int64_t lastMs = -1, frameMs = 33;
    Nanoseconds synced{0};

    ~Impl() { close(); }
    tl::unexpected<Error> problem(const std::string &why) const
    {
        return fail(ErrorCode::Io, "cannot write the recording " + file.string(), why,
                    "check that its folder may be written to and has room");
    }
    Result<void> open(const FrameFormat &format);
    bool close();
};

Result<void> RecordingWriter::Impl::open(const FrameFormat &format)
{
    descriptor = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
    if (descriptor < 0)
        return problem(std::strerror(errno));
    const std::string name = "file:" + files::absolute(file).string();
    int error = avformat_alloc_output_context2(&container, nullptr, "matroska", name.c_str());
    if (error >= 0)
        error = avio_open2(&container->pb, name.c_str(), AVIO_FLAG_WRITE, nullptr, nullptr);
    if (error < 0)
        return problem(libav::errorText(error));
    container->flags |= AVFMT_FLAG_FLUSH_PACKETS | AVFMT_FLAG_BITEXACT;
    stream = libav::allocated(avformat_new_stream(container, nullptr));
    AVCodecParameters &parameters = *stream->codecpar;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = AV_CODEC_ID_MJPEG;
    parameters.format = pixelFormatOf(format);
    parameters.width = format.width;
    parameters.height = format.height;
    parameters.color_range = AVCOL_RANGE_JPEG;
    parameters.color_space = format.matrix == YuvMatrix::Bt709 ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
    parameters.chroma_location = format.siting == ChromaSiting::Left      ? AVCHROMA_LOC_LEFT
                                 : format.siting == ChromaSiting::TopLeft ? AVCHROMA_LOC_TOPLEFT
                                                                          : AVCHROMA_LOC_CENTER;
    stream->time_base = milliseconds;
    libav::Options muxing;
    muxing.set("cluster_time_limit", clusterMs);
    if (error = avformat_write_header(container, muxing.get()); error < 0)
        return problem(libav::errorText(error));
    return {};
}

bool RecordingWriter::Impl::close()
{
    bool closed = !container || !container->pb || avio_closep(&container->pb) >= 0;
    avformat_free_context(container);
    container = nullptr;
    if (descriptor >= 0) {
        closed = ::fsync(descriptor) == 0 && closed;
        ::close(descriptor);
        descriptor = -1;
    }
    return closed;
}

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
RecordingWriter::~RecordingWriter() = default;

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path &file, const FrameFormat &format,
                                                                 double nominalFramesPerSecond)
{
    libav::quieten();
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->frameMs = std::max<std::int64_t>(1, std::llround(1000 / std::max(1.0, nominalFramesPerSecond)));
    if (auto opened = impl->open(format); !opened)
        return tl::unexpected(opened.error());
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(impl)));
}

Result<void> RecordingWriter::write(std::span<const std::uint8_t> jpeg, Nanoseconds time)
{
    Impl &d = *m_impl;
    if (!d.container)
        return d.problem("writing has failed before");
    const libav::PacketPtr packet(libav::allocated(av_packet_alloc()));
    // Not owned, so that the muxer only reads it.
    packet->data = const_cast<std::uint8_t *>(jpeg.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
    packet->size = static_cast<int>(jpeg.size());
    packet->flags = AV_PKT_FLAG_KEY;
    packet->stream_index = d.stream->index;
    packet->pts = packet->dts = d.lastMs = std::max(d.lastMs + 1, std::int64_t(std::llround(toSeconds(time) * 1000)));
    packet->duration = d.frameMs;
    int error = av_write_frame(d.container, packet.get());
    const bool syncNow = time - d.synced >= syncEach;
    if (error >= 0 && syncNow && ::fdatasync(d.descriptor) != 0)
        error = AVERROR(errno);
    if (error < 0) {
        d.close(); // after a failed write to the disk, a later one may seem to succeed
        return d.problem(libav::errorText(error));
    }
    if (syncNow)
        d.synced = time;
    return {};
}

Result<void> RecordingWriter::finish()
{
    Impl &d = *m_impl;
    if (!d.container)
        return d.problem("writing has failed before");
    const int error = av_write_trailer(d.container);
    if (!d.close() || error < 0)
        return d.problem(error < 0 ? libav::errorText(error) : std::strerror(errno));
    return {};
}

} // namespace odo
