// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/view_writer.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/video/recording_writer.h"
#include "core/video/video_reader.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t mostWaitingBytes = 64 << 20; // 14 s of 1280×720 at 30 frames/s
constexpr Nanoseconds slowFrom = 1s;
constexpr auto checkEach = 1s;
constexpr double rateKnownFromS = 1;
constexpr double megabyte = 1e6;

} // namespace

/// The file as it grows; of the writing thread.
struct ViewWriter::Output
{
    std::unique_ptr<RecordingWriter> writer;
    RawTime last;
    Nanoseconds time{0}; ///< of the last frame, in the file

    /// By the camera's clock; by ours where that was reset.
    Nanoseconds timeOf(const RawTime &next) const
    {
        const Nanoseconds step = next.device - last.device;
        return time + (step > Nanoseconds(0) ? step : std::max(Nanoseconds(0), next.arrival - last.arrival));
    }
};

ViewWriter::ViewWriter(std::filesystem::path file, double nominalFramesPerSecond, DiskWatch disk)
    : m_nominalFramesPerSecond(nominalFramesPerSecond), m_disk(std::move(disk))
{
    m_recording.file = std::move(file);
    auto thread = startThread(recordingName(), [this] { write(); });
    if (thread)
        m_thread = std::move(*thread);
    else
        m_recording.problem = thread.error();
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
    count(frame);
    if (bytesInQueue() + frame.jpeg->size() > mostWaitingBytes) {
        ++m_recording.lostByUs;
        ++m_droppedWhenFull;
        return;
    }
    m_waitingBytes += frame.jpeg->size();
    m_waiting.push_back({std::move(frame), steadyNow()});
    m_wake.notify_all();
}

void ViewWriter::offerKept(std::deque<CodedFrame> frames, std::optional<Nanoseconds> onlyFrom)
{
    const std::lock_guard lock(m_mutex);
    if (m_closed || m_recording.problem)
        return;
    m_recording.keptOnlyFrom = onlyFrom;
    m_begun = steadyNow();
    for (CodedFrame &frame : frames) {
        count(frame);
        m_keptBytes += frame.jpeg->size();
        m_waitingBytes += frame.jpeg->size();
        m_waiting.push_back({std::move(frame), m_begun, true});
    }
    m_wake.notify_all();
}

/// A frame that was delivered, and those that were lost before it; the mutex is held.
void ViewWriter::count(const CodedFrame &frame)
{
    m_recording.frames += 1 + frame.lostBefore;
    m_recording.lostByUs += frame.lostBefore;
    const std::uint64_t sequence = frame.raw.sequence;
    if (m_lastSequence && sequence > *m_lastSequence + 1 + frame.lostBefore)
        m_recording.lostOnWire += sequence - *m_lastSequence - 1 - frame.lostBefore;
    m_lastSequence = sequence;
}

void ViewWriter::countLost(std::uint64_t frames)
{
    const std::lock_guard lock(m_mutex);
    m_recording.frames += frames;
    m_recording.lostByUs += frames;
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

std::optional<ViewWriter::Waiting> ViewWriter::waitForNext()
{
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return m_closed || !m_waiting.empty(); });
    if (m_waiting.empty())
        return std::nullopt;
    Waiting next = std::move(m_waiting.front());
    m_waiting.pop_front();
    // Seconds that were in memory take their time; a disk is slow only for what comes meanwhile.
    next.since = std::max(next.since, m_caughtUp);
    m_writing = next.since;
    return next;
}

void ViewWriter::write()
{
    Output output;
    while (const auto next = waitForNext()) {
        bool isWriting = false;
        const auto written = orShortage([this] { return recordingName(); },
                                        [&]() -> Result<void> {
                                            ODO_TRY(checkDisk(output.writer != nullptr));
                                            isWriting = true;
                                            return write(output, next->frame);
                                        });
        const std::lock_guard lock(m_mutex);
        m_waitingBytes -= next->frame.jpeg->size();
        if (next->isKept) {
            m_keptBytes -= next->frame.jpeg->size();
            m_caughtUp = steadyNow();
        }
        m_writing.reset();
        m_recording.longestWaitS = std::max(m_recording.longestWaitS, toSeconds(steadyNow() - next->since));
        if (!written) {
            m_recording.problem = written.error();
            m_writingFailed = isWriting;
            m_waiting.clear();
            m_waitingBytes = m_keptBytes = 0;
            break;
        }
        note(next->frame);
    }
    if (output.writer) {
        if (const auto finished = output.writer->finish(); !finished) {
            fail(finished.error());
            m_writingFailed = true; // of the last frames, which wait until then
        }
    }
}

Message ViewWriter::recordingName() const
{
    return ODO_TEXT("capture.the_recording", "the recording %1")(Named::file(m_recording.file.filename()));
}

