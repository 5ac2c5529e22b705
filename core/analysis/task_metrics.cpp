// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_metrics.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/internal/path_following.h"
#include "core/analysis/internal/zone_stretches.h"
#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"

#include <algorithm>
#include <cmath>
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

ZoneSide forbiddenSide(const Zone &zone)
{
    return zone.rule == ZoneRule::StayOutside ? ZoneSide::Inside : ZoneSide::Outside;
}

} // namespace

double depthWithin(const Zone &zone, const Eigen::Vector2d &point)
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
        const std::vector<Standing> standings = standingsOf(zone, forbiddenSide(zone), positions);
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
        const std::vector<Standing> standings = standingsOf(zone, forbiddenSide(zone), positions);
        const std::vector<Stretch> stretches = stretchesBeyond(standings, 0);
        count += stretches.size();
        timeS += timeOf(stretches);
        const StretchTimeSigma sigma = sigmaOfTime(standings, stretches);
        ends += sigma.ownVariance;
        // One calibration shifts the track against all zones: their parts go together.
        common += sigma.commonS;
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
