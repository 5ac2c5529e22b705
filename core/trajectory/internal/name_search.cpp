// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/name_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t mostNameHypotheses = 256;
constexpr double hopelessCost = 60.0; ///< behind the best hypothesis
/// A moment's disagreement on the floor: capped against false sightings; and neighbouring moments are not
/// independent of one another.
constexpr double mostFloorCost = 6.0, floorWeight = 0.2;
constexpr double hueSigmaRad = 0.09, mostHueCost = 12.0;
constexpr double leastLookSigma = 3.0, relativeLookSigma = 0.05, mostLookCost = 10.0;
/// a long robot looks smaller from its front than from its side
constexpr double sizeAsideLn = 0.25, sizeSigmaLn = 0.2, mostSizeCost = 10.0;
/// of a name that a view has not seen yet: mostly a robot that was lost comes back
constexpr double costOfBeginning = 6.0;
constexpr double costOfRenaming = 0.05; ///< the tracker's own choice is as good if nothing else decides

constexpr double costOfNoRobotPerS = 4.0; ///< of something that is as likely a robot as can be, and is none

constexpr double costOfContradicting = 1000.0; ///< what a person has said

constexpr double costOfUncertainty =
    3.0; ///< by which one way is surely better than another: of e^3 = 20 to 1

constexpr int none = -1;

/// One way to have named everything up to now.
struct NameHypothesis
{
    std::vector<int> last; ///< for each view and name its last tracklet
    double cost = 0;
    int decision = none; ///< the last one, in the search's list
};

struct NameDecision
{
    int before = none;
    std::size_t tracklet = 0, name = 0;
    /// other ways that came to the same: by how much they cost more, and their decision
    std::vector<std::pair<double, int>> nearlyAsGood;
};

/// What two views' tracklets cost by the positions they show: as one robot they should be at one position, as
/// two they cannot.
struct CostOfTwo
{
    double ofOneName = 0, ofTwoNames = 0;
};

class NamesSearch
{
public:
    NamesSearch(const NameEvidence &evidence, std::size_t views, const NameKnowledge &knowledge)
        : m_evidence(evidence), m_knowledge(knowledge), m_views(views), m_robots(evidence.givenHueRad.size()),
          m_apart(evidence.tracklets.size())
    {
        if (knowledge.viewsAgree)
            for (const FloorMoment &moment : evidence.moments)
                addApart(moment);
        m_hypotheses.push_back({std::vector<int>(m_views * m_robots, none), 0, none});
    }

    FoundNames run()
    {
        for (std::size_t t = 0; t < m_evidence.tracklets.size(); ++t)
            decide(t);
        FoundNames found;
        const NameHypothesis &best = m_hypotheses.front(); // they are in order
        found.names = namesOf(best.decision);
        const Links links = linksOf(found.names, best.decision);
        for (const NameHypothesis &other : m_hypotheses)
            addAmbiguities(best.cost, other.cost, other.decision, links, found);
        for (int d = best.decision; d != none; d = decisionOf(d).before)
            for (const auto &[cost, decision] : decisionOf(d).nearlyAsGood)
                addAmbiguities(0, cost, decision, links, found);
        return found;
    }

private:
    std::size_t positionOf(std::size_t view, std::size_t name) const { return view * m_robots + name; }
    const TrackletOf &trackletOf(int number) const
    {
        return m_evidence.tracklets[static_cast<std::size_t>(number)];
    }
    int lastOf(const NameHypothesis &hypothesis, std::size_t view, std::size_t name) const
    {
        return hypothesis.last[positionOf(view, name)];
    }

    /// Of two sizes that should be one thing's. Of a given colour a part may be seen.
    double costOfSizes(double oneM, double otherM) const
    {
        if (!(oneM > 0) || !(otherM > 0) || !ofAnyLook())
            return 0;
        const double off = std::max(0.0, std::abs(std::log(oneM / otherM)) - sizeAsideLn) / sizeSigmaLn;
        return std::min(mostSizeCost, 0.5 * off * off);
    }

    bool ofAnyLook() const
    {
        return std::ranges::none_of(m_evidence.givenHueRad, &std::optional<double>::has_value);
    }

    /// What a moment adds to the costs of two views' tracklets.
    void addApart(const FloorMoment &moment)
    {
        forEachTwo(moment, [&](const FloorSight &one, const FloorSight &other) {
            const Eigen::Vector2d apart = one.at(m_knowledge.planeM) - other.at(m_knowledge.planeM);
            const double cost =
                0.5 * apart.squaredNorm() / (m_knowledge.floorSigmaM * m_knowledge.floorSigmaM) +
                costOfSizes(one.sizeM, other.sizeM);
            const auto &[earlier, later] = std::minmax(*one.tracklet, *other.tracklet);
            CostOfTwo &both = m_apart[later][earlier];
            both.ofOneName += floorWeight * std::min(mostFloorCost, cost);
            both.ofTwoNames += floorWeight * mostFloorCost * std::exp(-cost);
        });
    }

