// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_metrics.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/internal/path_following.h"
#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace odo {

namespace {

/// A distance from the path with its σ, and the distance travelled that it represents.
struct Offset
{
    double valueM = 0, ownM = 0, commonM = 0;
    double pathM = 0;
    double togetherM = 0; ///< distance over which the errors are correlated, at least its own
};

std::vector<Offset> offsetsOf(const std::vector<RunInstant> &instants,
                              const std::vector<PathPosition> &followed,
                              const std::vector<MeasuredPosition> &positions)
{
    std::vector<Offset> offsets;
    for (const MotionStretch &motion : findMotions(instants)) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            if (followed[i].beyondEnd)
                continue;
            const double from = instants[i == motion.first ? i : i - 1].timeS;
            const double to = instants[i == motion.last ? i : i + 1].timeS;
            const double speed = instants[i].point->speedMps;
            const double travelledM = speed * std::max(0.0, to - from) / 2;
            offsets.push_back({followed[i].offsetM, sigmaAlong(positions[i].own, followed[i].left),
                               sigmaAlong(positions[i].common, followed[i].left), travelledM,
                               std::max(travelledM, speed * correlationTimeS(instants[i]))});
        }
    }
    return offsets;
}

/// σ of a metric that changes by slope(offset) · distance / whole for a change of one offset.
template <class Slope>
double sigmaOfValue(const std::vector<Offset> &offsets, double wholeM, const Slope &slope)
{
    double own = 0, common = 0;
    for (const Offset &offset : offsets) {
        const double weight = slope(offset) / wholeM;
        own += std::pow(weight * offset.ownM, 2) * offset.pathM * offset.togetherM;
        common += std::abs(weight) * offset.pathM * offset.commonM;
    }
    return std::hypot(std::sqrt(own), common);
}

/// Mean of |x| of a normal x (the folded normal distribution: Leone, Nelson, Nottingham 1961).
double meanMagnitude(double mean, double sigma)
{
    if (!(sigma > 0))
        return std::abs(mean);
    return sigma * std::sqrt(2 / std::numbers::pi) * std::exp(-mean * mean / (2 * sigma * sigma)) +
           mean * std::erf(mean / (sigma * std::numbers::sqrt2));
}

/// σ of the largest distance: its own, and by how much the largest of several that are as likely to be it is
/// too large: σ·√(2 ln n) of n independent ones at most.
double sigmaOfLargest(const std::vector<Offset> &offsets, const Offset &largest)
{
    double rivals = 0;
    for (const Offset &offset : offsets) {
        if (std::abs(offset.valueM) >= std::abs(largest.valueM) - 2 * largest.ownM && offset.togetherM > 0)
            rivals += offset.pathM / offset.togetherM;
    }
    const double chosen = largest.ownM * std::sqrt(2 * std::log(std::max(1.0, rivals)));
    return std::hypot(std::hypot(largest.ownM, chosen), largest.commonM);
}

void addOffsets(std::vector<Metric> &metrics, const std::vector<Offset> &offsets)
{
    double whole = 0, sum = 0, magnitudes = 0, squares = 0, noise = 0, folded = 0;
    for (const Offset &offset : offsets) {
        whole += offset.pathM;
        sum += offset.pathM * offset.valueM;
        magnitudes += offset.pathM * std::abs(offset.valueM);
        squares += offset.pathM * offset.valueM * offset.valueM;
        noise += offset.pathM * offset.ownM * offset.ownM;
        folded += offset.pathM * meanMagnitude(offset.valueM, offset.ownM);
    }
    if (!(whole > 0))
        return;
    const double mean = magnitudes / whole, rms = std::sqrt(squares / whole);
    const auto &largest =
        *std::max_element(offsets.begin(), offsets.end(), [](const Offset &a, const Offset &b) {
            return std::abs(a.valueM) - 2 * a.ownM < std::abs(b.valueM) - 2 * b.ownM;
        });
    const double sigmaMean =
        sigmaOfValue(offsets, whole, [](const Offset &offset) { return offset.valueM < 0 ? -1.0 : 1.0; });
    const double sigmaRms = sigmaOfValue(
        offsets, whole, [rms](const Offset &offset) { return rms > 0 ? offset.valueM / rms : 0.0; });
    const double sigmaBias = sigmaOfValue(offsets, whole, [](const Offset &) { return 1.0; });
    const auto add = [&](const char *name, double valueM, double sigmaM) {
        metrics.push_back({name, "mm", toMillimetres(valueM), toMillimetres(sigmaM)});
    };
    add("cross_track_mean", mean, std::hypot(sigmaMean, folded / whole - mean));
    add("cross_track_rms", rms,
        std::hypot(sigmaRms, rms - std::sqrt(std::max(0.0, (squares - noise) / whole))));
    add("cross_track_max", std::abs(largest.valueM), sigmaOfLargest(offsets, largest));
    add("cross_track_bias", sum / whole, sigmaBias);
}

