// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_heading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace odo {

namespace {

constexpr double halfTurnRad = std::numbers::pi;
constexpr double longestUnknownS = 1; // after which it may have turned to any side
constexpr double stepM = 0.02;        // a move that no noise looks like
constexpr double muchLonger = 2, mostlyAlong = 0.7;
constexpr double nearlySquare = 1.15;    // length over width, or the other way round
constexpr double leastAlongShare = 0.75; // of the path of a nearly square body

/// The axis at one observation: continued from the one before it in time, of whichever view.
struct DirectedNode
{
    double timeS = 0;
    std::size_t view = 0, observation = 0;
    double angleRad = 0;
    Eigen::Vector2d moved = Eigen::Vector2d::Zero(); ///< since the last step, where one ends here
};

/// How far a body moved along its axis and across it, metres.
struct AxisMotion
{
    double firstM = 0, forwardsM = 0, backwardsM = 0, acrossM = 0;

    void add(const DirectedNode &node)
    {
        const Eigen::Vector2d axis(std::cos(node.angleRad), std::sin(node.angleRad));
        const double along = node.moved.dot(axis);
        if (firstM == 0 && std::abs(along) > mostlyAlong * node.moved.norm())
            firstM = along;
        (along > 0 ? forwardsM : backwardsM) += std::abs(along);
        acrossM += std::abs(axis.x() * node.moved.y() - axis.y() * node.moved.x());
    }
    double alongM() const { return forwardsM + backwardsM; }
    /// Whether it is the other end of the axis that is ahead.
    bool isOtherEnd() const
    {
        return firstM >= 0 ? backwardsM > muchLonger * forwardsM : forwardsM <= muchLonger * backwardsM;
    }
};

/// The axes that are known, in order of time, in stretches in which the body turns on without a jump.
class DirectedNodes
{
public:
    DirectedNodes(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
                  const std::vector<std::vector<BodyAxis>> &axes)
    {
        for (std::size_t v = 0; v < views.size(); ++v) {
            for (std::size_t i = 0; i < axes[v].size(); ++i) {
                if (axes[v][i].sigmaRad <= unknownAxisSigmaRad)
                    m_nodes.push_back(
                        {toSeconds(timeOf(views[v], views[v].observations[i])), v, i, axes[v][i].angleRad});
            }
        }
        std::ranges::stable_sort(m_nodes, {}, &DirectedNode::timeS);
        joinUp();
        addSteps(sightings);
    }

    std::span<DirectedNode> all() { return m_nodes; }
    const std::vector<std::span<DirectedNode>> &stretches() const { return m_stretches; }

private:
    void joinUp()
    {
        std::size_t first = 0;
        for (std::size_t i = 1; i <= m_nodes.size(); ++i) {
            if (i < m_nodes.size() && m_nodes[i].timeS - m_nodes[i - 1].timeS < longestUnknownS) {
                const double before = m_nodes[i - 1].angleRad;
                m_nodes[i].angleRad = before + std::remainder(m_nodes[i].angleRad - before, halfTurnRad);
                continue;
            }
            m_stretches.push_back(std::span(m_nodes).subspan(first, i - first));
            first = i;
        }
    }
    void addSteps(const std::vector<std::vector<Sighting>> &sightings)
    {
        for (const std::span<DirectedNode> stretch : m_stretches) {
            std::vector<std::optional<Eigen::Vector2d>> from(sightings.size());
            for (DirectedNode &node : stretch) {
                const auto &seen = sightings[node.view];
                if (node.observation >= seen.size() || !seen[node.observation].seen)
                    continue;
                const Eigen::Vector2d &here = seen[node.observation].position.pointInWorld;
                auto &start = from[node.view];
                if (start && (here - *start).norm() < stepM)
                    continue;
                if (start)
                    node.moved = here - *start;
                start = here;
            }
        }
    }

