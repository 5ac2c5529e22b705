// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/frame_fetcher.h"

#include "core/base/shortage.h"
#include "core/video/frame.h"
#include "core/video/image.h"
#include "core/video/video_reader.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/views/image/image_overlay.h"

#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <thread>

namespace odo {

namespace {

/// Stepping back through a coded video means decoding from the key frame on; so a run of frames is kept each
/// time.
constexpr qint64 framesKeptBehind = 12;
constexpr qsizetype cacheBytes = 64 << 20;

struct Request
{
    std::filesystem::path file;
    KnownRecording known;
    quint64 generation = 0; ///< of the file: answers to an older one are not delivered
    quint64 serial = 0;
    qint64 frame = 0;
    QSize size;
};

/// Images lately shown, of one size.
class FrameImageCache
{
public:
    std::optional<QImage> find(qint64 frame)
    {
        for (auto entry = m_entries.begin(); entry != m_entries.end(); ++entry) {
            if (entry->first == frame) {
                m_entries.splice(m_entries.begin(), m_entries, entry);
                return entry->second;
            }
        }
        return std::nullopt;
    }
    void insert(qint64 frame, const QImage &image)
    {
        if (find(frame))
            return;
        m_bytes += image.sizeInBytes();
        m_entries.emplace_front(frame, image);
        while (m_bytes > cacheBytes && m_entries.size() > 1) {
            m_bytes -= m_entries.back().second.sizeInBytes();
            m_entries.pop_back();
        }
    }
    void clear()
    {
        m_entries.clear();
        m_bytes = 0;
    }

private:
    std::list<std::pair<qint64, QImage>> m_entries; // the latest used first
    qsizetype m_bytes = 0;
};

} // namespace

struct FrameFetcher::Worker
{
    explicit Worker(FrameFetcher &fetcher)
        : owner(fetcher), thread(startThread(imageSubject(), [this] { work(); }))
    {
    }
    ~Worker()
    {
        {
            const std::lock_guard lock(mutex);
            ending = true;
        }
        ended.cancel();
        wake.notify_one();
        if (thread)
            thread->join();
    }

    void ask(Request request)
    {
        if (!thread)
            return deliver(request, {}, errorLine(thread.error()));
        {
            const std::lock_guard lock(mutex);
            newest = std::move(request);
        }
        wake.notify_one();
    }

    void work();
    void serve(const Request &request);
    bool prepare(const Request &request);
    Result<QImage> image(qint64 frame);
    void deliver(const Request &request, const QImage &image, const QString &error);

    // GUI thread
    FrameFetcher &owner;
    std::filesystem::path file;
    KnownRecording known;
    quint64 generation = 0, lastSerial = 0, answeredSerial = 0;

    // shared
    std::mutex mutex;
    std::condition_variable wake;
    std::optional<Request> newest;
    bool ending = false;
    const CancelToken ended; ///< so that the end needn't wait for a frame far from a key frame

    // worker's thread
    std::unique_ptr<VideoReader> reader;
    quint64 openGeneration = 0;
    QSize cachedSize;
    FrameImageCache cache;
    qint64 lastFrame = -1;
    std::optional<Frame> decoded; ///< lastFrame, for when it is wanted at another size

    Result<std::thread> thread; // last: starts when the rest is there
};

void FrameFetcher::Worker::work()
{
    for (;;) {
        Request request;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, [this] { return ending || newest; });
            if (ending)
                return;
            request = *std::exchange(newest, std::nullopt);
        }
        const auto served = orShortage(imageSubject(), [&]() -> Result<void> {
            serve(request);
            return {};
        });
        if (!served)
            deliver(request, {}, errorLine(served.error()));
    }
}

bool FrameFetcher::Worker::prepare(const Request &request)
{
    if (request.generation != openGeneration) {
        openGeneration = request.generation;
        reader.reset();
        cache.clear();
        lastFrame = -1;
        decoded.reset();
        auto opened = VideoReader::open(request.file, ended, request.known);
        if (!opened) {
            deliver(request, {}, errorLine(opened.error()));
            return false;
        }
        reader = std::move(*opened);
    }
    if (request.size != cachedSize) {
        cachedSize = request.size;
        cache.clear();
    }
    return reader != nullptr;
}

Result<QImage> FrameFetcher::Worker::image(qint64 frame)
{
    if (!decoded || frame != lastFrame) {
        decoded.reset();
        decoded = ODO_TRY(reader->frameAt(frame));
        lastFrame = frame;
    }
    return toImage(toScreen(*decoded, cachedSize.width(), cachedSize.height()));
}

void FrameFetcher::Worker::serve(const Request &request)
{
    if (!prepare(request)) {
        deliver(request, {}, {});
        return;
    }
    const auto known = cache.find(request.frame);
    if (known) {
        deliver(request, *known, {});
        return;
    }
    const bool goesBack = request.frame < lastFrame && request.frame >= lastFrame - framesKeptBehind;
    if (goesBack) {
        for (qint64 frame = std::max<qint64>(0, request.frame - framesKeptBehind); frame < request.frame;
             ++frame) {
            if (const auto before = image(frame))
                cache.insert(frame, *before);
        }
    }
    const auto wanted = image(request.frame);
    if (!wanted) {
        deliver(request, {}, errorLine(wanted.error()));
        return;
    }
    cache.insert(request.frame, *wanted);
    deliver(request, *wanted, {});
}

void FrameFetcher::Worker::deliver(const Request &request, const QImage &image, const QString &error)
{
    callLater(&owner, [this, generationAsked = request.generation, serial = request.serial,
                       frame = request.frame, image, error] {
        if (generationAsked != generation)
            return;
        answeredSerial = std::max(answeredSerial, serial);
        if (!image.isNull())
            Q_EMIT owner.frameReady(frame, image);
        else if (!error.isEmpty())
            Q_EMIT owner.failed(frame, error);
    });
}

FrameFetcher::FrameFetcher(QObject *parent) : QObject(parent), m_worker(std::make_unique<Worker>(*this)) {}
FrameFetcher::~FrameFetcher() = default;

void FrameFetcher::setFile(const std::filesystem::path &file, const KnownRecording &known)
{
    m_worker->file = file;
    m_worker->known = known;
    ++m_worker->generation;
    m_worker->answeredSerial = m_worker->lastSerial;
}

void FrameFetcher::request(qint64 frame, QSize sizePx)
{
    if (m_worker->file.empty() || sizePx.isEmpty())
        return;
    m_worker->ask(
        {m_worker->file, m_worker->known, m_worker->generation, ++m_worker->lastSerial, frame, sizePx});
}

bool FrameFetcher::isIdle() const
{
    return m_worker->answeredSerial == m_worker->lastSerial;
}

} // namespace odo
