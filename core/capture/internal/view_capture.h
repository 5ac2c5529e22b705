// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/capture_health.h"
#include "core/capture/internal/view_coder.h"
#include "core/capture/synchroniser.h"

#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace odo {

/// One camera of a session: takes its frames on one thread, has them coded and written on another, gives
/// them to subscribers, and knows the camera's health. Its threads keep it alive.
class ViewCapture : public std::enable_shared_from_this<ViewCapture>
{
public:
    ViewCapture(std::unique_ptr<CameraSource> camera, std::size_t view, KeptFrames kept,
                std::shared_ptr<FramePairing> pairing);
    ~ViewCapture();
    ViewCapture(const ViewCapture &) = delete;
    ViewCapture &operator=(const ViewCapture &) = delete;

    void start();
    /// Takes no more frames, and gives the camera's automatics back, where they are held. Any thread.
    void stop();
    /// Waits, after stop(), for the threads to end; leaves the camera's to itself when it does not by then.
    void join(std::chrono::steady_clock::time_point deadline);

    const CameraDescription &description() const { return m_camera->description(); }
    Result<std::vector<CameraControl>> controls() { return m_camera->controls(); }
    void showRobots(const std::vector<RobotAppearance> &robots) { m_camera->showRobots(robots); }
    std::shared_ptr<BoundedQueue<TimedFrame>> subscribe(std::size_t capacity);
    ViewHealth health(Nanoseconds now) const;
    /// Bytes per second of its frames on the disk at present; 0 while that is not known.
    double bytesPerSecond() const { return m_coder.bytesPerSecond(); }
    /// Why nothing more will come; nullopt while something may.
    std::optional<Error> end() const;

    /// How long frames are kept from now on while nothing is written.
    void keepFor(Nanoseconds length) { m_coder.keepFor(length); }
    /// From now on all goes to the writer, beginning with what arrived no longer ago.
    void startWriting(std::shared_ptr<ViewWriter> writer, Nanoseconds preRoll);
    /// When what has arrived by now was handed to the writer and it was closed.
    std::future<void> stopWriting();

private:
    struct Pace
    {
        std::uint64_t sequence;
        Nanoseconds time; ///< by the camera's clock
    };
    struct Recent
    {
        Nanoseconds arrival;
        double latencyS;
    };

    void cannotRun(Error error);
    void takeFrames();
    void take(CapturedFrame captured);
    void interrupted(const Error &error);
    void settleAutomatics();
    void noteSleep(const CapturedFrame &captured);
    Nanoseconds note(const CapturedFrame &captured, Nanoseconds now);
    std::optional<RecordingWarning> slowness(const CapturedFrame &captured, Nanoseconds now);
    void giveOut(const TimedFrame &timed);
    std::optional<RecordingWarning> silence(Nanoseconds now) const;

    const std::unique_ptr<CameraSource> m_camera;
    const std::size_t m_view;
    const std::shared_ptr<FramePairing> m_pairing;
    ViewCoder m_coder;
    std::thread m_taker;
    std::future<void> m_takerEnded;

    mutable std::mutex m_mutex; ///< guards what follows
    ClockMap m_clock;
    ViewHealth m_health; ///< all but what is recounted each time
    std::optional<std::uint64_t> m_lastSequence;
    std::deque<Recent> m_recent;   ///< of the last two seconds
    std::deque<Pace> m_pace;       ///< of its last two seconds, unless it was interrupted since
    Nanoseconds m_slept;           ///< this machine, when the last frame was taken from the camera
    Nanoseconds m_sleep{0};        ///< since the last frame, as far as is known
    std::optional<RawTime> m_last; ///< of the last frame
    Nanoseconds m_begun{0}, m_lastArrival{0};
    std::optional<Error> m_interruption;       ///< since the last frame
    std::uint64_t m_lostBefore = 0;            ///< by us, since the last one that found room
    bool m_holdWanted = false, m_held = false; ///< of the automatics
    std::vector<std::shared_ptr<BoundedQueue<TimedFrame>>> m_feeds;
};

} // namespace odo
