// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/view_coder.h"

#include "core/base/shortage.h"
#include "core/capture/camera_errors.h"
#include "core/video/jpeg.h"

#include <deque>

namespace odo {

namespace {

constexpr std::size_t mostUncoded = 32; // a second at 30 frames/s; at 1280×720 some 45 MB
constexpr std::size_t mostKeptBytes = 64 << 20;
constexpr double leastKnownS = 0.5;

} // namespace

/// What the thread keeps: the last seconds, and whom they go to.
struct ViewCoder::Coding
{
    JpegEncoder encoder;
    std::deque<CodedFrame> kept;
    std::size_t keptBytes = 0;
    std::shared_ptr<ViewWriter> writer;

    /// As it came, or coded here.
    Result<CodedFrame> code(const Picture &picture)
    {
        const CapturedFrame &captured = picture.captured;
        CodedFrame coded{captured.jpeg,
                         captured.frame.format,
                         {captured.sequence, captured.frame.time, captured.hostTime},
                         picture.taken,
                         captured.clock,
                         picture.interruption,
                         picture.lostBefore};
        if (coded.jpeg)
            return coded;
        auto jpeg = ODO_TRY(encoder.encode(captured.frame));
        coded.jpeg = std::make_shared<const std::vector<std::uint8_t>>(std::move(jpeg));
        return coded;
    }

    void keep(CodedFrame frame, Nanoseconds howLong)
    {
        keptBytes += frame.jpeg->size();
        const Nanoseconds oldest = frame.raw.arrival - howLong;
        kept.push_back(std::move(frame));
        while (!kept.empty() && (kept.front().raw.arrival < oldest || keptBytes > mostKeptBytes)) {
            keptBytes -= kept.front().jpeg->size();
            kept.pop_front();
        }
    }

    /// Of what is kept; 0 where that is too little to tell.
    double bytesPerSecond() const
    {
        const double overS = kept.empty() ? 0 : toSeconds(kept.back().raw.arrival - kept.front().raw.arrival);
        return overS > leastKnownS ? static_cast<double>(keptBytes) / overS : 0;
    }

    void begin(Start start)
    {
        writer = std::move(start.writer);
        for (CodedFrame &frame : kept) {
            if (frame.raw.arrival >= start.from)
                writer->offer(std::move(frame));
        }
        kept.clear();
        keptBytes = 0;
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

ViewCoder::ViewCoder(std::string uri, Nanoseconds preRoll)
    : m_uri(std::move(uri)), m_preRoll(preRoll), m_work(mostUncoded)
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

bool ViewCoder::offer(Picture picture)
{
    return m_work.tryPush(std::move(picture));
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
        else if (coding.writer || m_preRoll > Nanoseconds(0))
            code(coding, std::get<Picture>(*work));
    }
}

void ViewCoder::code(Coding &coding, const Picture &picture)
{
    auto coded =
        orShortage([this] { return ODO_TEXT("capture.picture_of_camera", "a picture of camera %1")(m_uri); },
                   [&] { return coding.code(picture); });
    if (!coded) {
        if (coding.writer)
            coding.writer->fail(coded.error());
        return;
    }
    if (coding.writer) {
        coding.writer->offer(std::move(*coded));
        return;
    }
    coding.keep(std::move(*coded), m_preRoll);
    if (const double rate = coding.bytesPerSecond(); rate > 0)
        m_bytesPerSecond = rate;
}

} // namespace odo
