// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/live_track.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// How a run starts and ends.
struct RunSettings
{
    Nanoseconds countdown{0}; ///< from the press to the beginning; 0: at once
    /// A press only arms it: recording begins when a robot passes the task's start, and ends when each robot
    /// that has started has finished. Without effect where the task has no start.
    bool byGates = false;
    int laps = 1; ///< of a task whose start is its finish too
    Nanoseconds before = std::chrono::seconds(
        1); ///< recorded before the press, or before the start is passed; not with a countdown
    Nanoseconds after = std::chrono::seconds(1);    ///< recorded after the finish is passed
    Nanoseconds longest = std::chrono::minutes(30); ///< a run that nobody ends ends by itself
};

enum class RunPhase { Ready, CountingDown, Armed, Recording };

/// What is to be done now.
struct RunOrder
{
    enum class Kind { Begin, End, CallOff } kind = Kind::Begin;
    Nanoseconds from{0}; ///< of Begin: from when on it is recorded, by the clock
    Nanoseconds at{0};   ///< of Begin: the press, the countdown's end, the gate
};

/// Decides when a run is recorded: by a press (a button, a key), after a countdown, or by the robots passing
/// the task's gates. Only decides; whoever asks does it. Not thread-safe.
class RunControl
{
public:
    /// The steady clock of live positions; tests bring their own.
    using Clock = std::function<Nanoseconds()>;
    explicit RunControl(Clock clock);

    /// In Ready only: what comes next, and who drives.
    void prepare(const RunSettings &settings, const std::optional<Task> &task, std::size_t robots);
    /// Begins, arms or counts down; calls off what was armed or counted down; ends a recording.
    std::optional<RunOrder> press();
    /// Ten times a second or more often.
    std::optional<RunOrder> tick();
    std::optional<RunOrder> robotAt(std::size_t robot, const LivePosition &position);
    /// The recording has ended for another reason.
    void hasEnded() { m_phase = RunPhase::Ready; }

    RunPhase phase() const { return m_phase; }
    bool startsByGate() const;
    /// The name of the gate that begins it; empty without one.
    std::string startGate() const;
    Nanoseconds countdownLeft() const; ///< 0 unless counting down
    Nanoseconds elapsed() const;       ///< since the beginning; 0 unless recording

private:
    RunOrder begin(Nanoseconds at, Nanoseconds before);
    std::optional<RunOrder> end();
    bool allFinished() const;

    const Clock m_clock;
    RunSettings m_settings;
    std::optional<Task> m_task;
    std::vector<LiveGates> m_gates; ///< of each robot
    RunPhase m_phase = RunPhase::Ready;
    Nanoseconds m_since{0};              ///< when the phase began; of Recording: from when on it is recorded
    std::optional<Nanoseconds> m_endsAt; ///< all have finished
};

} // namespace odo
