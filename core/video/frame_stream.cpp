// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_stream.h"

#include "core/base/bounded_queue.h"
#include "core/base/platform/process.h"
#include "core/base/shortage.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace odo {

struct FrameStream::Impl
{
    Impl(std::unique_ptr<VideoReader> opened, std::size_t ahead) : reader(std::move(opened)), queue(ahead)
    {
        if (ahead == 0)
            return;
        if (auto started = startThread({}, [this] { readAll(); })) // else pop() decodes
            thread = std::move(*started);
    }
    ~Impl()
    {
        queue.close();
        if (thread.joinable())
            thread.join();
    }
    Result<std::optional<Frame>> readOne(const std::optional<PixelRect> &region);
    Result<void> readOn();
    void readAll();
    Result<std::optional<Frame>> popAhead();

    std::unique_ptr<VideoReader> reader; ///< used by one thread alone, but for its info, which never changes
    BoundedQueue<Frame> queue;
    std::atomic<std::int64_t> cpuNs = 0;
    Result<void> end; ///< of the thread, before it closes the queue
    std::thread thread;
};

/// The next frame that is not damaged.
Result<std::optional<Frame>> FrameStream::Impl::readOne(const std::optional<PixelRect> &region)
{
    const Nanoseconds begin = threadCpuTime();
    auto frame = reader->next(region);
    while (!frame && frame.error().code == ErrorCode::InvalidInput)
        frame = reader->next(region); // it has stepped over a damaged one
    cpuNs += (threadCpuTime() - begin).count();
    return frame;
}

Result<void> FrameStream::Impl::readOn()
{
    for (;;) {
        auto frame = ODO_TRY(readOne(std::nullopt));
        if (!frame || !queue.push(std::move(*frame)))
            return {};
    }
}

void FrameStream::Impl::readAll()
{
    end = orShortage(ODO_TEXT("video.cannot_decode", "cannot decode the video"), [this] { return readOn(); });
    queue.close();
}

Result<std::optional<Frame>> FrameStream::Impl::popAhead()
{
    auto frame = queue.pop();
    if (!frame && !end)
        return tl::unexpected(end.error());
    return frame;
}

FrameStream::FrameStream(std::unique_ptr<VideoReader> reader, std::size_t ahead)
    : m_impl(std::make_unique<Impl>(std::move(reader), ahead))
{
}

FrameStream::~FrameStream() = default;

Result<std::unique_ptr<FrameStream>> FrameStream::open(const std::filesystem::path &file, std::size_t ahead,
                                                       const CancelToken &cancel, const KnownRecording &known)
{
    auto reader = ODO_TRY(VideoReader::open(file, cancel, known));
    return std::make_unique<FrameStream>(std::move(reader), std::max<std::size_t>(ahead, 1));
}

const VideoInfo &FrameStream::info() const
{
    return m_impl->reader->info();
}

Result<std::optional<Frame>> FrameStream::pop(const std::optional<PixelRect> &region)
{
    return m_impl->thread.joinable() ? m_impl->popAhead() : m_impl->readOne(region);
}

Nanoseconds FrameStream::decodeCpuTime() const
{
    return Nanoseconds(m_impl->cpuNs.load());
}

} // namespace odo
