// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/view_coder.h"

#include "core/base/shortage.h"
#include "core/capture/camera_source.h"
#include "core/video/jpeg.h"

#include <deque>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t mostUncoded = 32; // a second at 30 frames/s; at 1280×720 some 45 MB
constexpr double leastKnownS = 0.5;

} // namespace

/// What the thread keeps: the last seconds, and whom they go to.
struct ViewCoder::Coding
{
    JpegEncoder encoder;
    std::deque<CodedFrame> kept;
    std::size_t keptBytes = 0;
    std::optional<Nanoseconds> tooMuchUntil; ///< arrival of the newest frame dropped for its bytes
    std::uint64_t uncoded = 0;               ///< since the last one: lost here
    std::shared_ptr<ViewWriter> writer;

    /// As it came, or coded here.
    Result<CodedFrame> code(const UncodedFrame &uncoded)
    {
        const CapturedFrame &captured = uncoded.captured;
        CodedFrame coded{captured.jpeg,
                         captured.frame.format,
                         {captured.sequence, captured.frame.time, captured.hostTime},
                         uncoded.taken,
                         captured.clock,
                         uncoded.interruption,
                         uncoded.lostBefore};
        if (coded.jpeg)
            return coded;
        auto jpeg = ODO_TRY(encoder.encode(captured.frame));
        coded.jpeg = std::make_shared<const std::vector<std::uint8_t>>(std::move(jpeg));
        return coded;
    }

    void keep(CodedFrame frame, const KeptFrames &most)
    {
        keptBytes += frame.jpeg->size();
        const Nanoseconds oldest = frame.raw.arrival - most.length;
        kept.push_back(std::move(frame));
        while (!kept.empty() && (kept.front().raw.arrival < oldest || keptBytes > most.mostBytes)) {
            if (kept.front().raw.arrival >= oldest)
                tooMuchUntil = kept.front().raw.arrival;
            dropOldest();
        }
    }

    void dropOldest()
    {
        keptBytes -= kept.front().jpeg->size();
        kept.pop_front();
    }

    /// Of what is kept; 0 where that is too little to know.
    double bytesPerSecond() const
    {
        const double overS = kept.empty() ? 0 : toSeconds(kept.back().raw.arrival - kept.front().raw.arrival);
        return overS > leastKnownS ? static_cast<double>(keptBytes) / overS : 0;
    }

    void begin(Start start)
    {
        writer = std::move(start.writer);
        while (!kept.empty() && kept.front().raw.arrival < start.from)
            dropOldest();
        if (tooMuchUntil && *tooMuchUntil < start.from)
            tooMuchUntil.reset();
        if (tooMuchUntil && !kept.empty())
            tooMuchUntil = kept.front().raw.arrival;
        writer->offerKept(std::exchange(kept, {}), tooMuchUntil);
        keptBytes = 0;
        tooMuchUntil.reset();
    }

    void end(Stop stop)
    {
        if (writer) {
            writer->countLost(stop.lostBefore);
            writer->close();
            writer.reset();
        }
        stop.done.set_value();
    }
};

ViewCoder::ViewCoder(std::string uri, KeptFrames kept)
    : m_uri(std::move(uri)), m_mostKeptBytes(kept.mostBytes), m_keptFor(kept.length), m_work(mostUncoded)
{
}

ViewCoder::~ViewCoder() = default;

Result<void> ViewCoder::start()
{
    auto thread = startThread(cameraAtAddress(m_uri), [this] { run(); });
    if (!thread)
        return tl::unexpected(thread.error());
    m_thread = std::move(*thread);
    return {};
}

bool ViewCoder::offer(UncodedFrame uncoded)
{
    return m_work.tryPush(std::move(uncoded));
}

void ViewCoder::startWriting(std::shared_ptr<ViewWriter> writer, Nanoseconds from)
{
    if (m_thread.joinable())
        m_work.push(Start{std::move(writer), from});
    else
        writer->close();
}

std::future<void> ViewCoder::stopWriting(std::uint64_t lostBefore)
{
    Stop stop{{}, lostBefore};
    std::future<void> done = stop.done.get_future();
    if (m_thread.joinable())
        m_work.push(std::move(stop));
    else
        stop.done.set_value();
    return done;
}

void ViewCoder::end()
{
    m_work.close();
    if (m_thread.joinable())
        m_thread.join();
}

void ViewCoder::run()
{
    Coding coding;
    while (auto work = m_work.pop()) {
        if (auto *start = std::get_if<Start>(&*work))
            coding.begin(std::move(*start));
        else if (auto *stop = std::get_if<Stop>(&*work))
            coding.end(std::move(*stop));
        else if (coding.writer || m_keptFor.load() > Nanoseconds(0))
            code(coding, std::get<UncodedFrame>(*work));
    }
}

void ViewCoder::code(Coding &coding, const UncodedFrame &uncoded)
{
    auto coded =
        orShortage([this] { return ODO_TEXT("capture.picture_of_camera", "a frame of camera %1")(m_uri); },
                   [&] { return coding.code(uncoded); });
    if (!coded) {
        coding.uncoded += 1 + uncoded.lostBefore;
        if (coding.writer)
            coding.writer->fail(coded.error());
        return;
    }
    coded->lostBefore += std::exchange(coding.uncoded, 0);
    if (coding.writer) {
        coding.writer->offer(std::move(*coded));
        return;
    }
    coding.keep(std::move(*coded), {m_keptFor, m_mostKeptBytes});
    if (const double rate = coding.bytesPerSecond(); rate > 0)
        m_bytesPerSecond = rate;
}

} // namespace odo
