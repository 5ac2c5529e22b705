// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/view_writer.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/base/steady_now.h"
#include "core/capture/camera_source.h"
#include "core/capture/capture_session.h"
#include "core/video/jpeg.h"
#include "core/video/recording_writer.h"
#include "core/video/video_reader.h"

#include <algorithm>
#include <chrono>
#include <deque>
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
    m_recording.frames += 1 + frame.lostBefore;
    m_recording.lostByUs += frame.lostBefore;
    const std::uint64_t sequence = frame.raw.sequence;
    if (m_lastSequence && sequence > *m_lastSequence + 1 + frame.lostBefore)
        m_recording.lostOnWire += sequence - *m_lastSequence - 1 - frame.lostBefore;
    m_lastSequence = sequence;
    if (m_waitingBytes + frame.jpeg->size() > mostWaitingBytes) {
        ++m_recording.lostByUs;
        ++m_droppedWhenFull;
        return;
    }
    m_waitingBytes += frame.jpeg->size();
    m_waiting.push_back({std::move(frame), steadyNow()});
    m_wake.notify_all();
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
        m_writing.reset();
        m_recording.longestWaitS = std::max(m_recording.longestWaitS, toSeconds(steadyNow() - next->since));
        if (!written) {
            m_recording.problem = written.error();
            m_writingFailed = isWriting;
            m_waiting.clear();
            m_waitingBytes = 0;
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
    m_recording.latenciesS.push_back(toSeconds(steadyNow() - frame.taken));
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
    state.waiting = static_cast<double>(m_waitingBytes) / static_cast<double>(mostWaitingBytes);
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

    /// Of what is kept; 0 where that is too little to know.
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
        else if (coding.writer || m_preRoll > Nanoseconds(0))
            code(coding, std::get<UncodedFrame>(*work));
    }
}

void ViewCoder::code(Coding &coding, const UncodedFrame &uncoded)
{
    auto coded =
        orShortage([this] { return ODO_TEXT("capture.picture_of_camera", "a frame of camera %1")(m_uri); },
                   [&] { return coding.code(uncoded); });
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
