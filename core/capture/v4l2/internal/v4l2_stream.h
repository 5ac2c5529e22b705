// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/v4l2/internal/v4l2_mode.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct v4l2_pix_format;

namespace odo {

/// What a driver says of a buffer.
struct V4l2BufferStamp
{
    std::uint32_t sequence = 0; ///< wraps
    std::uint64_t time = 0;     ///< nanoseconds; wraps
    bool isMonotonic = false;   ///< of this machine's steady clock (steadyNow()), so the driver says
};

/// Makes of drivers' counts and times what CapturedFrame has: counts that rise and times that go on, whatever
/// wraps, repeats, jumps or restarts. Not thread-safe.
class V4l2Stamps
{
public:
    struct Stamp
    {
        std::uint64_t sequence = 0;
        Nanoseconds time{0};
        std::optional<ClockReading> clock; ///< where the driver's times are this machine's
    };
    /// Of every buffer, damaged ones too. arrival: by the steady clock.
    Stamp next(const V4l2BufferStamp &buffer, Nanoseconds arrival);
    /// The stream restarts: what would have come meanwhile counts as lost.
    void restart(double framesPerSecond);

private:
    void count(std::uint32_t sequence, Nanoseconds arrival);
    void advance(std::uint64_t time, Nanoseconds arrival);

    bool m_first = true;
    double m_lostRate = 0; ///< frames a second that were lost until now; 0: the stream has gone on
    std::uint32_t m_lastSequence = 0;
    std::uint64_t m_lastTime = 0, m_repeated = 0;
    Nanoseconds m_lastArrival{0};
    Stamp m_stamp;
    bool m_isTrusted = true; ///< no time was in the future or jumped
};

/// A camera that delivers into buffers that are shared with its driver; a third of a second of them, so that
/// who takes the frames may be late. Stops with its end. One thread.
class V4l2Stream
{
public:
    struct Buffer
    {
        unsigned index = 0;
        std::span<const std::uint8_t> bytes; ///< until giveBack()
        V4l2BufferStamp stamp;
        bool isDamaged = false; ///< by the driver's own word
    };

    /// Sets the mode and starts. Errors: those of v4l2Failure, EBUSY and ENOSPC above all; Unavailable when
    /// the camera takes another format.
    static Result<std::unique_ptr<V4l2Stream>> start(std::shared_ptr<V4l2Device> device, const V4l2Mode &mode,
                                                     const std::string &uri);
    ~V4l2Stream();
    V4l2Stream(const V4l2Stream &) = delete;
    V4l2Stream &operator=(const V4l2Stream &) = delete;

    const v4l2_pix_format &format() const { return *m_format; }
    int descriptor() const { return m_device->descriptor(); }
    double framesPerSecond() const { return m_framesPerSecond; } ///< as the driver has set it
    /// The oldest full buffer, or the errno: EAGAIN where none is full, ENODEV unplugged, EIO the stream has
    /// broken.
    int take(Buffer &taken);
    /// 0 or the errno.
    int giveBack(unsigned index);

private:
    V4l2Stream(std::shared_ptr<V4l2Device> device);
    int setMode(const V4l2Mode &mode);
    int makeBuffers();

    const std::shared_ptr<V4l2Device> m_device;
    std::unique_ptr<v4l2_pix_format> m_format;
    double m_framesPerSecond = 0;
    std::vector<std::span<std::uint8_t>> m_buffers; ///< mapped
};

/// What a source waits for: a frame, a camera that is plugged in (a change in /dev; where that cannot be
/// watched, the end of the wait stands for it), or being stopped.
class V4l2Watch
{
public:
    V4l2Watch();
    ~V4l2Watch();
    V4l2Watch(const V4l2Watch &) = delete;
    V4l2Watch &operator=(const V4l2Watch &) = delete;

    /// Waits until the camera has something to say; below 0: until nodes change. False when the camera says
    /// that it is broken.
    bool wait(int camera, std::chrono::steady_clock::time_point until);
    /// For good. Any thread.
    void stop();
    bool isStopped() const { return m_stopped; }

private:
    void forgetChanges() const;

    int m_wake = -1, m_nodes = -1;
    std::atomic<bool> m_stopped = false;
};

} // namespace odo
