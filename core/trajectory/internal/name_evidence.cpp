// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/name_evidence.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/geometry/silhouette.h"
#include "core/tracking/chroma.h"
#include "core/trajectory/analyser.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace odo {

namespace {

constexpr double leastScore = 0.2;
constexpr std::size_t leastFrames = 3, framesOfVelocity = 6;
constexpr double mostLinkCost = 12.0;
constexpr double accelerationRadii = 16.0; ///< per s²: 2 m/s² of a robot whose circle has a radius of 0.12 m
constexpr double positionSigmaRadii = 0.3, speedSigmaRadii = 0.5;

Tracklet::End endAt(const std::vector<Observation> &observations, std::size_t at, std::size_t inner,
                    const ViewClock &clock)
{
    const Observation &outermost = observations[at], &other = observations[inner];
    Tracklet::End end;
    end.timeS = toSeconds(clock.commonTime(outermost.time));
    end.positionPx = outermost.ellipse.centrePx;
    const double dt = toSeconds(outermost.time) - toSeconds(other.time);
    if (dt != 0)
        end.velocityPxPerS = (outermost.ellipse.centrePx - other.ellipse.centrePx) / dt;
    end.radiusPx = std::sqrt(std::max(1.0, outermost.areaPx) / std::numbers::pi);
    return end;
}

Tracklet trackletOf(const std::vector<Observation> &observations, std::size_t first, std::size_t last,
                    const ViewClock &clock)
{
    Tracklet tracklet{first, last, {}, {}, {}};
    tracklet.begin = endAt(observations, first, std::min(last, first + framesOfVelocity), clock);
    tracklet.end =
        endAt(observations, last, std::max(first + framesOfVelocity, last) - framesOfVelocity, clock);
    double coloured = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const Eigen::Vector2d &chroma = observations[i].meanChroma;
        if (chroma.isZero())
            continue;
        tracklet.meanChroma += chroma;
        coloured += 1;
    }
    if (coloured > 0)
        tracklet.meanChroma /= coloured;
    return tracklet;
}

} // namespace

bool isSure(const Observation &observation)
{
    return observation.found && observation.score >= leastScore && observation.ellipse.centrePx.allFinite();
}

std::vector<Tracklet> cutIntoTracklets(const std::vector<Observation> &observations, const ViewClock &clock)
{
    std::vector<Tracklet> tracklets;
    for (std::size_t i = 0; i < observations.size(); ++i) {
        const std::size_t first = i;
        while (i < observations.size() && isSure(observations[i]))
            ++i;
        if (i >= first + leastFrames)
            tracklets.push_back(trackletOf(observations, first, i - 1, clock));
    }
    return tracklets;
}

double costOfJoining(const Tracklet::End &end, const Tracklet::End &begin)
{
    const double dt = std::max(0.0, begin.timeS - end.timeS);
    const double radius = std::max(1.0, std::min(end.radiusPx, begin.radiusPx));
    const double positionSigma = radius * (positionSigmaRadii + 0.25 * accelerationRadii * dt * dt);
    const double speedSigma = radius * (speedSigmaRadii + accelerationRadii * dt);
    const Eigen::Vector2d halfway = (begin.positionPx - 0.5 * dt * begin.velocityPxPerS) -
                                    (end.positionPx + 0.5 * dt * end.velocityPxPerS);
    const Eigen::Vector2d change = begin.velocityPxPerS - end.velocityPxPerS;
    return std::min(mostLinkCost, 0.5 * (halfway.squaredNorm() / (positionSigma * positionSigma) +
                                         change.squaredNorm() / (speedSigma * speedSigma)));
}

