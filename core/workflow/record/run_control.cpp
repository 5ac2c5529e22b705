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

// The passage is found by the track on both sides of the gate.
constexpr Nanoseconds leastBeforeGate = std::chrono::seconds(1);

} // namespace

RunControl::RunControl(Clock clock) : m_clock(std::move(clock)) {}

void RunControl::prepare(const RunSettings &settings, const std::optional<Task> &task, std::size_t robots)
{
    m_settings = settings;
    m_task = task;
    m_gates.assign(robots, LiveGates(task ? task->gates : std::vector<Gate>()));
}

bool RunControl::startsByGate() const
{
    return m_settings.byGates && !m_gates.empty() && startGateOf(m_task);
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

RunOrder RunControl::begin(Nanoseconds at, Nanoseconds before)
{
    m_phase = RunPhase::Recording;
    m_since = at - before;
    m_endsAt.reset();
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
        if (startsByGate()) {
            for (LiveGates &gates : m_gates)
                gates.forget(); // what was passed before was no start
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
    if (!startsByGate() || (m_phase != RunPhase::Armed && m_phase != RunPhase::Recording) ||
        robot >= m_gates.size())
        return std::nullopt;
    const auto passed = m_gates[robot].add(position);
    if (m_phase == RunPhase::Armed) {
        const auto start = std::ranges::find_if(passed, [](const GatePassage &passage) {
            return passage.role == GateRole::Start || passage.role == GateRole::StartFinish;
        });
        if (start != passed.end())
            return begin(start->time, std::max(m_settings.before, leastBeforeGate));
    } else if (!passed.empty() && !m_endsAt && allFinished()) {
        m_endsAt = passed.back().time + m_settings.after;
    }
    return std::nullopt;
}

/// Of those that have started.
bool RunControl::allFinished() const
{
    std::size_t started = 0;
    for (const LiveGates &gates : m_gates) {
        const bool hasStarted = std::ranges::any_of(gates.passages(), [](const GatePassage &passage) {
            return passage.role == GateRole::Start || passage.role == GateRole::StartFinish;
        });
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
