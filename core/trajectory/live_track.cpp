// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/live_track.h"
#include "core/analysis/gate_passages.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/motion_noise.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"

#include <algorithm>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds stalledAfter = 200ms, lostAfter = 1s;
constexpr double stalledIntervals = 2.5; // of a camera that is slower than that
constexpr double worstSigmaM = 0.1;      // beyond it a position is a guess
constexpr std::size_t keptObservations = 60, keptTimes = 60, keptNodes = 90;
constexpr std::size_t observationsForInterpolation = 8;
constexpr double leastStepShare = 0.75; // of an interval: one position a frame, not one for each view's
constexpr std::int64_t planeEach = 15, noiseEach = 30;
constexpr std::size_t leastNodesForNoise = 30;
constexpr int refusedInARow = 4; // then it is the robot, and the filter was wrong
// The centre of a body's silhouette is only to first order the image of its centre (docs/accuracy.md).
constexpr double silhouetteSigmaM = 0.004;

template <class T>
void keepLast(std::vector<T> &values, std::size_t count)
{
    if (values.size() > count)
        values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(count));
}

/// Only the newest observations: what is interpolated lies among them.
ViewTrack newestOf(const ViewTrack &view)
{
    const std::size_t count = std::min(view.observations.size(), observationsForInterpolation);
    return {view.view,
            view.floorView,
            Nanoseconds{0},
            {view.observations.end() - static_cast<std::ptrdiff_t>(count), view.observations.end()}};
}

} // namespace

LiveTrack::LiveTrack(std::vector<LiveView> views, RobotShape shape)
    : m_sightings(views.size()), m_shape(shape), m_noise{usualJerkDensity}
{
    for (LiveView &view : views)
        m_views.push_back({std::move(view.camera), std::move(view.floorView), Nanoseconds{0}, {}});
    m_plane = choosePlane(m_views, {}, m_shape);
    m_filter = MotionFilter(m_noise);
}

std::optional<LivePosition> LiveTrack::add(std::size_t view, const Observation &observation)
{
    ViewTrack &track = m_views[view];
    if (!track.floorView ||
        (!track.observations.empty() && observation.time <= track.observations.back().time))
        return std::nullopt;
    track.observations.push_back(observation);
    keepLast(track.observations, keptObservations);
    const auto time = commonTime();
    if (!time)
        return std::nullopt;
    choosePlaneAgain();
    return positionAt(*time);
}

/// nullopt: no view has gone on so far that there is something new.
std::optional<Nanoseconds> LiveTrack::commonTime() const
{
    Nanoseconds newest = Nanoseconds::min();
    for (const ViewTrack &view : m_views) {
        if (!view.observations.empty())
            newest = std::max(newest, view.observations.back().time);
    }
    const Nanoseconds patience =
        std::max(stalledAfter, fromSeconds(stalledIntervals * toSeconds(usualInterval())));
    Nanoseconds common = newest;
    for (const ViewTrack &view : m_views) {
        if (!view.observations.empty() && view.observations.back().time >= newest - patience)
            common = std::min(common, view.observations.back().time);
    }
    if (m_times.empty())
        return common;
    const double stepS = toSeconds(common - m_times.back());
    return stepS > leastStepShare * toSeconds(usualInterval()) && stepS > 0 ? std::optional(common)
                                                                            : std::nullopt;
}

/// Between the frames of the view that has the most of them.
Nanoseconds LiveTrack::usualInterval() const
{
    Nanoseconds shortest = Nanoseconds::max();
    for (const ViewTrack &view : m_views) {
        const std::size_t count = view.observations.size();
        if (count > 1)
            shortest = std::min(shortest, (view.observations.back().time - view.observations.front().time) /
                                              static_cast<std::int64_t>(count - 1));
    }
    return shortest == Nanoseconds::max() ? Nanoseconds{0} : shortest;
}

void LiveTrack::choosePlaneAgain()
{
    if (m_next % planeEach != 0 || m_next == m_planeChosenAt)
        return;
    m_planeChosenAt = m_next;
    const PlaneChoice choice = choosePlane(m_views, m_times, m_shape);
    // One height for good is known the better the longer the robot was seen; a robot on a ramp has another
    // one each time.
    if (choice.heightM > 0 &&
        (m_shape.heightM || m_shape.heightVaries || m_plane.heightM <= 0 || choice.sigmaM < m_plane.sigmaM))
        m_plane = choice;
}

