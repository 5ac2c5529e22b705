// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/aravis/internal/aravis_session.h"
#include "core/capture/aravis/internal/aravis_stream.h"
#include "core/capture/aravis/internal/camera_time_scale.h"

#include <future>

namespace odo {

/// The one thread of a camera that touches Aravis: opens the camera, takes its frames, reads its clock,
/// checks that it is alive, and reconnects with the same settings after a loss.
class AravisWorker
{
public:
    /// opened: called once, with what was found or why it cannot be opened.
    AravisWorker(AravisAddress address, std::shared_ptr<AravisSession> session,
                 std::promise<Result<CameraDescription>> opened);

    /// Until the session is stopped.
    void run();

    // For tasks of the session: on this thread.

    /// Sets it now, and again when the camera comes back.
    Result<void> set(AravisDevice &device, const std::string &id, double value);
    /// Holds them now, and again when the camera comes back; without a camera, when it does. Gives what is
    /// not held.
    std::vector<Message> holdAutomatics(AravisDevice *device);
    /// Gives back what is held, without a camera when it comes back.
    void releaseAutomatics(AravisDevice *device);

private:
    using Opened = Result<std::unique_ptr<AravisDevice>>;

    Opened takeUp();
    Result<AravisLocation> findAgain();
    Result<void> setAsBefore(AravisDevice &device);
    void remember(const std::string &id, double value);
    void takeFrames(AravisDevice &device);
    bool stillStreams(AravisDevice &device, AravisStream &stream);
    void deliver(AravisDevice &device, AravisStream &stream, AravisFrame received);
    void readClockIfDue(AravisDevice &device);
    Nanoseconds fireIfDue(AravisDevice &device);
    std::uint64_t lostHere(const AravisStream &stream, std::uint64_t sequence);
    void updateCounts(const AravisStream &stream);
    void report(Message why, Message advice);

    const AravisAddress m_address;
    const std::shared_ptr<AravisSession> m_session;
    std::promise<Result<CameraDescription>> m_opened;

    std::optional<AravisLocation> m_location; ///< where it was; none before the first time
    AravisMode m_mode;                        ///< as it was then
    bool m_holdWhenBack = false;
    std::vector<std::pair<std::string, double>> m_settings,
        m_automatics; ///< m_automatics: held, with their previous values
    CameraTimeScale m_times;
    FrameNumbering m_numbering;
    std::optional<ClockReading> m_reading; ///< the last one of the camera's own clock
    bool m_readingIsNew = false;
    int m_readings = 0; ///< tried since the camera was connected
    Nanoseconds m_nextReading{0};
    Nanoseconds m_lastFrame{0}; ///< or the start of the stream
    Nanoseconds m_nextFire{0};
    std::optional<Nanoseconds> m_lastTime; ///< of a frame, on the scale
    std::uint64_t m_lastSequence = 0;      ///< of that frame
    std::uint64_t m_unbuffered = 0;        ///< when there was a gap, or the stream began
    bool m_resumed = false;                ///< reconnected, without a frame yet
    int m_unanswered = 0;
    std::uint64_t m_damagedBefore = 0; ///< when the last frame came
    CameraCounts m_before, m_counts;   ///< of former streams; of all
};

} // namespace odo
