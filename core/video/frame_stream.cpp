// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_stream.h"

#include "core/base/bounded_queue.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <thread>

namespace odo {

namespace {

/// CPU time of the calling thread.
Nanoseconds threadCpuTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

} // namespace

struct FrameStream::Impl
{
    Impl(std::unique_ptr<VideoReader> opened, std::size_t ahead) : reader(std::move(opened)), queue(ahead)
    {
        thread = std::thread([this] { readAll(); });
    }
    ~Impl()
    {
        queue.close();
        thread.join();
    }
    void readAll();

    std::unique_ptr<VideoReader> reader; ///< used by `thread` alone, but for its info, which never changes
    BoundedQueue<Frame> queue;
    std::atomic<std::int64_t> damaged = 0;
    std::atomic<std::int64_t> cpuNs = 0;
    std::thread thread;
};

void FrameStream::Impl::readAll()
{
    const Nanoseconds begin = threadCpuTime();
    for (;;) {
        auto frame = reader->next();
        cpuNs = (threadCpuTime() - begin).count();
        if (!frame)
            ++damaged; // the reader has stepped over it
        else if (!*frame || !queue.push(std::move(**frame)))
            break;
    }
    queue.close();
}

FrameStream::FrameStream(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
FrameStream::~FrameStream() = default;

Result<std::unique_ptr<FrameStream>> FrameStream::open(const std::filesystem::path &file, std::size_t ahead)
{
    auto reader = VideoReader::open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    auto impl = std::make_unique<Impl>(std::move(*reader), std::max<std::size_t>(ahead, 1));
    return std::unique_ptr<FrameStream>(new FrameStream(std::move(impl)));
}

const VideoInfo &FrameStream::info() const
{
    return m_impl->reader->info();
}

Result<std::optional<Frame>> FrameStream::pop()
{
    return m_impl->queue.pop();
}

std::int64_t FrameStream::damagedFrames() const
{
    return m_impl->damaged;
}

Nanoseconds FrameStream::decodeCpuTime() const
{
    return Nanoseconds(m_impl->cpuNs.load());
}

} // namespace odo
