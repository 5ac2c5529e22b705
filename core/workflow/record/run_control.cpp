// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/run_control.h"

#include "core/analysis/gate_passages.h"

#include <algorithm>

namespace odo {

namespace {

const Gate *startGateOf(const std::optional<Task> &task)
{
    if (!task)
        return nullptr;
    const auto found = std::ranges::find_if(task->gates, [](const Gate &gate) {
        return gate.role == GateRole::Start || gate.role == GateRole::StartFinish;
    });
    return found == task->gates.end() ? nullptr : &*found;
}

// A passage is found by the track on both sides of the gate, and of an edge or a first motion it is likewise.
constexpr Nanoseconds leastBefore = std::chrono::seconds(1);
constexpr Nanoseconds leastMotion = std::chrono::milliseconds(200);
constexpr Nanoseconds longestPause =
    std::chrono::milliseconds(250); // of what moves; a few frames may be late

bool isStart(const GatePassage &passage)
{
    return passage.role == GateRole::Start || passage.role == GateRole::StartFinish;
}

} // namespace

RunControl::RunControl(Clock clock) : m_clock(std::move(clock)) {}

void RunControl::prepare(const RunSettings &settings, const std::optional<Task> &task, std::size_t robots)
{
    m_settings = settings;
    m_task = task;
    m_gates.assign(robots, LiveGates(task ? task->gates : std::vector<Gate>()));
    m_start = possible(settings.start);
    m_stop = possible(settings.stop);
    if (m_start && m_start->kind == RunTrigger::Kind::Time)
        m_start.reset();
    m_startZones = zonesOf(m_start, robots);
    m_stopZones = zonesOf(m_stop, robots);
}

/// Unless the task lacks what it needs, or nobody is there who could do it.
std::optional<RunTrigger> RunControl::possible(const std::optional<RunTrigger> &trigger) const
{
    if (!trigger)
        return std::nullopt;
    switch (trigger->kind) {
    case RunTrigger::Kind::Gate:
        return !m_gates.empty() && startGateOf(m_task) ? trigger : std::nullopt;
    case RunTrigger::Kind::Entry:
    case RunTrigger::Kind::Exit:
        return zonesOf(trigger, m_gates.size()).empty() ? std::nullopt : trigger;
    case RunTrigger::Kind::Motion:
    case RunTrigger::Kind::Time:
        break;
    }
    return trigger;
}

/// The zone of a trigger, watched for each robot.
std::vector<ZoneWatch> RunControl::zonesOf(const std::optional<RunTrigger> &trigger, std::size_t robots) const
{
    if (!trigger || !m_task || trigger->zone.empty())
        return {};
    const auto zone = std::ranges::find(m_task->zones, trigger->zone, &Zone::name);
    return zone == m_task->zones.end() ? std::vector<ZoneWatch>()
                                       : std::vector<ZoneWatch>(robots, ZoneWatch(*zone));
}

bool RunControl::startsByGate() const
{
    return m_start && m_start->kind == RunTrigger::Kind::Gate;
}

bool RunControl::needsFloorSights() const
{
    const auto byMotion = [](const std::optional<RunTrigger> &trigger) {
        return trigger && trigger->kind == RunTrigger::Kind::Motion;
    };
    return byMotion(m_start) || byMotion(m_stop);
}

/// What was passed before was no start.
void RunControl::forgetWhatWas()
{
    for (LiveGates &gates : m_gates)
        gates.forget();
    for (std::vector<ZoneWatch> *zones : {&m_startZones, &m_stopZones}) {
        for (ZoneWatch &zone : *zones)
            zone.forget();
    }
    m_movesSince.reset();
}

std::string RunControl::startGate() const
{
    const Gate *gate = startsByGate() ? startGateOf(m_task) : nullptr;
    return gate ? gate->name : std::string();
}

Nanoseconds RunControl::countdownLeft() const
{
    const Nanoseconds left = m_since + m_settings.countdown - m_clock();
    return m_phase == RunPhase::CountingDown ? std::max(left, Nanoseconds{0}) : Nanoseconds{0};
}

Nanoseconds RunControl::elapsed() const
{
    return m_phase == RunPhase::Recording ? m_clock() - m_since : Nanoseconds{0};
}

Nanoseconds RunControl::sinceStart() const
{
    return m_phase == RunPhase::Recording ? m_clock() - m_startedAt : Nanoseconds{0};
}

RunOrder RunControl::begin(Nanoseconds at, Nanoseconds before)
{
    m_phase = RunPhase::Recording;
    m_since = at - before;
    m_startedAt = at;
    m_hasMoved = false;
    m_endsAt.reset();
    if (m_stop && m_stop->kind == RunTrigger::Kind::Time)
        m_endsAt = at + m_stop->time;
    return {RunOrder::Kind::Begin, m_since, at};
}

std::optional<RunOrder> RunControl::end()
{
    m_phase = RunPhase::Ready;
    return RunOrder{RunOrder::Kind::End};
}

std::optional<RunOrder> RunControl::press()
{
    switch (m_phase) {
    case RunPhase::Ready:
        m_since = m_clock();
        forgetWhatWas();
        if (m_start) {
            m_phase = RunPhase::Armed;
            return std::nullopt;
        }
        if (m_settings.countdown > Nanoseconds{0}) {
            m_phase = RunPhase::CountingDown;
            return std::nullopt;
        }
        return begin(m_since, m_settings.before);
    case RunPhase::CountingDown:
    case RunPhase::Armed:
        m_phase = RunPhase::Ready;
        return RunOrder{RunOrder::Kind::CallOff};
    case RunPhase::Recording:
        break;
    }
    return end();
}

std::optional<RunOrder> RunControl::tick()
{
    const Nanoseconds now = m_clock();
    if (m_phase == RunPhase::CountingDown && now >= m_since + m_settings.countdown)
        return begin(m_since + m_settings.countdown, Nanoseconds{0});
    if (m_phase == RunPhase::Recording &&
        ((m_endsAt && now >= *m_endsAt) || now - m_since >= m_settings.longest))
        return end();
    return std::nullopt;
}

std::optional<RunOrder> RunControl::robotAt(std::size_t robot, const LivePosition &position)
{
    if ((m_phase != RunPhase::Armed && m_phase != RunPhase::Recording) || robot >= m_gates.size())
        return std::nullopt;
    const auto passed = gatesPassed(robot, position);
    const auto crossed = zonesCrossed(robot, position);
    return passed ? passed : crossed;
}

std::optional<RunOrder> RunControl::gatesPassed(std::size_t robot, const LivePosition &position)
{
    const bool ends = m_stop && m_stop->kind == RunTrigger::Kind::Gate;
    if (!startsByGate() && !ends)
        return std::nullopt;
    const auto passed = m_gates[robot].add(position);
    if (m_phase == RunPhase::Armed && startsByGate()) {
        const auto start = std::ranges::find_if(passed, isStart);
        if (start != passed.end())
            return begin(start->time, std::max(m_settings.before, leastBefore));
    } else if (m_phase == RunPhase::Recording && ends && !passed.empty() && !m_endsAt && allFinished()) {
        m_endsAt = passed.back().time + m_settings.after;
    }
    return std::nullopt;
}

std::optional<RunOrder> RunControl::zonesCrossed(std::size_t robot, const LivePosition &position)
{
    const auto crossing = [&](std::vector<ZoneWatch> &zones,
                              const std::optional<RunTrigger> &trigger) -> std::optional<Nanoseconds> {
        const auto crossed = zones.empty() ? std::nullopt : zones[robot].add(position);
        if (!crossed || crossed->entered != (trigger->kind == RunTrigger::Kind::Entry))
            return std::nullopt;
        return crossed->time;
    };
    const auto starts = crossing(m_startZones, m_start), ends = crossing(m_stopZones, m_stop);
    if (m_phase == RunPhase::Armed && starts)
        return begin(*starts, std::max(m_settings.before, leastBefore));
    if (m_phase == RunPhase::Recording && ends && *ends > m_startedAt && !m_endsAt)
        m_endsAt = *ends + m_settings.after;
    return std::nullopt;
}

std::optional<RunOrder> RunControl::floorAt(const MotionSight &sight)
{
    if (m_phase != RunPhase::Armed && m_phase != RunPhase::Recording)
        return std::nullopt;
    if (sight.time < (m_phase == RunPhase::Armed ? m_since : m_startedAt))
        return std::nullopt; // a frame that was on its way
    if (sight.moves) {
        if (!m_movesSince || sight.time > m_movedLast + longestPause)
            m_movesSince = sight.time;
        m_movedLast = std::max(m_movedLast, sight.time);
    }
    const bool moves = m_movesSince && m_movedLast - *m_movesSince >= leastMotion + FloorMotion::lag;
    if (m_phase == RunPhase::Armed)
        return moves && m_start->kind == RunTrigger::Kind::Motion
                   ? std::optional(begin(*m_movesSince, std::max(m_settings.before, leastBefore)))
                   : std::nullopt;
    m_hasMoved = m_hasMoved || moves;
    const bool ends = m_stop && m_stop->kind == RunTrigger::Kind::Motion && m_hasMoved;
    return ends && sight.time - (m_movedLast - FloorMotion::lag) >= m_stop->time ? end() : std::nullopt;
}

/// Of those that have started.
bool RunControl::allFinished() const
{
    std::size_t started = 0;
    for (const LiveGates &gates : m_gates) {
        const bool hasStarted = std::ranges::any_of(gates.passages(), isStart);
        // A lap that ends begins the next one at a gate that is both.
        std::size_t laps = 0;
        if (hasStarted) {
            ++started;
            laps = lapsOf(gates.passages()).size();
        }
        const bool isLapped = std::ranges::any_of(gates.passages(), [](const GatePassage &passage) {
            return passage.role == GateRole::StartFinish;
        });
        if (hasStarted && laps < static_cast<std::size_t>(isLapped ? std::max(1, m_settings.laps) : 1))
            return false;
    }
    return started > 0;
}

} // namespace odo
