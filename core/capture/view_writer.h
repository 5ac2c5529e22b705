// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/recording_outcome.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

namespace odo {

/// A picture on its way to the disk.
struct CodedFrame
{
    std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
    FrameFormat format;
    RawTime raw;
    Nanoseconds taken{0}; ///< as it was known when it arrived
    std::optional<ClockReading> clock;
    std::optional<Error> interruption = {}; ///< what kept the camera from delivering just before
    std::uint64_t lostBefore = 0;           ///< pictures that the camera delivered in between, and that could not be coded in time
};

/// Writes one view of a recording on a thread of its own. What waits for the disk is bounded by its bytes; what finds no room is
/// counted, never waited for.
class ViewWriter
{
public:
    ViewWriter(std::filesystem::path file, double nominalFramesPerSecond);
    ~ViewWriter(); ///< writes what is waiting
    ViewWriter(const ViewWriter &) = delete;
    ViewWriter &operator=(const ViewWriter &) = delete;

    /// The next picture of the camera. Never waits. Any thread, one at a time.
    void offer(CodedFrame frame);
    /// The camera delivered pictures that could not be coded in time, and none after them.
    void countLost(std::uint64_t pictures);
    /// Something other than the disk ends the recording of this view; what waits is still written.
    void fail(const Error &error);
    /// No more will be offered.
    void close();
    /// Waits until all is on the disk, and tells what there is; without pairing. Once, after close().
    ViewRecording finish();

    struct State
    {
        double waiting = 0;       ///< how full the queue is
        double recordedS = 0;
        std::uint64_t bytes = 0;  ///< written
        std::uint64_t lost = 0;
        std::optional<Error> problem;
    };
    State state() const; ///< any thread
    /// What was written since the last call. Any thread.
    RecordedTimes takeWritten();

private:
    struct Output;
    void write();
    Result<void> write(Output &output, const CodedFrame &frame);
    void note(const CodedFrame &frame);
    std::optional<CodedFrame> waitForNext();

    const double m_nominalFramesPerSecond;
    mutable std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_wake;
    std::deque<CodedFrame> m_waiting;
    std::size_t m_waitingBytes = 0;
    bool m_closed = false;
    std::uint64_t m_bytes = 0;
    std::optional<std::uint64_t> m_lastSequence;
    std::optional<Nanoseconds> m_firstArrival, m_lastArrival; ///< of what was written
    RecordedTimes m_fresh; ///< written, and not yet taken
    ViewRecording m_recording;
    std::thread m_thread; ///< last, so that it begins when all is there
};

} // namespace odo