namespace {

constexpr double momentStepS = 0.05;
constexpr double longestInterpolationS = 0.12;
// of what stands still; what goes all the time and as far is as likely a robot as can be
constexpr double leastLikeness = 0.15, distanceOfRobotM = 1;
constexpr double likenessAtBorder = 0.3;
constexpr double secondPlaneM = 0.1; ///< any height: a ray moves on a straight line through the planes

/// The side of a square of what is seen, were it upright over its floor position, m; 0 beyond the horizon.
double sizeOf(const FloorView &view, const Observation &seen)
{
    constexpr double besidePx = 4;
    const Eigen::Vector2d aside(besidePx, 0);
    const auto left = view.floorFromPixel(seen.ellipse.centrePx - aside, 0),
               right = view.floorFromPixel(seen.ellipse.centrePx + aside, 0);
    return left && right ? std::sqrt(seen.areaPx) * (*right - *left).norm() / (2 * besidePx) : 0;
}

/// Walks along one slot's observations as time advances.
class SlotReader
{
public:
    SlotReader(const NamedView &view, const std::vector<Observation> &observations)
        : m_view(view), m_observations(observations)
    {
    }

    /// Times must not go back.
    FloorSight at(double timeS)
    {
        while (m_next < m_observations.size() && timeOf(m_next) <= timeS)
            ++m_next;
        if (m_next == 0 || m_next >= m_observations.size())
            return {};
        const Observation &before = m_observations[m_next - 1], &behind = m_observations[m_next];
        const double interval = timeOf(m_next) - timeOf(m_next - 1);
        if (!isSure(before) || !isSure(behind) || interval > longestInterpolationS || interval <= 0)
            return {};
        const double part = (timeS - timeOf(m_next - 1)) / interval;
        const Eigen::Vector2d pixel = (1 - part) * before.ellipse.centrePx + part * behind.ellipse.centrePx;
        const auto low = m_view.floorView->floorFromPixel(pixel, 0),
                   high = m_view.floorView->floorFromPixel(pixel, secondPlaneM);
        if (!low || !high)
            return {};
        return {true, {}, *low, (*high - *low) / secondPlaneM, sizeOf(*m_view.floorView, before)};
    }

private:
    double timeOf(std::size_t i) const { return toSeconds(odo::timeOf(m_view, m_observations[i])); }

    const NamedView &m_view;
    const std::vector<Observation> &m_observations;
    std::size_t m_next = 0;
};

std::vector<FloorMoment> gatherMoments(const std::vector<NamedView> &views,
                                       const std::vector<std::size_t> &considered,
                                       const std::vector<std::size_t> &slots)
{
    double beginS = 1e300, endS = -1e300;
    std::vector<std::vector<SlotReader>> readers(views.size());
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto &any = views[v].robots[considered.front()];
        if (!views[v].floorView || any.empty())
            continue;
        beginS = std::min(beginS, toSeconds(timeOf(views[v], any.front())));
        endS = std::max(endS, toSeconds(timeOf(views[v], any.back())));
        for (std::size_t slot = 0; slot < slots[v]; ++slot)
            readers[v].emplace_back(views[v], observationsOf(views[v], considered, slot));
    }
    std::vector<FloorMoment> moments;
    for (double timeS = beginS; timeS <= endS; timeS += momentStepS) {
        FloorMoment moment{timeS, std::vector<std::vector<FloorSight>>(views.size())};
        int viewsThatSee = 0;
        for (std::size_t v = 0; v < views.size(); ++v) {
            bool any = false;
            for (SlotReader &reader : readers[v]) {
                moment.sights[v].push_back(reader.at(timeS));
                any |= moment.sights[v].back().seen;
            }
            viewsThatSee += any ? 1 : 0;
        }
        if (viewsThatSee > 1)
            moments.push_back(std::move(moment));
    }
    return moments;
}

struct PositionAtTime
{
    double timeS = 0;
    Eigen::Vector2d stationM;
};

/// Of the times at which something was seen, the share at which it had moved on within the second before.
double shareInMotion(const std::vector<PositionAtTime> &path)
{
    constexpr double longestS = 1, leastMps = 0.02, leastM = 0.01; // less is what an outline at rest does
    std::size_t moving = 0, from = 0;
    for (const PositionAtTime &now : path) {
        while (now.timeS - path[from].timeS > longestS)
            ++from;
        const double goneM = (now.stationM - path[from].stationM).norm();
        moving += goneM > leastM && goneM > leastMps * (now.timeS - path[from].timeS) ? 1 : 0;
    }
    return path.empty() ? 0 : double(moving) / double(path.size());
}

