// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "core/capture/capture_session.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

namespace odo {

/// A frame waiting for the disk.
struct CodedFrame
{
    std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
    FrameFormat format;
    RawTime raw;
    Nanoseconds taken{0}; ///< as it was known when it arrived
    std::optional<ClockReading> clock;
    std::optional<Error> interruption = {}; ///< what kept the camera from delivering just before
    std::uint64_t lostBefore = 0;           ///< frames in between that could not be taken or coded in time
};

/// Writes one view of a recording on a thread of its own. What waits for the disk is bounded by its bytes;
/// what exceeds that is counted, never waited for.
class ViewWriter
{
public:
    ViewWriter(std::filesystem::path file, double nominalFramesPerSecond, DiskWatch disk);
    ~ViewWriter(); ///< writes what is waiting
    ViewWriter(const ViewWriter &) = delete;
    ViewWriter &operator=(const ViewWriter &) = delete;

    /// The next frame of the camera. Never waits. Any thread, one at a time.
    void offer(CodedFrame frame);
    /// The frames from before the recording began, in order; before any other is offered. They are in memory
    /// already, so their bytes do not count. onlyFrom: ViewRecording::keptOnlyFrom.
    void offerKept(std::deque<CodedFrame> frames, std::optional<Nanoseconds> onlyFrom);
    /// The camera delivered frames that could not be coded in time, and none after them.
    void countLost(std::uint64_t frames);
    /// Something other than the disk ends the recording of this view; what waits is still written.
    void fail(const Error &error);
    /// No more will be offered.
    void close();
    /// Waits until all is on the disk, and returns what was recorded; without pairing. Once, after close().
    ViewRecording finish();

    struct State
    {
        double waiting = 0; ///< how full the queue is, of frames since the recording began
        double recordedS = 0;
        std::uint64_t bytes = 0;              ///< written
        std::uint64_t droppedWhenFull = 0;    ///< frames offered while the queue was too full
        std::optional<double> secondsLeft;    ///< of what this view alone writes
        std::optional<RecordingWarning> slow; ///< the disk does not keep up
        std::optional<Error> problem;
    };
    State state(Nanoseconds now) const; ///< any thread
    /// What was written since the last call. Any thread.
    RecordedTimes takeWritten();

private:
    struct Output;
    struct Waiting
    {
        CodedFrame frame;
        Nanoseconds since;
        bool isKept = false; ///< from before the recording began
    };
    void count(const CodedFrame &frame);
    std::size_t bytesInQueue() const { return m_waitingBytes - m_keptBytes; }
    void write();
    Result<void> write(Output &output, const CodedFrame &frame) const;
    void note(const CodedFrame &frame);
    void leaveOutWhatIsNotInTheFile();
    std::optional<Waiting> waitForNext();
    Result<void> checkDisk(bool isBegun);
    Error slowDisk(Nanoseconds waited, double fullness) const;
    Message recordingName() const;

    const double m_nominalFramesPerSecond;
    const DiskWatch m_disk;
    std::optional<std::chrono::steady_clock::time_point> m_spaceChecked; ///< of the writing thread
    mutable std::mutex m_mutex;                                          ///< guards what follows
    std::condition_variable m_wake;
    std::deque<Waiting> m_waiting;
    std::size_t m_waitingBytes = 0, m_keptBytes = 0; ///< the latter of frames from before it began
    Nanoseconds m_begun{0};                          ///< when those were offered
    Nanoseconds m_caughtUp{0};                       ///< when the last of them was written so far
    bool m_closed = false, m_writingFailed = false;
    std::uint64_t m_bytes = 0, m_droppedWhenFull = 0;
    std::optional<std::uint64_t> m_bytesLeft;
    std::optional<Nanoseconds> m_writing; ///< since when the frame being written has waited
    std::optional<std::uint64_t> m_lastSequence;
    std::optional<Nanoseconds> m_firstArrival, m_lastArrival; ///< of what was written
    RecordedTimes m_fresh;                                    ///< written, and not yet taken
    ViewRecording m_recording;
    std::thread m_thread; ///< last, so that it begins when all is there
};

} // namespace odo
