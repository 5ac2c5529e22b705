// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/name_assignment.h"

#include "core/base/percentile.h"
#include "core/tracking/chroma.h"
#include "core/trajectory/internal/name_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double confusableHueRad = 40 * std::numbers::pi / 180;
constexpr std::size_t mostConfusable = 8;
constexpr double usualPlaneM = 0.04, highestAssignedM = 0.6;
constexpr double firstSigmaM = 0.1, secondSigmaM = 0.05;
constexpr double mostDisagreementM = 0.25; ///< median; beyond it the views do not show the same time or floor

constexpr int noName = -1;

/// For each view, slot and frame the name of the tracklet it belongs to, or noName.
using FrameNames = std::vector<std::vector<std::vector<int>>>;

FrameNames framesOf(const NameEvidence &evidence, const std::vector<std::size_t> &names,
                    const std::vector<NamedView> &views, const std::vector<std::size_t> &considered)
{
    FrameNames frames(views.size());
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t slot = 0; slot < evidence.slots[v]; ++slot)
            frames[v].emplace_back(observationsOf(views[v], considered, slot).size(), noName);
    }
    for (std::size_t t = 0; t < names.size(); ++t) {
        const TrackletOf &one = evidence.tracklets[t];
        auto &row = frames[one.view][one.slot];
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(one.tracklet.first),
                  row.begin() + static_cast<std::ptrdiff_t>(one.tracklet.last) + 1,
                  static_cast<int>(names[t]));
    }
    return frames;
}

/// Between tracklets: up to the middle the name before, from there the name behind.
void fillBetween(std::vector<int> &names)
{
    std::size_t i = 0;
    while (i < names.size()) {
        if (names[i] != noName) {
            ++i;
            continue;
        }
        const std::size_t first = i;
        while (i < names.size() && names[i] == noName)
            ++i;
        const int before = first > 0 ? names[first - 1] : noName,
                  behind = i < names.size() ? names[i] : noName;
        for (std::size_t k = first; k < i; ++k) {
            const bool early = behind == noName || (before != noName && 2 * k < first + i);
            names[k] = early ? before : behind;
        }
    }
}

/// What is seen for a moment apart from a tracklet may be anything, where anything is followed.
void dropUnconnected(const std::vector<Observation> &observations, const std::vector<int> &sure,
                     std::vector<int> &names)
{
    std::vector<bool> isConnected(names.size());
    const auto connect = [&](std::size_t i, std::size_t neighbour) {
        const bool goesOn = observations[i].found && isConnected[neighbour] && names[i] == names[neighbour];
        isConnected[i] = isConnected[i] || sure[i] != noName || goesOn;
    };
    for (std::size_t i = 0; i < names.size(); ++i)
        connect(i, i > 0 ? i - 1 : i);
    for (std::size_t i = names.size(); i-- > 0;)
        connect(i, i + 1 < names.size() ? i + 1 : i);
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = isConnected[i] ? names[i] : noName;
}

/// Names of all slots of a frame: those of tracklets stay, the others take the name they prefer while it is
/// free. If there are no more slots than robots they then take what is left.
std::vector<int> completed(const std::vector<int> &sure, const std::vector<int> &wished, std::size_t robots)
{
    std::vector<int> names = sure;
    std::vector<bool> taken(robots);
    const auto isRobot = [robots](int name) {
        return name != noName && static_cast<std::size_t>(name) < robots;
    };
    const auto take = [&](std::size_t slot, int name) {
        names[slot] = name;
        taken[static_cast<std::size_t>(name)] = true;
    };
    for (std::size_t slot = 0; slot < names.size(); ++slot) {
        if (isRobot(names[slot]))
            take(slot, names[slot]);
    }
    for (std::size_t slot = 0; slot < names.size(); ++slot) {
        if (names[slot] == noName && isRobot(wished[slot]) && !taken[static_cast<std::size_t>(wished[slot])])
            take(slot, wished[slot]);
    }
    for (std::size_t slot = 0; slot < names.size() && names.size() == robots; ++slot) {
        if (names[slot] == noName)
            take(slot, static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin()));
    }
    return names;
}