/// Robots drive over the floor within the frame; people stand beside it, a ball comes to rest, hands reach
/// in over its edge.
TrackletOf judged(TrackletOf one, const NamedView &view, const std::vector<Observation> &observations)
{
    Eigen::AlignedBox2d visited;
    std::vector<double> sizes;
    std::vector<PositionAtTime> path;
    double atBorder = 0;
    const double frames = double(one.tracklet.last - one.tracklet.first + 1);
    for (std::size_t i = one.tracklet.first; i <= one.tracklet.last; ++i) {
        const Observation &seen = observations[i];
        atBorder += seen.touchesBorder ? 1 / frames : 0;
        const auto position =
            view.floorView ? view.floorView->floorFromPixel(seen.ellipse.centrePx, 0) : std::nullopt;
        if (!position)
            continue;
        visited.extend(*position);
        path.push_back({toSeconds(seen.time), *position});
        sizes.push_back(sizeOf(*view.floorView, seen));
    }
    const double movedM = visited.isEmpty() ? 0 : visited.diagonal().norm();
    const double moves =
        leastLikeness + (1 - leastLikeness) * std::min(1.0, movedM / distanceOfRobotM) * shareInMotion(path);
    one.likeness = moves * (1 - (1 - likenessAtBorder) * atBorder);
    one.sizeM = sizes.empty() ? 0 : upperMedian(std::move(sizes));
    return one;
}

/// Notes for all sights that saw something which tracklet they show.
void addTracklets(NameEvidence &evidence)
{
    std::size_t next = 0;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> newest; // of each view and slot
    for (FloorMoment &moment : evidence.moments) {
        for (; next < evidence.tracklets.size() &&
               evidence.tracklets[next].tracklet.begin.timeS <= moment.timeS;
             ++next)
            newest[{evidence.tracklets[next].view, evidence.tracklets[next].slot}] = next;
        for (const auto &[position, index] : newest) {
            const auto &[view, slot] = position;
            if (slot < moment.sights[view].size() && moment.sights[view][slot].seen &&
                evidence.tracklets[index].tracklet.end.timeS >= moment.timeS)
                moment.sights[view][slot].tracklet = index;
        }
    }
}

/// Whether an outline holds a pixel, or nearly so.
bool holds(const Observation &seen, const Eigen::Vector2d &pixel)
{
    constexpr double besidePx = 4;
    if (!seen.found)
        return false;
    if (!seen.supportPx.empty())
        return isWithinSupport(seen.supportPx, seen.ellipse.centrePx, pixel, besidePx);
    const Eigen::Vector2d away = Eigen::Rotation2Dd(-seen.ellipse.angleRad) * (pixel - seen.ellipse.centrePx);
    return std::hypot(away.x() / (seen.ellipse.semiMajorPx + besidePx),
                      away.y() / (seen.ellipse.semiMinorPx + besidePx)) <= 1;
}

/// Whether what was tracked as a robot, by its colour, is where a person says it is.
bool isTrackedThere(const NamedView &view, const PointedOut &given)
{
    return std::ranges::any_of(view.robots[given.robot], [&given](const Observation &one) {
        return one.frame == given.frame && holds(one, given.pixel);
    });
}

