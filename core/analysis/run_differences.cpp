// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/run_differences.h"

#include "core/analysis/metric_table.h"
#include "core/analysis/metrics.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double shortestM = 0.01;

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The part of the first segment at which the second one cuts it.
std::optional<double> cutOf(const Eigen::Vector2d &from, const Eigen::Vector2d &to, const Gate &gate)
{
    const Eigen::Vector2d way = to - from, line = gate.to - gate.from, apart = gate.from - from;
    const double area = cross(way, line);
    if (area == 0)
        return std::nullopt;
    const double part = cross(apart, line) / area, across = cross(apart, way) / area;
    return part >= 0 && part <= 1 && across >= 0 && across <= 1 ? std::optional(part) : std::nullopt;
}

/// A boundary of sectors: a gate in one lap, or an end of the common stretch.
struct Boundary
{
    std::string name;
    double pathM = 0;
};

/// The last way at which the first run can be compared with another one.
double commonEnd(const RunComparison &comparison)
{
    for (std::size_t station = comparison.distancesM.size(); station-- > 0;)
        for (std::size_t run = 1; run < comparison.runs.size(); ++run)
            if (comparison.timeDifference(run, station))
                return comparison.distancesM[station];
    return comparison.originM;
}

std::vector<Boundary> boundariesOf(const RunComparison &comparison, const std::vector<PathGate> &gates)
{
    const double beginM = comparison.originM, endM = commonEnd(comparison),
                 lengthM = lengthOf(comparison.path);
    std::vector<Boundary> boundaries;
    for (const PathGate &gate : gates) {
        double pathM = gate.stationM;
        if (comparison.path.closed)
            pathM += lengthM * std::ceil((beginM - shortestM - pathM) / lengthM);
        for (; pathM <= endM + shortestM; pathM += lengthM) {
            if (pathM >= beginM - shortestM)
                boundaries.push_back({gate.name, std::clamp(pathM, beginM, endM)});
            if (!comparison.path.closed)
                break;
        }
    }
    std::ranges::stable_sort(boundaries, {}, &Boundary::pathM);
    if (boundaries.empty() || boundaries.front().pathM > beginM + shortestM)
        boundaries.insert(boundaries.begin(), {std::string(), beginM});
    if (boundaries.back().pathM < endM - shortestM)
        boundaries.push_back({std::string(), endM});
    return boundaries;
}

/// The time between two arrivals of one run.
Difference timeBetween(const Arrival &from, const Arrival &to)
{
    return {to.timeS - from.timeS, std::hypot(from.sigmaS(), to.sigmaS())};
}

/// How much longer b takes than a; at each end a displacement of the position counts once if it is shared.
Difference longer(const Arrival &fromA, const Arrival &toA, const Arrival &fromB, const Arrival &toB,
                  bool isShared)
{
    const auto common = [isShared](const Arrival &a, const Arrival &b) {
        return isShared ? b.commonSigmaS - a.commonSigmaS : std::hypot(a.commonSigmaS, b.commonSigmaS);
    };
    const double own =
        std::hypot(std::hypot(fromA.ownSigmaS, toA.ownSigmaS), std::hypot(fromB.ownSigmaS, toB.ownSigmaS));
    return {(toB.timeS - fromB.timeS) - (toA.timeS - fromA.timeS),
            std::hypot(own, std::hypot(common(fromA, fromB), common(toA, toB)))};
}

SectorTimes sectorBetween(const RunComparison &comparison, const Boundary &from, const Boundary &to)
{
    SectorTimes sector{from.name, to.name, from.pathM, to.pathM, {}, {}};
    const auto firstFrom = comparison.runs.front().arrivals.at(from.pathM),
               firstTo = comparison.runs.front().arrivals.at(to.pathM);
    for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
        const FirstArrivals &arrivals = comparison.runs[run].arrivals;
        const auto begin = arrivals.at(from.pathM), end = arrivals.at(to.pathM);
        const bool isKnown = begin && end, isFirstKnown = firstFrom && firstTo;
        sector.times.push_back(isKnown ? std::optional(timeBetween(*begin, *end)) : std::nullopt);
        sector.differences.push_back(
            run > 0 && isKnown && isFirstKnown
                ? std::optional(longer(*firstFrom, *firstTo, *begin, *end, comparison.shareCalibration))
                : std::nullopt);
    }
    return sector;
}

} // namespace

std::vector<PathGate> gatesOnPath(const ReferencePath &path, const std::vector<Gate> &gates)
{
    std::vector<PathGate> cuts;
    const std::size_t count = path.points.size();
    for (const Gate &gate : gates) {
        double stationM = 0;
        for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
            const Eigen::Vector2d &from = path.points[i], &to = path.points[(i + 1) % count];
            if (const auto part = cutOf(from, to, gate)) {
                cuts.push_back({gate.name, stationM + *part * (to - from).norm()});
                break;
            }
            stationM += (to - from).norm();
        }
    }
    std::ranges::stable_sort(cuts, {}, &PathGate::stationM);
    return cuts;
}