/// The same frame, in which a robot is not seen.
Observation unseenIn(const Observation &any)
{
    Observation unseen;
    unseen.frame = any.frame;
    unseen.time = any.time;
    unseen.duplicateFrame = any.duplicateFrame;
    return unseen;
}

std::int64_t rename(NamedView &view, const std::vector<std::size_t> &considered,
                    const std::vector<std::vector<int>> &sure)
{
    const std::size_t robots = considered.size(), slots = sure.size();
    std::vector<std::vector<int>> wished = sure;
    for (std::size_t slot = 0; slot < slots; ++slot) {
        fillBetween(wished[slot]);
        if (slots > robots)
            dropUnconnected(observationsOf(view, considered, slot), sure[slot], wished[slot]);
    }
    std::int64_t renamed = 0;
    for (std::size_t i = 0; i < sure.front().size(); ++i) {
        std::vector<int> sureHere(slots), wishedHere(slots);
        std::vector<Observation> seen;
        for (std::size_t slot = 0; slot < slots; ++slot) {
            sureHere[slot] = sure[slot][i];
            wishedHere[slot] = wished[slot][i];
            seen.push_back(observationsOf(view, considered, slot)[i]);
        }
        const std::vector<int> names = completed(sureHere, wishedHere, robots);
        for (std::size_t name = 0; name < robots; ++name) {
            const auto slot =
                static_cast<std::size_t>(std::ranges::find(names, static_cast<int>(name)) - names.begin());
            renamed += slot != name && slot < slots && seen[slot].found ? 1 : 0;
            view.robots[considered[name]][i] = slot < slots ? seen[slot] : unseenIn(seen.front());
        }
    }
    return renamed;
}

/// Where the names leave a view with much less of robots than the tracker took for them by itself, they are
/// its own: a view that contradicts the others is not silently left out.
void keepContradicting(const NameEvidence &evidence, std::size_t robots, std::vector<std::size_t> &names)
{
    constexpr double leastKept = 0.2;
    if (std::ranges::any_of(evidence.tracklets,
                            [](const TrackletOf &one) { return one.pointedOut.has_value(); }))
        return; // what a person says may contradict it
    for (std::size_t v = 0; v < evidence.slots.size(); ++v) {
        double named = 0, followed = 0;
        for (std::size_t t = 0; t < names.size(); ++t) {
            const TrackletOf &one = evidence.tracklets[t];
            const double weight =
                one.view == v ? one.likeness * double(one.tracklet.last - one.tracklet.first + 1) : 0;
            named += names[t] < robots ? weight : 0;
            followed += one.slot < robots ? weight : 0;
        }
        for (std::size_t t = 0; t < names.size() && named < leastKept * followed; ++t)
            if (evidence.tracklets[t].view == v)
                names[t] = std::min(evidence.tracklets[t].slot, robots);
    }
}

/// What the first round gives to the second.
class Lessons
{
public:
    Lessons(const NameEvidence &evidence, const std::vector<std::size_t> &names, std::size_t views)
        : m_evidence(evidence), m_names(names), m_views(views)
    {
    }

    /// The pairs of sights that two views have of one name: apart on the floor, and apart a metre of height.
    struct Pair
    {
        Eigen::Vector2d apart, perMetreHeight;
    };
    std::vector<Pair> pairs() const
    {
        std::vector<Pair> all;
        for (const FloorMoment &moment : m_evidence.moments)
            forEachTwo(moment, [&](const FloorSight &one, const FloorSight &other) {
                if (m_names[*one.tracklet] == m_names[*other.tracklet] && m_names[*one.tracklet] < robots())
                    all.push_back({one.onFloor - other.onFloor, one.perMetreHeight - other.perMetreHeight});
            });
        return all;
    }