    std::vector<DirectedNode> m_nodes;
    std::vector<std::span<DirectedNode>> m_stretches;
};

AxisMotion motionOf(std::span<const DirectedNode> nodes)
{
    AxisMotion motion;
    for (const DirectedNode &node : nodes)
        if (!node.moved.isZero())
            motion.add(node);
    return motion;
}

void turn(std::span<DirectedNode> nodes, double byRad)
{
    for (DirectedNode &node : nodes)
        node.angleRad += byRad;
}

bool isNearlySquare(const SolidShape &shape)
{
    return std::max(shape.lengthM, shape.widthM) < nearlySquare * std::min(shape.lengthM, shape.widthM);
}

/// Whether all of it looks the same from all sides but for what errors of its outlines make of it: what seems
/// to be its axis then follows shadows, and not the body.
bool isRound(const SolidShape &shape)
{
    constexpr double leastRoundShare = 0.9, mostUnequal = 0.05, mostOff = 0.1; // of the length
    constexpr double sameHeight = 0.1;                                         // of the top's
    if (shape.form != SolidShape::Form::Levels || shape.roundShare < leastRoundShare ||
        std::abs(shape.lengthM - shape.widthM) > mostUnequal * shape.lengthM)
        return false;
    return std::ranges::all_of(shape.levels, [&shape](const SolidLevel &level) {
        SolidLevel here = level; // with what hides it: of two at one height the wider one is seen
        for (const SolidLevel &other : shape.levels) {
            if (std::abs(other.heightM - level.heightM) > sameHeight * shape.topM)
                continue;
            here.frontM = std::max(here.frontM, other.frontM);
            here.backM = std::max(here.backM, other.backM);
            here.leftM = std::max(here.leftM, other.leftM);
            here.rightM = std::max(here.rightM, other.rightM);
        }
        const auto [least, most] = std::minmax({here.frontM, here.backM, here.leftM, here.rightM});
        return most - least < mostOff * shape.lengthM;
    });
}

/// The angles of all observations, directed; and where the front is not known.
struct DirectedAngles
{
    std::vector<std::vector<std::optional<double>>> anglesRad;
    std::vector<std::vector<bool>> isFrontKnown;
};

DirectedAngles anglesOf(const std::vector<ViewTrack> &views, const DirectedNodes &nodes)
{
    DirectedAngles angles;
    for (const ViewTrack &view : views) {
        angles.anglesRad.emplace_back(view.observations.size());
        angles.isFrontKnown.emplace_back(view.observations.size());
    }
    for (const std::span<DirectedNode> stretch : nodes.stretches()) {
        const bool isKnown = motionOf(stretch).alongM() > 0;
        for (const DirectedNode &node : stretch) {
            angles.anglesRad[node.view][node.observation] = node.angleRad;
            angles.isFrontKnown[node.view][node.observation] = isKnown;
        }
    }
    return angles;
}

/// What outlines near one time say of how far the body is turned from the smoothed axis.
struct Deviation
{
    double weighted = 0, information = 0;

    void add(double awayRad, double sigmaRad)
    {
        const double weight = 1 / (sigmaRad * sigmaRad);
        weighted += weight * awayRad;
        information += weight;
    }
};

/// Which of the first view's times is nearest.
std::size_t nearestTime(const std::vector<double> &timesS, double timeS)
{
    const auto after = std::ranges::lower_bound(timesS, timeS);
    if (after == timesS.begin())
        return 0;
    const auto before = after - 1;
    const bool isBefore = after == timesS.end() || timeS - *before < *after - timeS;
    return static_cast<std::size_t>((isBefore ? before : after) - timesS.begin());
}

} // namespace

std::vector<std::vector<BodyAxis>> directedAxes(const std::vector<ViewTrack> &views,
                                                const std::vector<std::vector<Sighting>> &sightings,
                                                std::vector<std::vector<BodyAxis>> axes)
{
    const DirectedNodes nodes(views, sightings, axes);
    for (const std::span<DirectedNode> stretch : nodes.stretches()) {
        const double byRad = motionOf(stretch).isOtherEnd() ? halfTurnRad : 0;
        for (const DirectedNode &node : stretch)
            axes[node.view][node.observation].angleRad = node.angleRad + byRad;
    }
    return axes;
}

std::vector<std::optional<MeasuredHeading>>
headingsOfBody(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
               const TrackedBody &body)
{
    std::vector<std::optional<MeasuredHeading>> headings(views.front().observations.size());
    if (headings.empty() || isRound(body.shape)) // empty: a first video of which no frame could be read
        return headings;
    DirectedNodes nodes(views, sightings, body.axes);
    AxisMotion motion = motionOf(nodes.all());
    const double ahead =
        !body.isLengthGiven && motion.acrossM > muchLonger * motion.alongM() ? halfTurnRad / 2 : 0;
    if (ahead > 0) {
        turn(nodes.all(), ahead);
        motion = motionOf(nodes.all());
    }
    if (isNearlySquare(body.shape) && motion.alongM() < leastAlongShare * (motion.alongM() + motion.acrossM))
        return headings;
    for (const std::span<DirectedNode> stretch : nodes.stretches())
        if (motionOf(stretch).isOtherEnd())
            turn(stretch, halfTurnRad);
    const DirectedAngles angles = anglesOf(views, nodes);

    std::vector<double> timesS;
    for (const Observation &observation : views.front().observations)
        timesS.push_back(toSeconds(timeOf(views.front(), observation)));
    std::vector<Deviation> deviations(timesS.size());
    for (const auto &[view, observation, axis] : body.measured) {
        const auto &angle = angles.anglesRad[view][observation];
        const Sighting &sighting = sightings[view][observation];
        if (!angle || !sighting.seen || sighting.score <= 0)
            continue;
        const double timeS = toSeconds(timeOf(views[view], views[view].observations[observation]));
        deviations[nearestTime(timesS, timeS)].add(
            std::remainder(axis.angleRad + ahead - *angle, halfTurnRad), axis.sigmaRad);
    }
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const auto &angle = angles.anglesRad.front()[i];
        const Deviation &deviation = deviations[i];
        if (!angle || deviation.information <= 0)
            continue;
        // All of it may be shared: what an outline hides or adds depends on how the body is turned.
        const double sigmaRad = 1 / std::sqrt(deviation.information);
        headings[i] = MeasuredHeading{*angle + deviation.weighted / deviation.information, sigmaRad,
                                      std::hypot(sigmaRad, body.shapeSigmaRad)};
        if (!angles.isFrontKnown.front()[i])
            headings[i]->commonSigmaRad += unknownFrontSigmaRad;
    }
    return headings;
}

} // namespace odo