    /// Of a tracklet that runs still.
    std::size_t nameOf(const NameHypothesis &hypothesis, std::size_t t) const
    {
        std::size_t name = 0;
        while (name < m_robots &&
               lastOf(hypothesis, m_evidence.tracklets[t].view, name) != static_cast<int>(t))
            ++name;
        return name;
    }

    /// How far a tracklet lies from those of other views that have the name, and how near to those that have
    /// another, for as long as both are seen.
    double costOfApart(const NameHypothesis &hypothesis, std::size_t t, std::size_t name) const
    {
        double cost = 0;
        for (const auto &[earlier, both] : m_apart[t])
            if (const std::size_t its = nameOf(hypothesis, earlier); its < m_robots)
                cost += its == name ? both.ofOneName : both.ofTwoNames;
        return cost;
    }

    double costOf(const NameHypothesis &hypothesis, std::size_t t, std::size_t name) const
    {
        const TrackletOf &begun = m_evidence.tracklets[t];
        double cost = colourCost(begun, name) + costOfApart(hypothesis, t, name);
        const int last = lastOf(hypothesis, begun.view, name);
        if (last != none)
            cost += costOfJoining(trackletOf(last).tracklet.end, begun.tracklet.begin);
        else if (m_robots > 1 && !m_evidence.givenHueRad[name])
            cost += costOfBeginning;
        if (!m_knowledge.sizesM.empty())
            cost += costOfSizes(begun.sizeM, m_knowledge.sizesM[name]);
        const std::size_t usualSlot = last != none ? trackletOf(last).slot : name;
        return usualSlot == begun.slot ? cost : cost + costOfRenaming;
    }

    /// Of what looks like a robot and is none.
    double costOfNoRobot(std::size_t t) const
    {
        const TrackletOf &begun = m_evidence.tracklets[t];
        return costOfNoRobotPerS * begun.likeness * (begun.tracklet.end.timeS - begun.tracklet.begin.timeS);
    }

    double colourCost(const TrackletOf &begun, std::size_t name) const
    {
        const Eigen::Vector2d &seen = begun.tracklet.meanChroma;
        if (seen.isZero())
            return 0;
        double cost = 0;
        if (const auto given = m_evidence.givenHueRad[name]) {
            const double hue =
                hueDifference(hueOf(seen) - m_evidence.hueShiftRad[begun.view], *given) / hueSigmaRad;
            cost = std::min(mostHueCost, 0.5 * hue * hue);
        }
        if (m_knowledge.looks.empty())
            return cost;
        const Eigen::Vector2d &look = m_knowledge.looks[begun.view][name];
        if (look.isZero())
            return cost;
        const double away = (seen - look).norm() / (leastLookSigma + relativeLookSigma * look.norm());
        return cost + std::min(mostLookCost, 0.5 * away * away);
    }

    const NameDecision &decisionOf(int number) const { return m_decisions[static_cast<std::size_t>(number)]; }

    /// Robots without a given colour whose names nothing has yet are all alike.
    bool isUnused(const NameHypothesis &hypothesis, std::size_t name) const
    {
        if (m_evidence.givenHueRad[name])
            return false;
        for (std::size_t view = 0; view < m_views; ++view)
            if (lastOf(hypothesis, view, name) != none)
                return false;
        return true;
    }

    /// Whether it was pointed out by hand as another, or another thing beside it as this one.
    bool contradictsPerson(std::size_t t, std::size_t name) const
    {
        const TrackletOf &one = m_evidence.tracklets[t];
        if (one.pointedOut)
            return *one.pointedOut != name;
        return std::ranges::any_of(m_evidence.tracklets, [&](const TrackletOf &other) {
            return other.pointedOut == name && other.view == one.view &&
                   other.tracklet.begin.timeS <= one.tracklet.end.timeS &&
                   one.tracklet.begin.timeS <= other.tracklet.end.timeS;
        });
    }