/// Marks the tracklets pointed out by hand: of several that contain the point, that of the smallest thing.
void addPointedOut(const std::vector<NamedView> &views, const std::vector<std::size_t> &considered,
                   NameEvidence &evidence)
{
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t i = 0; i < views[v].pointedOut.size(); ++i) {
            const PointedOut &given = views[v].pointedOut[i];
            const auto name = std::ranges::find(considered, given.robot);
            if (name == considered.end())
                continue;
            TrackletOf *own = nullptr;
            double leastPx = HUGE_VAL;
            for (TrackletOf &one : evidence.tracklets) {
                if (one.view != v)
                    continue;
                const auto &observations = observationsOf(views[v], considered, one.slot);
                const auto at = std::ranges::find(observations, given.frame, &Observation::frame);
                const auto index = static_cast<std::size_t>(at - observations.begin());
                if (index < one.tracklet.first || index > one.tracklet.last || !holds(*at, given.pixel) ||
                    at->areaPx >= leastPx)
                    continue;
                own = &one;
                leastPx = at->areaPx;
            }
            if (own)
                own->pointedOut = static_cast<std::size_t>(name - considered.begin());
            else if (!isTrackedThere(views[v], given))
                evidence.nothingThere.emplace_back(v, i);
        }
    }
}

/// Mean of what all robots' hues together are off. It does not depend on who is who, as long as all are
/// there.
double hueShiftOf(const NamedView &view, const std::vector<std::size_t> &considered,
                  const std::vector<std::optional<double>> &given)
{
    double sum = 0, count = 0;
    const std::size_t frames = view.robots[considered.front()].size();
    for (std::size_t i = 0; i < frames; ++i) {
        double shift = 0;
        bool all = true;
        for (std::size_t k = 0; all && k < considered.size(); ++k) {
            const Observation &observation = view.robots[considered[k]][i];
            all = given[k] && isSure(observation) && !observation.meanChroma.isZero();
            shift += all ? hueDifference(hueOf(observation.meanChroma), *given[k]) : 0;
        }
        if (!all)
            continue;
        sum += shift / static_cast<double>(considered.size());
        count += 1;
    }
    return count > 0 ? sum / count : 0;
}

} // namespace

const std::vector<Observation> &observationsOf(const NamedView &view,
                                               const std::vector<std::size_t> &considered, std::size_t slot)
{
    return slot < considered.size() ? view.robots[considered[slot]] : view.others[slot - considered.size()];
}

std::optional<double> givenHue(const NamedRobot &robot)
{
    return robot.colour ? std::optional(hueOf(chromaOf(*robot.colour, FrameFormat{}))) : std::nullopt;
}

double hueOf(const Eigen::Vector2d &chroma)
{
    return std::atan2(chroma.y(), chroma.x());
}

double hueDifference(double a, double b)
{
    return std::remainder(a - b, 2 * std::numbers::pi);
}

NameEvidence gatherEvidence(const std::vector<NamedView> &views, const std::vector<NamedRobot> &robots,
                            const std::vector<std::size_t> &considered)
{
    NameEvidence evidence;
    for (const std::size_t robot : considered)
        evidence.givenHueRad.push_back(givenHue(robots[robot]));
    const bool ofAnyLook = std::ranges::none_of(evidence.givenHueRad, &std::optional<double>::has_value);
    for (std::size_t v = 0; v < views.size(); ++v) {
        evidence.slots.push_back(considered.size() + (ofAnyLook ? views[v].others.size() : 0));
        for (std::size_t slot = 0; slot < evidence.slots[v]; ++slot) {
            const auto &observations = observationsOf(views[v], considered, slot);
            for (const Tracklet &tracklet : cutIntoTracklets(observations, clockOf(views[v])))
                evidence.tracklets.push_back(judged({v, slot, tracklet, 1, {}, 0}, views[v], observations));
        }
        evidence.hueShiftRad.push_back(hueShiftOf(views[v], considered, evidence.givenHueRad));
    }
    std::stable_sort(evidence.tracklets.begin(), evidence.tracklets.end(),
                     [](const TrackletOf &a, const TrackletOf &b) {
                         return a.tracklet.begin.timeS < b.tracklet.begin.timeS;
                     });
    addPointedOut(views, considered, evidence);
    evidence.moments = gatherMoments(views, considered, evidence.slots);
    addTracklets(evidence);
    return evidence;
}

} // namespace odo