    std::vector<std::vector<Eigen::Vector2d>> looks() const
    {
        std::vector<std::vector<Eigen::Vector2d>> sums(
            m_views, std::vector<Eigen::Vector2d>(robots(), Eigen::Vector2d::Zero()));
        std::vector<std::vector<double>> weights(m_views, std::vector<double>(robots()));
        for (std::size_t t = 0; t < m_names.size(); ++t) {
            const TrackletOf &one = m_evidence.tracklets[t];
            if (one.tracklet.meanChroma.isZero() || m_names[t] == robots())
                continue;
            const auto frames = static_cast<double>(one.tracklet.last - one.tracklet.first + 1);
            sums[one.view][m_names[t]] += frames * one.tracklet.meanChroma;
            weights[one.view][m_names[t]] += frames;
        }
        for (std::size_t v = 0; v < m_views; ++v) {
            for (std::size_t r = 0; r < robots(); ++r)
                sums[v][r] /= std::max(1.0, weights[v][r]);
        }
        return sums;
    }

    /// Medians over the frames of all views.
    std::vector<double> sizesM() const
    {
        std::vector<std::vector<double>> seen(robots());
        for (std::size_t t = 0; t < m_names.size(); ++t) {
            const TrackletOf &one = m_evidence.tracklets[t];
            if (m_names[t] < robots() && one.sizeM > 0)
                seen[m_names[t]].insert(seen[m_names[t]].end(), one.tracklet.last - one.tracklet.first + 1,
                                        one.sizeM);
        }
        std::vector<double> sizes;
        for (std::vector<double> &its : seen)
            sizes.push_back(its.empty() ? 0 : upperMedian(std::move(its)));
        return sizes;
    }

private:
    std::size_t robots() const { return m_evidence.givenHueRad.size(); }

    const NameEvidence &m_evidence;
    const std::vector<std::size_t> &m_names;
    const std::size_t m_views;
};

/// The height of best agreement, each pair's own in the median.
double planeOf(const std::vector<Lessons::Pair> &pairs)
{
    std::vector<double> heights;
    for (const Lessons::Pair &pair : pairs) {
        const double square = pair.perMetreHeight.squaredNorm();
        if (square > 0.01)
            heights.push_back(-pair.apart.dot(pair.perMetreHeight) / square);
    }
    return heights.empty() ? usualPlaneM : std::clamp(upperMedian(std::move(heights)), 0.0, highestAssignedM);
}

double disagreementOf(const std::vector<Lessons::Pair> &pairs, double planeM)
{
    std::vector<double> distances;
    for (const Lessons::Pair &pair : pairs)
        distances.push_back((pair.apart + planeM * pair.perMetreHeight).norm());
    return distances.empty() ? 0 : upperMedian(std::move(distances));
}

FoundNames decideNames(const NameEvidence &evidence, std::size_t views, std::optional<double> givenPlaneM)
{
    NameKnowledge knowledge;
    knowledge.planeM = givenPlaneM.value_or(usualPlaneM);
    knowledge.floorSigmaM = firstSigmaM;
    const std::vector<std::size_t> first = searchNames(evidence, views, knowledge).names;

    const Lessons lessons(evidence, first, views);
    const auto pairs = lessons.pairs();
    knowledge.planeM = givenPlaneM ? *givenPlaneM : planeOf(pairs);
    knowledge.floorSigmaM = secondSigmaM;
    knowledge.viewsAgree = disagreementOf(pairs, knowledge.planeM) < mostDisagreementM;
    knowledge.looks = lessons.looks();
    knowledge.sizesM = lessons.sizesM();
    return searchNames(evidence, views, knowledge);
}

/// Half the mean of the given heights, if all are given.
std::optional<double> givenPlane(const std::vector<NamedRobot> &robots,
                                 const std::vector<std::size_t> &considered)
{
    double sum = 0;
    for (const std::size_t robot : considered) {
        if (!robots[robot].heightM)
            return std::nullopt;
        sum += *robots[robot].heightM / 2;
    }
    return sum / static_cast<double>(considered.size());
}

