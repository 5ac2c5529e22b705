// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/task_metrics.h"

#include "core/trajectory/gate_passages.h"
#include "core/trajectory/motion_stretches.h"
#include "core/trajectory/path_following.h"
#include "core/trajectory/zone_breaches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

/// A distance from the path with its σ, and the way driven that it stands for.
struct Offset
{
    double valueM = 0, ownM = 0, commonM = 0;
    double wayM = 0;
    double togetherM = 0; ///< way along which the errors go together, at least its own
};

std::vector<Offset> offsetsOf(const std::vector<RunInstant> &instants, const std::vector<PathPlace> &followed,
                              const std::vector<MeasuredPlace> &places)
{
    std::vector<Offset> offsets;
    for (const MotionStretch &motion : findMotions(instants)) {
        for (std::size_t i = motion.first; i <= motion.last; ++i) {
            if (followed[i].beyondEnd)
                continue;
            const double from = instants[i == motion.first ? i : i - 1].timeS;
            const double to = instants[i == motion.last ? i : i + 1].timeS;
            const double speed = instants[i].point->speedMps;
            const double way = speed * std::max(0.0, to - from) / 2;
            offsets.push_back({followed[i].offsetM, sigmaAlong(places[i].own, followed[i].left),
                               sigmaAlong(places[i].common, followed[i].left), way,
                               std::max(way, speed * correlationTimeS(instants[i]))});
        }
    }
    return offsets;
}

/// σ of a figure that changes by slope(offset) · way / whole for a change of one offset.
template <class Slope>
double sigmaOfFigure(const std::vector<Offset> &offsets, double wholeM, const Slope &slope)
{
    double own = 0, common = 0;
    for (const Offset &offset : offsets) {
        const double weight = slope(offset) / wholeM;
        own += std::pow(weight * offset.ownM, 2) * offset.wayM * offset.togetherM;
        common += std::abs(weight) * offset.wayM * offset.commonM;
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
            rivals += offset.wayM / offset.togetherM;
    }
    const double chosen = largest.ownM * std::sqrt(2 * std::log(std::max(1.0, rivals)));
    return std::hypot(std::hypot(largest.ownM, chosen), largest.commonM);
}

void addOffsets(std::vector<Metric> &metrics, const std::vector<Offset> &offsets)
{
    double whole = 0, sum = 0, magnitudes = 0, squares = 0, noise = 0, folded = 0;
    for (const Offset &offset : offsets) {
        whole += offset.wayM;
        sum += offset.wayM * offset.valueM;
        magnitudes += offset.wayM * std::abs(offset.valueM);
        squares += offset.wayM * offset.valueM * offset.valueM;
        noise += offset.wayM * offset.ownM * offset.ownM;
        folded += offset.wayM * meanMagnitude(offset.valueM, offset.ownM);
    }
    if (!(whole > 0))
        return;
    const double mean = magnitudes / whole, rms = std::sqrt(squares / whole);
    const auto &largest = *std::max_element(offsets.begin(), offsets.end(), [](const Offset &a, const Offset &b) {
        return std::abs(a.valueM) - 2 * a.ownM < std::abs(b.valueM) - 2 * b.ownM;
    });
    const double sigmaMean =
        sigmaOfFigure(offsets, whole, [](const Offset &offset) { return offset.valueM < 0 ? -1.0 : 1.0; });
    const double sigmaRms =
        sigmaOfFigure(offsets, whole, [rms](const Offset &offset) { return rms > 0 ? offset.valueM / rms : 0.0; });
    const double sigmaBias = sigmaOfFigure(offsets, whole, [](const Offset &) { return 1.0; });
    const auto add = [&](const char *name, double valueM, double sigmaM) {
        metrics.push_back({name, "mm", toMillimetres(valueM), toMillimetres(sigmaM)});
    };
    add("cross_track_mean", mean, std::hypot(sigmaMean, folded / whole - mean));
    add("cross_track_rms", rms, std::hypot(sigmaRms, rms - std::sqrt(std::max(0.0, (squares - noise) / whole))));
    add("cross_track_max", std::abs(largest.valueM), sigmaOfLargest(offsets, largest));
    add("cross_track_bias", sum / whole, sigmaBias);
}

void addPath(std::vector<Metric> &metrics, const ReferencePath &path, const std::vector<Sample> &samples,
             const std::vector<ProfilePoint> &points)
{
    const std::vector<MeasuredPlace> places = measuredPlaces(samples, points);
    const std::vector<PathPlace> followed = followPath(path, places);
    addOffsets(metrics, offsetsOf(validInstants(samples, points), followed, places));
    metrics.push_back({"path_completed", "1", completedShare(path, followed), std::nullopt});
}

void addTimes(std::vector<Metric> &metrics, const Task &task, const std::vector<GatePassage> &passages)
{
    const std::vector<Lap> laps = lapsOf(passages);
    const bool oneGate = std::any_of(task.gates.begin(), task.gates.end(),
                                     [](const Gate &gate) { return gate.role == GateRole::StartFinish; });
    if (!oneGate) {
        if (!laps.empty())
            metrics.push_back({"gate_time", "s", laps.front().timeS, laps.front().sigmaS});
        return;
    }
    metrics.push_back({"laps", "1", static_cast<double>(laps.size()), std::nullopt});
    if (laps.empty())
        return;
    const Lap &best =
        *std::min_element(laps.begin(), laps.end(), [](const Lap &a, const Lap &b) { return a.timeS < b.timeS; });
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

TaskFigures measureTask(const Task &task, const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    TaskFigures figures;
    figures.passages = findPassages(task.gates, samples, points);
    addTimes(figures.metrics, task, figures.passages);
    if (!task.path.points.empty())
        addPath(figures.metrics, task.path, samples, points);
    const std::vector<Metric> zones = measureZones(task.zones, samples, points);
    figures.metrics.insert(figures.metrics.end(), zones.begin(), zones.end());
    return figures;
}

} // namespace odo
