// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/view_writer.h"

#include "core/capture/recorded_clock.h"
#include "core/video/recording_writer.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t mostWaitingBytes = 64 << 20; // 14 s of 1280×720 at 30 frames/s

} // namespace

/// The file as it grows; of the writing thread.
struct ViewWriter::Output
{
    std::unique_ptr<RecordingWriter> writer;
    RawTime last;
    Nanoseconds time{0}; ///< of the last picture, in the file

    /// By the camera's clock; by ours where that was set anew.
    Nanoseconds timeOf(const RawTime &next) const
    {
        const Nanoseconds step = next.device - last.device;
        return time + (step > Nanoseconds(0) ? step : std::max(Nanoseconds(0), next.arrival - last.arrival));
    }
};

ViewWriter::ViewWriter(std::filesystem::path file, double nominalFramesPerSecond) : m_nominalFramesPerSecond(nominalFramesPerSecond)
{
    m_recording.file = std::move(file);
    m_thread = std::thread([this] { write(); });
}

ViewWriter::~ViewWriter()
{
    close();
    if (m_thread.joinable())
        m_thread.join();
}

void ViewWriter::offer(CodedFrame frame)
{
    const std::lock_guard lock(m_mutex);
    if (m_closed || m_recording.problem)
        return;
    m_recording.frames += 1 + frame.lostBefore;
    m_recording.lostByUs += frame.lostBefore;
    const std::uint64_t sequence = frame.raw.sequence;
    if (m_lastSequence && sequence > *m_lastSequence + 1 + frame.lostBefore)
        m_recording.lostOnWire += sequence - *m_lastSequence - 1 - frame.lostBefore;
    m_lastSequence = sequence;
    if (m_waitingBytes + frame.jpeg->size() > mostWaitingBytes) {
        ++m_recording.lostByUs;
        return;
    }
    m_waitingBytes += frame.jpeg->size();
    m_waiting.push_back(std::move(frame));
    m_wake.notify_all();
}

void ViewWriter::countLost(std::uint64_t pictures)
{
    const std::lock_guard lock(m_mutex);
    m_recording.frames += pictures;
    m_recording.lostByUs += pictures;
}

void ViewWriter::fail(const Error &error)
{
    const std::lock_guard lock(m_mutex);
    if (!m_recording.problem)
        m_recording.problem = error;
}

void ViewWriter::close()
{
    const std::lock_guard lock(m_mutex);
    m_closed = true;
    m_wake.notify_all();
}

std::optional<CodedFrame> ViewWriter::waitForNext()
{
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return m_closed || !m_waiting.empty(); });
    if (m_waiting.empty())
        return std::nullopt;
    CodedFrame frame = std::move(m_waiting.front());
    m_waiting.pop_front();
    return frame;
}

void ViewWriter::write()
{
    Output output;
    while (const auto frame = waitForNext()) {
        const auto written = write(output, *frame);
        const std::lock_guard lock(m_mutex);
        m_waitingBytes -= frame->jpeg->size();
        if (!written) {
            m_recording.problem = written.error();
            m_waiting.clear();
            m_waitingBytes = 0;
            return;
        }
        note(*frame);
    }
    if (output.writer) {
        if (const auto finished = output.writer->finish(); !finished)
            fail(finished.error());
    }
}

Result<void> ViewWriter::write(Output &output, const CodedFrame &frame)
{
    if (!output.writer) {
        auto writer = RecordingWriter::create(m_recording.file, frame.format, m_nominalFramesPerSecond);
        if (!writer)
            return tl::unexpected(writer.error());
        output.writer = std::move(*writer);
        output.last = frame.raw;
    }
    const Nanoseconds time = output.timeOf(frame.raw);
    if (auto written = output.writer->write(*frame.jpeg, time); !written)
        return written;
    output.last = frame.raw;
    output.time = time;
    return {};
}

/// A picture is in the file; the mutex is held.
void ViewWriter::note(const CodedFrame &frame)
{
    RecordedTimes &times = m_recording.times;
    if (times.pictures.empty()) {
        m_recording.format = frame.format;
        m_firstArrival = frame.raw.arrival;
    }
    if (frame.interruption && m_lastArrival)
        m_recording.gaps.push_back({times.pictures.size(), frame.raw.arrival - *m_lastArrival, *frame.interruption});
    m_lastArrival = frame.raw.arrival;
    m_bytes += frame.jpeg->size();
    const Nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
    m_recording.latenciesS.push_back(toSeconds(now - frame.taken));
    for (RecordedTimes *kept : {&times, &m_fresh}) {
        kept->pictures.push_back(frame.raw);
        if (frame.clock)
            kept->readings.push_back(*frame.clock);
    }
}

ViewWriter::State ViewWriter::state() const
{
    const std::lock_guard lock(m_mutex);
    return {static_cast<double>(m_waitingBytes) / static_cast<double>(mostWaitingBytes),
            m_firstArrival ? toSeconds(*m_lastArrival - *m_firstArrival) : 0, m_bytes, m_recording.lostByUs, m_recording.problem};
}

RecordedTimes ViewWriter::takeWritten()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_fresh, {});
}

ViewRecording ViewWriter::finish()
{
    m_thread.join();
    DerivedTimes derived = deriveTimes(m_recording.times); // long; nobody changes them any more
    const std::lock_guard lock(m_mutex);
    m_recording.taken = std::move(derived.taken);
    m_recording.clockSigmaS = derived.sigmaS;
    return std::move(m_recording);
}

} // namespace odo