    /// A tracklet begins: it may be any robot that its view sees nowhere else just now, or none where more
    /// than the robots are followed.
    void decide(std::size_t t)
    {
        const TrackletOf &begun = m_evidence.tracklets[t];
        std::vector<NameHypothesis> next;
        std::vector<double> contradiction; // of each name, and of none
        for (std::size_t name = 0; name <= m_robots; ++name)
            contradiction.push_back(contradictsPerson(t, name) ? costOfContradicting : 0);
        const auto add = [&](const NameHypothesis &hypothesis, std::size_t name, double cost) {
            NameHypothesis &changed = next.emplace_back(hypothesis);
            changed.cost += cost + contradiction[name];
            if (name < m_robots)
                changed.last[positionOf(begun.view, name)] = static_cast<int>(t);
            m_decisions.push_back({hypothesis.decision, t, name, {}});
            changed.decision = static_cast<int>(m_decisions.size()) - 1;
        };
        for (const NameHypothesis &hypothesis : m_hypotheses) {
            bool isUnusedTried = false;
            for (std::size_t k = 0; k < m_robots; ++k) {
                const std::size_t name = (begun.slot + k) % m_robots;
                const int last = lastOf(hypothesis, begun.view, name);
                if (last != none && trackletOf(last).tracklet.end.timeS >= begun.tracklet.begin.timeS)
                    continue;
                if (!isUnused(hypothesis, name) || !std::exchange(isUnusedTried, true))
                    add(hypothesis, name, costOf(hypothesis, t, name));
            }
            if (m_evidence.slots[begun.view] > m_robots)
                add(hypothesis, m_robots, costOfNoRobot(t));
        }
        m_hypotheses = bestOf(std::move(next));
    }

    /// Of hypotheses that only differ in what lies behind the cheapest, which remembers those that were
    /// nearly as cheap; of all the cheapest few hundred, in order.
    std::vector<NameHypothesis> bestOf(std::vector<NameHypothesis> hypotheses)
    {
        std::sort(hypotheses.begin(), hypotheses.end(),
                  [](const NameHypothesis &a, const NameHypothesis &b) { return a.cost < b.cost; });
        std::map<std::vector<int>, std::size_t> known;
        std::vector<NameHypothesis> best;
        for (NameHypothesis &hypothesis : hypotheses) {
            if (best.size() == mostNameHypotheses || hypothesis.cost > hypotheses.front().cost + hopelessCost)
                break;
            const auto [its, isNew] = known.emplace(hypothesis.last, best.size());
            if (isNew) {
                best.push_back(hypothesis);
                continue;
            }
            const NameHypothesis &cheaper = best[its->second];
            if (const double more = hypothesis.cost - cheaper.cost; more < costOfUncertainty)
                m_decisions[static_cast<std::size_t>(cheaper.decision)].nearlyAsGood.emplace_back(
                    more, hypothesis.decision);
        }
        return best;
    }

    /// Of the tracklets up to a decision.
    std::vector<std::size_t> namesOf(int decision) const
    {
        std::vector<std::size_t> names(m_evidence.tracklets.size());
        for (int d = decision; d != none; d = decisionOf(d).before)
            names[decisionOf(d).tracklet] = decisionOf(d).name;
        return names;
    }

    /// Of each tracklet up to a decision the one before it of its name in its view, or none.
    using Links = std::vector<int>;
    Links linksOf(const std::vector<std::size_t> &names, int decision) const
    {
        Links links;
        std::vector<int> last(m_views * m_robots, none);
        for (std::size_t t = 0; decision != none && t <= decisionOf(decision).tracklet; ++t) {
            if (names[t] < m_robots)
                links.push_back(std::exchange(last[positionOf(m_evidence.tracklets[t].view, names[t])],
                                              static_cast<int>(t)));
            else
                links.push_back(none);
        }
        return links;
    }

    /// Where another way links the tracklets otherwise than the best one.
    void addAmbiguities(double bestCost, double cost, int decision, const Links &best,
                        FoundNames &found) const
    {
        if (cost - bestCost >= costOfUncertainty)
            return;
        const std::vector<std::size_t> names = namesOf(decision);
        const Links other = linksOf(names, decision);
        for (std::size_t t = 0; t < other.size(); ++t) {
            if (best[t] == none || best[t] == other[t])
                continue;
            // It goes on from another tracklet, whatever that one is called by this way.
            const std::size_t otherName =
                other[t] == none ? names[t] : found.names[static_cast<std::size_t>(other[t])];
            if (otherName < m_robots) // else it is not between robots
                found.ambiguities.push_back({static_cast<std::size_t>(best[t]), t, otherName});
        }
    }

    const NameEvidence &m_evidence;
    const NameKnowledge &m_knowledge;
    const std::size_t m_views, m_robots;
    /// of each tracklet, with those of other views that began before it
    std::vector<std::map<std::size_t, CostOfTwo>> m_apart;
    std::vector<NameHypothesis> m_hypotheses;
    std::vector<NameDecision> m_decisions;
};

} // namespace

FoundNames searchNames(const NameEvidence &evidence, std::size_t views, const NameKnowledge &knowledge)
{
    return NamesSearch(evidence, views, knowledge).run();
}

} // namespace odo