std::vector<PathGate> thirdsOf(const RunComparison &comparison)
{
    const double lengthM = lengthOf(comparison.path), beginM = comparison.originM;
    const double wholeM = comparison.path.closed ? lengthM : commonEnd(comparison) - beginM;
    std::vector<PathGate> gates;
    for (int i = 1; i <= 2; ++i) {
        const double pathM = beginM + i * wholeM / 3;
        gates.push_back({"Gate " + std::to_string(i),
                         comparison.path.closed ? pathM - lengthM * std::floor(pathM / lengthM) : pathM});
    }
    return gates;
}

PathPoint pointAt(const ReferencePath &path, double pathM)
{
    const std::size_t count = path.points.size();
    if (path.closed) {
        const double lengthM = lengthOf(path);
        pathM -= lengthM * std::floor(pathM / lengthM);
    }
    PathPoint point{path.points.front(), Eigen::Vector2d::UnitX()};
    double stationM = 0;
    for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
        const Eigen::Vector2d way = path.points[(i + 1) % count] - path.points[i];
        const double pieceM = way.norm();
        if (pieceM <= 0)
            continue;
        point.direction = way / pieceM;
        point.position = path.points[i] + std::clamp(pathM - stationM, 0.0, pieceM) * point.direction;
        stationM += pieceM;
        if (pathM <= stationM)
            break;
    }
    return point;
}

std::vector<SectorTimes> sectorTimes(const RunComparison &comparison, const std::vector<PathGate> &gates)
{
    const std::vector<Boundary> boundaries = boundariesOf(comparison, gates);
    std::vector<SectorTimes> sectors;
    for (std::size_t i = 1; i < boundaries.size(); ++i)
        if (boundaries[i].pathM - boundaries[i - 1].pathM >= shortestM)
            sectors.push_back(sectorBetween(comparison, boundaries[i - 1], boundaries[i]));
    return sectors;
}

namespace {

bool isOfTask(const std::string &name)
{
    const MetricKind *kind = metricKind(name);
    return kind && kind->isOfTask();
}

/// Whether a calibration's scale uncertainty is part of its σ.
bool hasScale(const std::string &unit)
{
    return unit == "m" || unit == "m/s" || unit == "m/s²";
}

double sigmaOf(const Metric &metric)
{
    if (metric.sigma)
        return *metric.sigma;
    return metric.name == "path_completed" ? completedResolution : 0;
}

Difference differenceOf(const Metric &a, double scaleA, const Metric &b, double scaleB, bool shareCalibration)
{
    const double sigma = std::hypot(sigmaOf(a), sigmaOf(b));
    if (!shareCalibration || !hasScale(a.unit))
        return {b.value - a.value, sigma};
    const double commonA = scaleA * a.value, commonB = scaleB * b.value;
    const double own = std::max(0.0, sigma * sigma - commonA * commonA - commonB * commonB);
    return {b.value - a.value, std::sqrt(own + std::pow(commonB - commonA, 2))};
}

} // namespace

std::vector<MetricDifference> metricDifferences(const Profile &a, const Profile &b, bool shareCalibration,
                                                bool sameTask)
{
    const double scaleA = sigmaOfScale(a.samples, a.points), scaleB = sigmaOfScale(b.samples, b.points);
    std::vector<MetricDifference> differences;
    for (const Metric &metric : a.metrics) {
        if (!sameTask && isOfTask(metric.name))
            continue;
        MetricDifference line{metric.name,  metric.unit,  metric.value, std::nullopt,
                              metric.sigma, std::nullopt, std::nullopt, metric.isAtLeast};
        if (const auto other = std::ranges::find(b.metrics, metric.name, &Metric::name);
            other != b.metrics.end()) {
            line.b = other->value;
            line.sigmaB = other->sigma;
            line.isAtLeastB = other->isAtLeast;
            if (!line.isAtLeastA && !line.isAtLeastB)
                line.difference = differenceOf(metric, scaleA, *other, scaleB, shareCalibration);
        }
        differences.push_back(std::move(line));
    }
    for (const Metric &metric : b.metrics)
        if ((sameTask || !isOfTask(metric.name)) &&
            std::ranges::find(a.metrics, metric.name, &Metric::name) == a.metrics.end())
            differences.push_back({metric.name, metric.unit, std::nullopt, metric.value, std::nullopt,
                                   metric.sigma, std::nullopt, false, metric.isAtLeast});
    return differences;
}

} // namespace odo
