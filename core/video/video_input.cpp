// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_input.h"

#include "core/base/file_system.h"
#include "core/files/protected_files.h"

#include <algorithm>
#include <vector>

namespace odo {

namespace {

// The containers that cameras, telephones and editors write. Anything that can name another file (HLS, DASH,
// concat, SDP, image sequences, ...) is left out, and so is MXF: damaged lengths in 11 kB of it have libavformat ask for
// gigabytes and read one entry at a time, with no word in between by which it could be stopped.
constexpr const char *ordinaryContainers =
    "matroska,webm,mov,mp4,m4a,3gp,3g2,mj2,avi,mpegts,mpeg,mpegvideo,mjpeg,"
    "h264,hevc,m4v,ivf,flv,asf,ogg,nut,dv";

std::string couldNotOpen(const std::filesystem::path &file)
{
    return "cannot open the video " + file.string();
}

int refuseOtherFiles(AVFormatContext *, AVIOContext **, const char *, int, AVDictionary **)
{
    return AVERROR(EPERM);
}

Result<void> checkFile(const std::filesystem::path &file)
{
    if (auto may = checkMayBeRead(file, couldNotOpen(file)); !may)
        return may;
    std::error_code unknown;
    if (files::sizeOf(file, unknown) == 0)
        return fail(ErrorCode::InvalidInput, couldNotOpen(file), "the file is empty",
                    "copy it from the camera again");
    return {};
}

} // namespace

Result<std::unique_ptr<VideoInput>> VideoInput::open(const std::filesystem::path &file, const CancelToken &cancel)
{
    return open(file, nullptr, cancel);
}

Result<std::unique_ptr<VideoInput>> VideoInput::openedAgain() const
{
    return open(m_file, m_container->iformat, m_cancel);
}

Result<std::unique_ptr<VideoInput>> VideoInput::open(const std::filesystem::path &file, const AVInputFormat *known,
                                                      const CancelToken &cancel)
{
    libav::quieten();
    if (auto checked = checkFile(file); !checked)
        return tl::unexpected(checked.error());
    std::unique_ptr<VideoInput> input(new VideoInput(file, cancel));
    if (auto opened = input->openContainer(known); !opened)
        return tl::unexpected(opened.error());
    if (auto found = input->findStream(); !found)
        return tl::unexpected(found.error());
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
        return fail(ErrorCode::Io, couldNotOpen(m_file), libav::errorText(error),
                    "check that you may read the file");

    m_container = libav::allocated(avformat_alloc_context());
    m_container->pb = m_io;
    m_container->flags |= AVFMT_FLAG_CUSTOM_IO;
    m_container->io_open = refuseOtherFiles;
    libav::Options options;
    options.set("format_whitelist", ordinaryContainers);
    options.set("protocol_whitelist", "file");
    // Frees the context when it fails. That there is no memory libav also says of damaged lengths.
    error = avformat_open_input(&m_container, nullptr, known, options.get());
    if (error < 0)
        return fail(ErrorCode::InvalidInput, couldNotOpen(m_file),
                    "it is not a video of a kind that is read, or its header is damaged or missing (" +
                        libav::errorText(error) + ")",
                    "give an MP4, MOV, MKV or AVI file; copy it from the camera again if it was cut short");
    return {};
}

Result<void> VideoInput::findStream()
{
    std::vector<AVChromaLocation> stated;
    for (unsigned i = 0; i < m_container->nb_streams; ++i) {
        libav::forgetUnknownColours(*m_container->streams[i]->codecpar);
        stated.push_back(m_container->streams[i]->codecpar->chroma_location);
    }
    // It decodes pictures to find out; none that are too large to be read.
    std::vector<AVDictionary *> limits(m_container->nb_streams, nullptr);
    for (AVDictionary *&limit : limits)
        av_dict_set_int(&limit, "max_pixels", libav::mostPixels, 0);
    const int error = avformat_find_stream_info(m_container, limits.data());
    for (AVDictionary *&limit : limits)
        av_dict_free(&limit);
    const int best =
        error < 0 ? error : av_find_best_stream(m_container, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (best < 0 || (m_container->streams[best]->disposition & AV_DISPOSITION_ATTACHED_PIC) != 0)
        return fail(ErrorCode::InvalidInput, couldNotOpen(m_file),
                    "it holds no video stream that can be read", "give the file that the camera recorded");
    m_stream = m_container->streams[best];
    libav::forgetUnknownColours(*m_stream->codecpar);
    if (static_cast<std::size_t>(best) < stated.size())
        m_containerChromaLocation = stated[static_cast<std::size_t>(best)];
    return {};
}

int VideoInput::read(AVPacket &packet)
{
    for (;;) {
        av_packet_unref(&packet);
        if (m_cancel.isCancelled())
            return AVERROR_EXIT;
        const int error = av_read_frame(m_container, &packet);
        if (error < 0)
            return error;
        const AVStream &from = *m_container->streams[packet.stream_index];
        const std::int64_t begin = packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts;
        if (begin != AV_NOPTS_VALUE) {
            const std::int64_t start =
                m_container->start_time == AV_NOPTS_VALUE ? 0 : m_container->start_time;
            const std::int64_t end =
                av_rescale_q(av_sat_add64(begin, packet.duration), from.time_base, AVRational{1, AV_TIME_BASE});
            m_lastEnd = std::max(m_lastEnd, av_sat_sub64(end, start));
        }
        if (packet.stream_index == m_stream->index && packet.size > 0)
            return 0;
    }
}

bool VideoInput::seek(std::int64_t timeStamp)
{
    return av_seek_frame(m_container, m_stream->index, timeStamp, AVSEEK_FLAG_BACKWARD) >= 0;
}

} // namespace odo
