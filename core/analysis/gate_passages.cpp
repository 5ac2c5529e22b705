// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/gate_passages.h"

#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double sigmasToPass = sureSigmas;
constexpr double leastDistanceM = 0.0005;

/// One meeting of the track with the gate's line.
struct Meeting
{
    std::size_t after = 0; ///< index of the position before it
    double timeS = 0, alongM = 0, rateMps = 0;
    double ownM = 0, commonM = 0; ///< σ across the gate
};

class GateWatch
{
public:
    GateWatch(const Gate &gate, const std::vector<MeasuredPosition> &positions)
        : m_gate(gate), m_positions(positions), m_along((gate.to - gate.from).normalized()),
          m_across(m_along.y(), -m_along.x()), m_lengthM((gate.to - gate.from).norm())
    {
    }

    std::vector<GatePassage> passages() const
    {
        std::vector<GatePassage> found;
        const std::size_t nowhere = m_positions.size();
        std::size_t before = nowhere; // the last position that was surely before the line
        for (std::size_t i = 0; i < m_positions.size(); ++i) {
            if (!m_positions[i].joined)
                before = nowhere;
            const double distance = across(i);
            const double sure =
                std::max(leastDistanceM, sigmasToPass * sigmaAlong(m_positions[i].own, m_across));
            if (distance < -sure) {
                before = i;
            } else if (distance > sure && before != nowhere) {
                if (auto passage = passageBetween(before, i))
                    found.push_back(std::move(*passage));
                before = nowhere;
            }
        }
        return found;
    }

private:
    double across(std::size_t i) const { return m_across.dot(m_positions[i].point->position - m_gate.from); }

    /// The distance from the line between a position and the next, with `more` added.
    CubicStep distanceAfter(std::size_t i, double more = 0) const
    {
        const MeasuredPosition &a = m_positions[i], &b = m_positions[i + 1];
        return {across(i) + more, across(i + 1) + more, m_across.dot(a.point->velocity),
                m_across.dot(b.point->velocity), b.timeS - a.timeS};
    }

    /// The moment when a track shifted forward by `more` meets the line: searched from a position, one step
    /// back or forth at a time, as far as the track has no gap. Where its σ grows that may be its end.
    double momentFrom(std::size_t i, int step, double more) const
    {
        while ((across(i) + more > 0) == (across(i + 1) + more > 0)) {
            if (step < 0 && (i == 0 || !m_positions[i].joined))
                return m_positions[i].timeS;
            if (step > 0 && (i + 2 >= m_positions.size() || !m_positions[i + 2].joined))
                return m_positions[i + 1].timeS;
            i = step < 0 ? i - 1 : i + 1;
        }
        return m_positions[i].timeS +
               distanceAfter(i, more).root() * (m_positions[i + 1].timeS - m_positions[i].timeS);
    }

    Meeting meetingAfter(std::size_t i) const
    {
        const MeasuredPosition &a = m_positions[i], &b = m_positions[i + 1];
        const double step = b.timeS - a.timeS;
        const CubicStep distance = distanceAfter(i);
        const CubicStep along{m_along.dot(a.point->position - m_gate.from),
                              m_along.dot(b.point->position - m_gate.from), m_along.dot(a.point->velocity),
                              m_along.dot(b.point->velocity), step};
        const double part = distance.root();
        return {i,
                a.timeS + part * step,
                along.value(part),
                distance.rate(part),
                sigmaAlong((1 - part) * a.own + part * b.own, m_across),
                sigmaAlong((1 - part) * a.common + part * b.common, m_across)};
    }

    std::optional<GatePassage> passageBetween(std::size_t before, std::size_t past) const
    {
        std::vector<Meeting> meetings;
        for (std::size_t i = before; i < past; ++i) {
            if ((across(i) > 0) != (across(i + 1) > 0))
                meetings.push_back(meetingAfter(i));
        }
        const Meeting &first = meetings.front(), &last = meetings.back();
        const double alongM = (first.alongM + last.alongM) / 2;
        if (alongM < 0 || alongM > m_lengthM)
            return std::nullopt;
        // From where the track would pass if it lay by σ further on, to where if by σ less far. By two and
        // three σ, too: a robot that stops a little behind the line may have stopped before it.
        const double ownM = std::max(first.ownM, last.ownM);
        double ownS = 0;
        for (const double sigmas : {1, 2, 3})
            ownS = std::max(ownS, (momentFrom(last.after, 1, -sigmas * ownM) -
                                   momentFrom(first.after, -1, sigmas * ownM)) /
                                      (2 * sigmas));
        const double withinS = m_positions[past].timeS - m_positions[before].timeS;
        const double commonS = first.rateMps * withinS > first.commonM ? first.commonM / first.rateMps
                               : first.commonM > 0                     ? withinS
                                                                       : 0;
        return GatePassage{m_gate.name, m_gate.role, fromSeconds((first.timeS + last.timeS) / 2),
                           std::hypot(ownS, commonS), commonS};
    }

    const Gate &m_gate;
    const std::vector<MeasuredPosition> &m_positions;
    Eigen::Vector2d m_along, m_across; ///< across: the way the gate is passed
    double m_lengthM;
};

double sigmaBetween(const GatePassage &from, const GatePassage &to)
{
    const auto ownSquared = [](const GatePassage &passage) {
        return std::max(0.0, std::pow(passage.sigmaS, 2) - std::pow(passage.commonSigmaS, 2));
    };
    const double common = from.gate == to.gate ? from.commonSigmaS - to.commonSigmaS
                                               : std::hypot(from.commonSigmaS, to.commonSigmaS);
    return std::sqrt(ownSquared(from) + ownSquared(to) + common * common);
}

Lap lapOf(const std::vector<const GatePassage *> &way)
{
    Lap lap;
    lap.start = way.front()->time;
    lap.timeS = toSeconds(way.back()->time - way.front()->time);
    lap.sigmaS = sigmaBetween(*way.front(), *way.back());
    for (std::size_t i = 1; i < way.size(); ++i)
        lap.sectors.push_back(
            {way[i]->gate, toSeconds(way[i]->time - way[i - 1]->time), sigmaBetween(*way[i - 1], *way[i])});
    return lap;
}

} // namespace

std::vector<GatePassage> findPassages(const std::vector<Gate> &gates, const std::vector<Sample> &samples,
                                      const std::vector<ProfilePoint> &points)
{
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    std::vector<GatePassage> all;
    for (const Gate &gate : gates) {
        for (GatePassage &passage : GateWatch(gate, positions).passages())
            all.push_back(std::move(passage));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const GatePassage &a, const GatePassage &b) { return a.time < b.time; });
    return all;
}

std::vector<Lap> lapsOf(const std::vector<GatePassage> &passages)
{
    std::vector<Lap> laps;
    std::vector<const GatePassage *> way; // of the current run
    for (const GatePassage &passage : passages) {
        const bool ends = passage.role == GateRole::Finish || passage.role == GateRole::StartFinish;
        const bool begins = passage.role == GateRole::Start || passage.role == GateRole::StartFinish;
        if (ends && !way.empty()) {
            way.push_back(&passage);
            laps.push_back(lapOf(way));
            way.clear();
        }
        const bool isKnown = std::any_of(
            way.begin(), way.end(), [&](const GatePassage *passed) { return passed->gate == passage.gate; });
        if ((begins && way.empty()) || (passage.role == GateRole::Split && !way.empty() && !isKnown))
            way.push_back(&passage);
    }
    return laps;
}

} // namespace odo