LivePosition LiveTrack::positionAt(Nanoseconds time)
{
    m_times.push_back(time);
    m_numbers.push_back(m_next++);
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        const auto at = viewFromAllSides({newestOf(m_views[v])}, {time}, m_plane.planeM);
        m_sightings[v].push_back(at.front().front());
        keepLast(m_sightings[v], keptTimes);
    }
    keepLast(m_times, keptTimes);
    keepLast(m_numbers, keptTimes);
    FusionSettings settings;
    settings.planeSigmaM = m_plane.sigmaM;
    LivePosition position;
    position.sample = fuseViews(m_times, m_numbers, m_sightings, settings).samples.back();
    position.sample.commonCovariance += Eigen::Matrix2d::Identity() * silhouetteSigmaM * silhouetteSigmaM;
    filter(position);
    return position;
}

void LiveTrack::fitNoiseAgain()
{
    if (m_nodes.size() < leastNodesForNoise || m_next % noiseEach != 0)
        return;
    m_noise = estimateMotionNoise({m_nodes}, true);
    // The filter goes on with the new noise from where it was: the last second has all the information.
    m_filter = MotionFilter(m_noise);
    for (const TrackNode &node : m_nodes) {
        m_filter.predict(node);
        m_filter.update(node);
    }
}

void LiveTrack::filter(LivePosition &position)
{
    const Sample &sample = position.sample;
    TrackNode node;
    node.timeS = toSeconds(sample.time);
    node.measured = sample.position && !isRejected(sample.flags);
    if (!m_nodes.empty() && node.timeS - m_nodes.back().timeS > toSeconds(lostAfter)) {
        m_nodes.clear(); // it may have been carried anywhere
        m_filter = MotionFilter(m_noise);
    }
    position.isSpike = sample.position && !node.measured;
    if (node.measured) {
        node.position = *sample.position;
        node.covariance = sample.covariance;
        if (!m_nodes.empty())
            m_travelM += (node.position - m_nodes.back().position).norm() +
                         restDriftMps * (node.timeS - m_nodes.back().timeS);
    }
    node.travelM = m_travelM;
    m_filter.predict(node);
    if (node.measured && m_filter.started() && m_filter.distanceSquared(node) > refusalGate &&
        ++m_refused < refusedInARow) {
        position.isSpike = true;
    } else if (node.measured) {
        if (m_refused >= refusedInARow) {
            m_nodes.clear();
            m_filter.restart(node);
        } else {
            m_filter.update(node);
        }
        m_refused = 0;
        m_nodes.push_back(node);
        keepLast(m_nodes, keptNodes);
        fitNoiseAgain();
    }
    constexpr std::size_t leastNodes = 4; // a speed from fewer is none
    if (m_nodes.size() < leastNodes)
        return;
    position.point = makePoint(m_filter.estimate(), sample.commonCovariance);
    position.point.valid = std::max(position.point.sigmaXM, position.point.sigmaYM) < worstSigmaM;
}

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds window = 5s; // a robot that stops before a gate for longer has not passed it yet
constexpr Nanoseconds samePassage = 50ms;

} // namespace

std::vector<GatePassage> LiveGates::add(const LivePosition &position)
{
    if (m_gates.empty())
        return {};
    m_samples.push_back(position.sample);
    m_points.push_back(position.point);
    const auto old = std::ranges::find_if(
        m_samples, [&](const Sample &sample) { return sample.time >= position.sample.time - window; });
    m_points.erase(m_points.begin(), m_points.begin() + (old - m_samples.begin()));
    m_samples.erase(m_samples.begin(), old);
    std::vector<GatePassage> found = findPassages(m_gates, m_samples, m_points);
    std::erase_if(found, [this](const GatePassage &passage) { return isKnown(passage); });
    m_passages.insert(m_passages.end(), found.begin(), found.end());
    return found;
}

bool LiveGates::isKnown(const GatePassage &passage) const
{
    return std::ranges::any_of(m_passages, [&](const GatePassage &known) {
        return known.gate == passage.gate && std::chrono::abs(known.time - passage.time) < samePassage;
    });
}

void LiveGates::forget()
{
    m_samples.clear();
    m_points.clear();
    m_passages.clear();
}

} // namespace odo
