// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/live_track.h"
#include "core/workflow/record/floor_motion.h"
#include "core/workflow/record/internal/zone_watch.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What starts or ends a run by itself.
struct RunTrigger
{
    enum class Kind {
        Gate,   ///< a robot passes the task's start; or each that has started has finished
        Motion, ///< something moves on the floor for 0.2 s; or it moved, and nothing does for `time`
        Entry,  ///< a robot enters the zone
        Exit,   ///< a robot leaves the zone
        Time    ///< so long after the start; ends only
    } kind = Kind::Gate;
    std::string zone = {}; ///< its name in the task
    Nanoseconds time{0};
    bool operator==(const RunTrigger &) const = default;
};
constexpr Nanoseconds usualRest = std::chrono::milliseconds(1500); ///< of Motion

/// How a run starts and ends.
struct RunSettings
{
    Nanoseconds countdown{0}; ///< from the press to the beginning; 0: at once
    /// A press only arms it: recording begins with this. One that the task does not have (a start, the zone)
    /// has no effect.
    std::optional<RunTrigger> start = {};
    /// It ends with this, or a press before that. Without effect likewise.
    std::optional<RunTrigger> stop = {};
    int laps = 1; ///< of a task whose start is its finish too
    /// recorded before the press; before a start by itself, but a second at least; not with a countdown
    Nanoseconds before = std::chrono::seconds(1);
    Nanoseconds after = std::chrono::seconds(1); ///< recorded after the finish, or the zone's edge, is passed
    Nanoseconds longest = std::chrono::minutes(30); ///< a run that nobody ends ends by itself
};

enum class RunPhase { Ready, CountingDown, Armed, Recording };

/// What is to be done now.
struct RunOrder
{
    enum class Kind { Begin, End, CallOff } kind = Kind::Begin;
    Nanoseconds from{0}; ///< of Begin: from when on it is recorded, by the clock
    Nanoseconds at{0};   ///< of Begin: the press, the countdown's end, the gate, the first motion
};

/// Decides when a run is recorded: by a press (a button, a key), after a countdown, by the robots passing
/// the task's gates or the edge of a zone, by motion on the floor, or after a time. Only decides; whoever
/// asks does it. Not thread-safe.
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
    /// What each camera sees of the floor, in about the order of time; only for Motion.
    std::optional<RunOrder> floorAt(const MotionSight &sight);
    /// The recording has ended for another reason.
    void hasEnded() { m_phase = RunPhase::Ready; }

    RunPhase phase() const { return m_phase; }
    bool startsByGate() const;
    /// The name of the gate that begins it; empty without one.
    std::string startGate() const;
    /// What begins or ends it by itself; nullptr: a press alone does.
    const RunTrigger *start() const { return m_start ? &*m_start : nullptr; }
    const RunTrigger *stop() const { return m_stop ? &*m_stop : nullptr; }
    bool needsFloorSights() const;
    Nanoseconds countdownLeft() const; ///< 0 unless counting down
    Nanoseconds elapsed() const;       ///< since the beginning; 0 unless recording
    Nanoseconds sinceStart() const;    ///< likewise, since what started it

private:
    RunOrder begin(Nanoseconds at, Nanoseconds before);
    std::optional<RunOrder> end();
    std::optional<RunTrigger> possible(const std::optional<RunTrigger> &trigger) const;
    std::vector<ZoneWatch> zonesOf(const std::optional<RunTrigger> &trigger, std::size_t robots) const;
    void forgetWhatWas();
    std::optional<RunOrder> gatesPassed(std::size_t robot, const LivePosition &position);
    std::optional<RunOrder> zonesCrossed(std::size_t robot, const LivePosition &position);
    bool allFinished() const;

    const Clock m_clock;
    RunSettings m_settings;
    std::optional<Task> m_task;
    std::optional<RunTrigger> m_start, m_stop;        ///< those of the settings that the task has
    std::vector<LiveGates> m_gates;                   ///< of each robot
    std::vector<ZoneWatch> m_startZones, m_stopZones; ///< of each robot; empty: none is watched
    std::optional<Nanoseconds> m_movesSince;          ///< without a pause
    Nanoseconds m_movedLast{0};                       ///< seen so
    bool m_hasMoved = false;                          ///< for long enough, since the start
    RunPhase m_phase = RunPhase::Ready;
    Nanoseconds m_since{0};              ///< when the phase began; of Recording: from when on it is recorded
    Nanoseconds m_startedAt{0};          ///< of Recording
    std::optional<Nanoseconds> m_endsAt; ///< all have finished, or the zone's edge was passed
};

} // namespace odo