/// instants: those of the samples and points.
void addPath(std::vector<Metric> &metrics, const ReferencePath &path, const std::vector<RunInstant> &instants,
             const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    const std::vector<PathPosition> followed = followPath(path, positions);
    addOffsets(metrics, offsetsOf(instants, followed, positions));
    metrics.push_back({"path_completed", "1", completedShare(path, followed), std::nullopt});
}

/// The robot may have passed a gate in a gap: a lap that spans one may be more than one lap.
bool hasGap(const Lap &lap, const std::vector<TimeSpan> &gaps)
{
    const Nanoseconds end = lap.start + fromSeconds(lap.timeS);
    return std::ranges::any_of(gaps,
                               [&](const TimeSpan &gap) { return gap.begin < end && lap.start < gap.end; });
}

void addTimes(std::vector<Metric> &metrics, const Task &task, const std::vector<GatePassage> &passages,
              const std::vector<TimeSpan> &gaps)
{
    std::vector<Lap> laps = lapsOf(passages);
    const bool oneGate = std::any_of(task.gates.begin(), task.gates.end(),
                                     [](const Gate &gate) { return gate.role == GateRole::StartFinish; });
    if (!oneGate) {
        if (!laps.empty())
            metrics.push_back({"gate_time", "s", laps.front().timeS, laps.front().sigmaS});
        return;
    }
    metrics.push_back({"laps", "1", static_cast<double>(laps.size()), std::nullopt});
    std::erase_if(laps, [&](const Lap &lap) { return hasGap(lap, gaps); });
    if (laps.empty())
        return;
    const Lap &best = *std::min_element(laps.begin(), laps.end(),
                                        [](const Lap &a, const Lap &b) { return a.timeS < b.timeS; });
    metrics.push_back({"best_lap", "s", best.timeS, best.sigmaS});
    // The laps follow one another, so that their sum is as sure as one of them.
    double sum = 0, sigma = 0;
    for (const Lap &lap : laps) {
        sum += lap.timeS;
        sigma = std::max(sigma, lap.sigmaS);
    }
    const auto count = static_cast<double>(laps.size());
    metrics.push_back({"mean_lap", "s", sum / count, sigma / count});
}

} // namespace

TaskMetrics measureTask(const Task &task, const std::vector<Sample> &samples,
                        const std::vector<ProfilePoint> &points)
{
    TaskMetrics result;
    result.passages = findPassages(task.gates, samples, points);
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const std::vector<TimeSpan> gaps = gapsBetween(instants);
    addTimes(result.metrics, task, result.passages, gaps);
    if (!task.path.points.empty())
        addPath(result.metrics, task.path, instants, samples, points);
    const std::vector<Metric> zones = measureZones(task.zones, samples, points);
    result.metrics.insert(result.metrics.end(), zones.begin(), zones.end());
    markLowerBounds(result.metrics, gaps);
    return result;
}