/// The times of ambiguous links, joined where they overlap.
std::vector<NameAmbiguity> ambiguitiesOf(const FoundNames &found, const NameEvidence &evidence,
                                         const std::vector<std::size_t> &considered)
{
    std::vector<NameAmbiguity> all;
    for (const AmbiguousLink &link : found.ambiguities) {
        const double fromS = evidence.tracklets[link.before].tracklet.end.timeS,
                     toS = evidence.tracklets[link.behind].tracklet.begin.timeS;
        const std::size_t name = found.names[link.behind];
        NameAmbiguity &ambiguity =
            all.emplace_back(NameAmbiguity{considered[name], fromS, std::max(fromS, toS)});
        if (link.otherName != name)
            ambiguity.others = {considered[link.otherName]};
    }
    std::ranges::sort(
        all, {}, [](const NameAmbiguity &ambiguity) { return std::pair(ambiguity.robot, ambiguity.fromS); });
    std::vector<NameAmbiguity> joined;
    for (const NameAmbiguity &ambiguity : all) {
        if (joined.empty() || joined.back().robot != ambiguity.robot || ambiguity.fromS > joined.back().toS) {
            joined.push_back(ambiguity);
            continue;
        }
        NameAmbiguity &earlier = joined.back();
        earlier.toS = std::max(earlier.toS, ambiguity.toS);
        earlier.others.insert(earlier.others.end(), ambiguity.others.begin(), ambiguity.others.end());
    }
    for (NameAmbiguity &ambiguity : joined) {
        std::ranges::sort(ambiguity.others);
        ambiguity.others.erase(std::unique(ambiguity.others.begin(), ambiguity.others.end()),
                               ambiguity.others.end());
    }
    return joined;
}

} // namespace

std::vector<std::vector<std::size_t>> robotsOfLikeColours(const std::vector<NamedRobot> &robots)
{
    std::vector<std::vector<std::size_t>> groups;
    const auto areAlike = [&](std::size_t a, std::size_t b) {
        const auto hueA = givenHue(robots[a]), hueB = givenHue(robots[b]);
        return hueA && hueB ? std::abs(hueDifference(*hueA, *hueB)) < confusableHueRad
                            : hueA.has_value() == hueB.has_value();
    };
    for (std::size_t robot = 0; robot < robots.size(); ++robot) {
        std::vector<std::size_t> group;
        std::erase_if(groups, [&](const std::vector<std::size_t> &earlier) {
            const bool near = std::any_of(earlier.begin(), earlier.end(),
                                          [&](std::size_t other) { return areAlike(robot, other); });
            if (near)
                group.insert(group.end(), earlier.begin(), earlier.end());
            return near;
        });
        group.push_back(robot);
        groups.push_back(std::move(group));
    }
    for (auto &group : groups)
        std::sort(group.begin(), group.end());
    return groups;
}

NameOutcome assignNames(std::vector<NamedView> &views, const std::vector<NamedRobot> &robots)
{
    NameOutcome outcome;
    for (const std::vector<std::size_t> &considered : robotsOfLikeColours(robots)) {
        if (considered.size() > mostConfusable)
            continue;
        const NameEvidence evidence = gatherEvidence(views, robots, considered);
        outcome.nothingThere.insert(outcome.nothingThere.end(), evidence.nothingThere.begin(),
                                    evidence.nothingThere.end());
        if (evidence.tracklets.empty() || std::ranges::max(evidence.slots) < 2)
            continue;
        FoundNames found = decideNames(evidence, views.size(), givenPlane(robots, considered));
        keepContradicting(evidence, considered.size(), found.names);
        const FrameNames frames = framesOf(evidence, found.names, views, considered);
        for (std::size_t v = 0; v < views.size(); ++v)
            outcome.renamed += rename(views[v], considered, frames[v]);
        if (considered.size() > 1)
            std::ranges::move(ambiguitiesOf(found, evidence, considered),
                              std::back_inserter(outcome.ambiguities));
    }
    return outcome;
}

} // namespace odo
