// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <variant>

namespace odo::test {

/// What a played camera is to do; the test goes on writing it while the camera plays. Any thread.
class Script
{
public:
    struct Loss
    {
        int frames;
        bool here = false; ///< by this program, which did not take them in time
    };
    struct Hang
    {
    };
    struct Picture
    {
    };
    struct Pace
    {
        std::chrono::nanoseconds interval;
    };
    struct Pass
    {
        std::chrono::nanoseconds time;
    };
    using Step = std::variant<Picture, Loss, Pace, Pass, Error, Hang>;

    void frames(int count)
    {
        for (int i = 0; i < count; ++i)
            add(Picture{});
    }
    /// Pictures that the camera takes and that never arrive.
    void lose(int count) { add(Loss{count}); }
    /// Pictures that arrive, and that the source throws away.
    void loseHere(int count) { add(Loss{count, true}); }
    /// From now on its pictures are so far apart.
    void pace(std::chrono::nanoseconds interval) { add(Pace{interval}); }
    /// Time in which it takes no picture.
    void pass(std::chrono::nanoseconds time) { add(Pass{time}); }
    void error(const Error &error) { add(error); }
    /// next() does not return, not even when it is stopped, until the script is given up.
    void hang() { add(Hang{}); }
    void giveUp()
    {
        const std::lock_guard lock(m_mutex);
        m_givenUp = true;
        m_wake.notify_all();
    }
    void stop()
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
        m_wake.notify_all();
    }
    std::atomic<bool> held = false;     ///< the camera's automatics
    std::atomic<int> robotsToShow = -1; ///< as many were given last; -1: none ever were

    /// nullopt once stopped.
    std::optional<Step> next()
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait(lock, [this] { return m_stopped || !m_steps.empty(); });
        if (m_stopped)
            return std::nullopt;
        Step step = m_steps.front();
        m_steps.pop_front();
        if (std::holds_alternative<Hang>(step))
            m_wake.wait(lock, [this] { return m_givenUp; });
        return step;
    }

private:
    void add(Step step)
    {
        const std::lock_guard lock(m_mutex);
        m_steps.push_back(std::move(step));
        m_wake.notify_all();
    }
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Step> m_steps;
    bool m_stopped = false, m_givenUp = false;
};

/// A camera that does what its script says, as soon as it says so; its pictures are 33 ms apart by its own
/// clock and arrive, as it claims, when they were taken.
class PlayedCamera : public CameraSource
{
public:
    struct Kind
    {
        Nanoseconds beginning{0};  ///< when, by this machine's steady clock, it takes its first picture
        Nanoseconds clockStart{0}; ///< when, after that, its own clock began
        Nanoseconds phase{0};      ///< how much later than others it takes its pictures
        bool codes = false;        ///< gives JPEG files (which are none, but words)
        std::vector<Message> notHeld = {};
        FrameFormat format = FrameFormat{160, 96};
        std::size_t jpegBytes = 0; ///< its JPEG files are that large; they share their bytes
    };
    PlayedCamera(std::shared_ptr<Script> script, Kind kind)
        : m_script(std::move(script)), m_kind(std::move(kind))
    {
    }

    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_script->stop(); }
    std::vector<Message> holdAutomatics() override
    {
        m_script->held = true;
        return m_kind.notHeld;
    }
    void releaseAutomatics() override { m_script->held = false; }
    void showRobots(const std::vector<RobotAppearance> &robots) override
    {
        m_script->robotsToShow = int(robots.size());
    }
    Result<CapturedFrame> next() override
    {
        for (;;) {
            const auto step = m_script->next();
            if (!step || std::holds_alternative<Script::Hang>(*step))
                return cancelled(foreignWords("played camera"));
            if (const Error *error = std::get_if<Error>(&*step))
                return tl::unexpected(*error);
            if (const auto *loss = std::get_if<Script::Loss>(&*step)) {
                m_sequence += loss->frames;
                m_time += loss->frames * m_interval;
                m_lostHere += loss->here ? std::uint64_t(loss->frames) : 0;
            } else if (const auto *pace = std::get_if<Script::Pace>(&*step))
                m_interval = pace->interval;
            else if (const auto *pass = std::get_if<Script::Pass>(&*step))
                m_time += pass->time;
            else
                return image();
        }
    }

    static constexpr Nanoseconds interval = std::chrono::milliseconds(33);

private:
    CapturedFrame image()
    {
        const Nanoseconds time = std::exchange(m_time, m_time + m_interval) + m_kind.phase;
        CapturedFrame captured;
        captured.frame = FrameBuffer::toFrame(std::make_shared<FrameBuffer>(m_kind.format), m_sequence,
                                              time - m_kind.clockStart);
        captured.sequence = std::uint64_t(m_sequence++);
        captured.lostHere = std::exchange(m_lostHere, 0);
        captured.hostTime = m_kind.beginning + time;
        if (m_kind.jpegBytes > 0) {
            if (!m_large)
                m_large = std::make_shared<const std::vector<std::uint8_t>>(m_kind.jpegBytes);
            captured.jpeg = m_large;
        } else if (m_kind.codes) {
            const std::string bytes = "\xff\xd8picture " + std::to_string(captured.sequence) + " as it came";
            captured.jpeg = std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
        }
        return captured;
    }

    const std::shared_ptr<Script> m_script;
    const Kind m_kind;
    const CameraDescription m_description{"play:", "played", foreignWords("Played"), 160, 96, 30};
    int m_sequence = 0;
    Nanoseconds m_time{0}, m_interval = interval;
    std::uint64_t m_lostHere = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> m_large;
};

} // namespace odo::test