namespace {

using Eigen::Vector2d;

constexpr double sigmasToBreach = sureSigmas;
constexpr double leastDepthM = 0.0005;

/// The point of a zone's outline that is nearest.
Vector2d nearestOnEdge(const Zone &zone, const Vector2d &point)
{
    Vector2d nearest = zone.corners.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const Vector2d &from = zone.corners[i], along = zone.corners[(i + 1) % zone.corners.size()] - from;
        const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vector2d here = from + share * along;
        if (const double distance = (point - here).squaredNorm(); distance < least) {
            least = distance;
            nearest = here;
        }
    }
    return nearest;
}

/// By the edges that a ray to the right crosses (Shimrat 1962).
bool isWithin(const Zone &zone, const Vector2d &point)
{
    bool within = false;
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const Vector2d &a = zone.corners[i], &b = zone.corners[(i + 1) % zone.corners.size()];
        if ((a.y() > point.y()) == (b.y() > point.y()))
            continue;
        if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            within = !within;
    }
    return within;
}

/// How a position of the track relates to a zone's rule.
struct Standing
{
    double timeS = 0;
    double beyondM = 0;           ///< above zero: the rule is broken by so much
    double ownM = 0, commonM = 0; ///< σ across the nearest edge
    bool joined = false;
};

std::vector<Standing> standingsOf(const Zone &zone, const std::vector<MeasuredPosition> &positions)
{
    std::vector<Standing> standings;
    for (const MeasuredPosition &position : positions) {
        const Vector2d &point = position.point->position;
        const Vector2d across = point - nearestOnEdge(zone, point);
        const double depth = isWithin(zone, point) ? across.norm() : -across.norm();
        const Vector2d direction = across.norm() > 0 ? Vector2d(across.normalized()) : Vector2d(1, 0);
        standings.push_back({position.timeS, zone.rule == ZoneRule::StayOutside ? depth : -depth,
                             sigmaAlong(position.own, direction), sigmaAlong(position.common, direction),
                             position.joined});
    }
    return standings;
}

/// A stretch beyond a shifted edge.
struct Stretch
{
    double fromS = 0, toS = 0;
    std::size_t deepest = 0;
    double beginVariance = 0, endVariance = 0; ///< s², of its two moments by the track's own noise
    bool sure = false;
};

/// The moment between two standings at which the shifted edge is crossed, and its variance.
double edgeCrossing(const Standing &a, const Standing &b, double shiftM, double &variance)
{
    const double rise = b.beyondM - a.beyondM, share = (shiftM - a.beyondM) / rise;
    const double step = b.timeS - a.timeS;
    const double ownM = (1 - share) * a.ownM + share * b.ownM;
    // A track that touches the edge without speed across it is not known to better than the frames around,
    // times a few.
    const double sigmaS = std::min(ownM * step / std::abs(rise), 10 * step);
    variance = sigmaS * sigmaS;
    return a.timeS + share * step;
}

/// How far beyond an edge is surely beyond it.
double sureDepthM(const Standing &standing)
{
    return std::max(leastDepthM, sigmasToBreach * standing.ownM);
}

/// Where the track is beyond an edge that lies by shift further out. A stretch ends where the robot surely is
/// back: a robot that is parked on the edge, to and fro by noise, breaks the rule once.
std::vector<Stretch> stretchesBeyond(const std::vector<Standing> &standings, double shiftM)
{
    std::vector<Stretch> stretches;
    std::optional<Stretch> open;
    bool isWithin = false; // it may have come back from the open one
    const auto close = [&] {
        if (open->sure)
            stretches.push_back(*open);
        open.reset();
    };
    for (std::size_t i = 0; i < standings.size(); ++i) {
        const Standing &here = standings[i];
        const double beyondM = here.beyondM - shiftM;
        const Standing *before = i > 0 && here.joined ? &standings[i - 1] : nullptr;
        if (open && !before) {
            if (!isWithin)
                open->toS = standings[i - 1].timeS;
            close();
        }
        if (beyondM > 0 && !open) {
            open = Stretch{here.timeS, here.timeS, i};
            if (before)
                open->fromS = edgeCrossing(*before, here, shiftM, open->beginVariance);
        } else if (beyondM <= 0 && open && !isWithin) {
            open->toS = edgeCrossing(*before, here, shiftM, open->endVariance);
        }
        isWithin = beyondM <= 0;
        if (!open)
            continue;
        if (here.beyondM > standings[open->deepest].beyondM)
            open->deepest = i;
        open->sure = open->sure || beyondM > sureDepthM(here);
        if (beyondM < -sureDepthM(here))
            close();
    }
    if (open) {
        if (!isWithin)
            open->toS = standings.back().timeS;
        close();
    }
    return stretches;
}