/// Before the disk is full, while there is still space to end in good order. A file that was started can be
/// written to even when its disk was unmounted, but nobody would find it.
Result<void> ViewWriter::checkDisk(bool isBegun)
{
    const auto now = std::chrono::steady_clock::now();
    if (m_spaceChecked && now - *m_spaceChecked < checkEach)
        return {};
    m_spaceChecked = now;
    if (isBegun && !files::exists(m_recording.file))
        return odo::fail(ErrorCode::Io, recordingName(),
                         ODO_TEXT("capture.recording_file_gone", "its file is no longer there"),
                         joined({reconnectDisk(),
                                 ODO_TEXT("capture.recorded_is_there", "it holds what was recorded so far")},
                                Join::Semicolon));
    const std::optional<DiskCapacity> space = m_disk.space(m_recording.file.parent_path());
    if (!space)
        return {};
    const std::uint64_t left = m_disk.left(*space);
    {
        const std::lock_guard lock(m_mutex);
        m_bytesLeft = left;
    }
    if (left > 0)
        return {};
    return odo::fail(
        ErrorCode::Io, recordingName(),
        ODO_TEXT("capture.disk_full", "its disk has only %1 left, of which %2 are kept free")(
            quantity(static_cast<double>(space->free) / megabyte, 0, "MB"),
            quantity(static_cast<double>(m_disk.reserved(*space)) / megabyte, 0)),
        joined({ODO_TEXT("capture.make_room", "free some disk space, or move the project to another disk"),
                ODO_TEXT("capture.recorded_is_kept", "what was recorded so far is kept")},
               Join::Semicolon));
}

Result<void> ViewWriter::write(Output &output, const CodedFrame &frame) const
{
    if (!output.writer) {
        auto writer =
            ODO_TRY(RecordingWriter::create(m_recording.file, frame.format, m_nominalFramesPerSecond));
        output.writer = std::move(writer);
        output.last = frame.raw;
    }
    const Nanoseconds time = output.timeOf(frame.raw);
    ODO_TRY(output.writer->write(*frame.jpeg, time));
    output.last = frame.raw;
    output.time = time;
    return {};
}

/// A frame is in the file; the mutex is held.
void ViewWriter::note(const CodedFrame &frame)
{
    RecordedTimes &times = m_recording.times;
    if (times.frames.empty()) {
        m_recording.format = frame.format;
        m_firstArrival = frame.raw.arrival;
    }
    if (frame.interruption && m_lastArrival)
        m_recording.gaps.push_back(
            {times.frames.size(), frame.raw.arrival - *m_lastArrival, *frame.interruption});
    m_lastArrival = frame.raw.arrival;
    m_bytes += frame.jpeg->size();
    m_recording.latenciesS.push_back(toSeconds(steadyNow() - std::max(frame.taken, m_begun)));
    for (RecordedTimes *kept : {&times, &m_fresh}) {
        kept->frames.push_back(frame.raw);
        if (frame.clock)
            kept->readings.push_back(*frame.clock);
    }
}

/// The mutex is held.
Error ViewWriter::slowDisk(Nanoseconds waited, double fullness) const
{
    const auto advice =
        m_recording.lostByUs == 0
            ? std::vector<Message>{ODO_TEXT("capture.nothing_lost_yet", "nothing is lost yet"),
                                   ODO_TEXT("capture.end_other_writers",
                                            "stop other programs that write to it")}
            : std::vector<Message>{
                  ODO_TEXT("capture.pictures_being_lost", "frames are being lost"),
                  ODO_TEXT("capture.record_elsewhere", "record to another disk, or use fewer cameras")};
    return {ErrorCode::Io,
            ODO_TEXT("capture.disk_of", "the disk of %1")(Named::file(m_recording.file.filename())),
            joined({ODO_TEXT("capture.disk_too_slow", "it is too slow"),
                    ODO_TEXT("capture.picture_waits_for_disk",
                             "a frame has waited %1; the write buffer is %2 full")(
                        quantity(toSeconds(waited), 1, "s"), quantity(100 * fullness, 0, "%"))},
                   Join::Colon),
            joined(advice, Join::Semicolon)};
}

ViewWriter::State ViewWriter::state(Nanoseconds now) const
{
    const std::lock_guard lock(m_mutex);
    State state;
    state.waiting = static_cast<double>(bytesInQueue()) / static_cast<double>(mostWaitingBytes);
    state.recordedS = m_firstArrival ? toSeconds(*m_lastArrival - *m_firstArrival) : 0;
    state.bytes = m_bytes;
    state.droppedWhenFull = m_droppedWhenFull;
    state.problem = m_recording.problem;
    if (m_bytesLeft && state.recordedS >= rateKnownFromS)
        state.secondsLeft =
            static_cast<double>(*m_bytesLeft) / (static_cast<double>(m_bytes) / state.recordedS);
    if (m_writing && now - *m_writing > slowFrom)
        state.slow = RecordingWarning{slowDisk(now - *m_writing, state.waiting), *m_writing};
    return state;
}

RecordedTimes ViewWriter::takeWritten()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_fresh, {});
}

/// What a disk refuses may be the last frames given to it, which it seemed to accept: with what
/// follows them they are what the problem has cost. Nobody changes them any more.
void ViewWriter::leaveOutWhatIsNotInTheFile()
{
    const auto reader = VideoReader::open(m_recording.file);
    std::vector<RawTime> &frames = m_recording.times.frames;
    const std::size_t there = reader ? (*reader)->info().frameTimes.size() : 0;
    if (there >= frames.size())
        return;
    const std::lock_guard lock(m_mutex);
    frames.resize(there);
    m_recording.latenciesS.resize(there);
}

ViewRecording ViewWriter::finish()
{
    if (m_thread.joinable())
        m_thread.join();
    if (m_writingFailed)
        leaveOutWhatIsNotInTheFile();
    DerivedTimes derived = deriveTimes(m_recording.times); // long; nobody changes them any more
    const std::lock_guard lock(m_mutex);
    m_recording.taken = std::move(derived.taken);
    m_recording.clockSigmaS = derived.sigmaS;
    return std::move(m_recording);
}

} // namespace odo