double timeOf(const std::vector<Stretch> &stretches)
{
    double time = 0;
    for (const Stretch &stretch : stretches)
        time += stretch.toS - stretch.fromS;
    return time;
}

double commonSigmaM(const std::vector<Standing> &standings)
{
    double largest = 0;
    for (const Standing &standing : standings)
        largest = std::max(largest, standing.commonM);
    return largest;
}

/// The track's own, where the robot may be on the edge.
double ownSigmaM(const std::vector<Standing> &standings)
{
    double largest = 0;
    for (const Standing &standing : standings)
        if (std::abs(standing.beyondM) <= sigmasToBreach * standing.ownM)
            largest = std::max(largest, standing.ownM);
    return largest;
}

/// By how much the time changes, to either side, when the edge is shifted.
double changeOfTime(const std::vector<Standing> &standings, double shiftM)
{
    return std::abs(timeOf(stretchesBeyond(standings, -shiftM)) -
                    timeOf(stretchesBeyond(standings, shiftM))) /
           2;
}

} // namespace

double depthWithin(const Zone &zone, const Vector2d &point)
{
    const double distance = (point - nearestOnEdge(zone, point)).norm();
    return isWithin(zone, point) ? distance : -distance;
}

std::vector<ZoneBreach> findZoneBreaches(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                         const std::vector<ProfilePoint> &points)
{
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    std::vector<ZoneBreach> breaches;
    for (const Zone &zone : zones) {
        const std::vector<Standing> standings = standingsOf(zone, positions);
        for (const Stretch &stretch : stretchesBeyond(standings, 0)) {
            const Standing &deepest = standings[stretch.deepest];
            breaches.push_back({zone.name, fromSeconds(stretch.fromS), fromSeconds(stretch.toS),
                                fromSeconds(deepest.timeS), deepest.beyondM,
                                std::hypot(deepest.ownM, deepest.commonM)});
        }
    }
    std::ranges::stable_sort(breaches, {}, &ZoneBreach::from);
    return breaches;
}

std::vector<Metric> measureZones(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                 const std::vector<ProfilePoint> &points)
{
    if (zones.empty())
        return {};
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    std::size_t count = 0;
    double timeS = 0, ends = 0, common = 0;
    for (const Zone &zone : zones) {
        const std::vector<Standing> standings = standingsOf(zone, positions);
        const std::vector<Stretch> stretches = stretchesBeyond(standings, 0);
        count += stretches.size();
        timeS += timeOf(stretches);
        double crossings = 0, variance = 0;
        for (const Stretch &stretch : stretches) {
            crossings += (stretch.beginVariance > 0) + (stretch.endVariance > 0);
            variance += stretch.beginVariance + stretch.endVariance;
        }
        // Of a robot that is parked on an edge its crossings say too little.
        ends += std::max(variance, std::pow(changeOfTime(standings, ownSigmaM(standings)), 2) /
                                       std::max(1.0, crossings));
        // One calibration shifts the track against all zones: their parts go together.
        common += changeOfTime(standings, commonSigmaM(standings));
    }
    const std::vector<ZoneBreach> breaches = findZoneBreaches(zones, samples, points);
    const auto deepest = std::ranges::max_element(breaches, {}, &ZoneBreach::depthM);
    const bool any = deepest != breaches.end();
    return {{"zone_breaches", "1", double(count), {}},
            {"zone_time", "s", timeS, std::hypot(std::sqrt(ends), common)},
            {"zone_depth", "mm", any ? toMillimetres(deepest->depthM) : 0,
             any ? std::optional(toMillimetres(deepest->sigmaDepthM)) : std::nullopt}};
}

} // namespace odo
