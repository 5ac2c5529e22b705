// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/outline_doubt.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double sureScore = 0.3;
constexpr double usualSlowShare = 0.8, usualSlowLengthM = 0.1;
constexpr double mostSlowShare = 0.98, leastNoiseScale = 0.1, mostScale = 100;
constexpr std::size_t binCount = 16;
constexpr double longestWayM = 0.4;
constexpr std::size_t longestLag = 60; // sightings
constexpr double leastPairsInBin = 40; // in a bin
constexpr double outlier = 30;         // times the typical squared change: a false sighting
constexpr int stepReach = 2;           // sightings to either side that a step of the way is measured over
constexpr double trust = 200;          // innovations

/// The disagreement of two views at one time, whitened by its stated covariance.
struct WhitenedDisagreement
{
    double travelM = 0;
    Eigen::Vector2d whitened;
};

bool isSure(const Sighting &sighting)
{
    return sighting.seen && !sighting.cut && sighting.score >= sureScore;
}

std::vector<WhitenedDisagreement> disagreements(const std::vector<Sighting> &a,
                                                const std::vector<Sighting> &b,
                                                const std::vector<double> &travel)
{
    std::vector<WhitenedDisagreement> found;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (!isSure(a[i]) || !isSure(b[i]))
            continue;
        const Eigen::LLT<Eigen::Matrix2d> root(a[i].place.pixelCovariance + b[i].place.pixelCovariance);
        found.push_back({travel[i], root.matrixL().solve(a[i].place.pointInWorld - b[i].place.pointInWorld)});
    }
    return found;
}

/// Mean half squared change of one axis, by length of the way.
struct Variogram
{
    std::array<double, binCount> way{}, change{}, count{};

    void add(const std::vector<WhitenedDisagreement> &series, double mostChange)
    {
        for (std::size_t i = 0; i < series.size(); ++i) {
            for (std::size_t j = i + 1; j < std::min(series.size(), i + longestLag); ++j) {
                const double wayM = series[j].travelM - series[i].travelM;
                if (wayM >= longestWayM)
                    break;
                const double squared = (series[j].whitened - series[i].whitened).squaredNorm();
                if (squared > mostChange)
                    continue;
                const auto bin = static_cast<std::size_t>(wayM / longestWayM * binCount);
                way[bin] += wayM;
                change[bin] += squared / 4;
                count[bin] += 1;
            }
        }
    }
};

/// White and slow variance for one correlation length, by weighted least squares, and what remains.
struct NoiseFit
{
    double white = 0, slow = 0, lengthM = usualSlowLengthM, cost = HUGE_VAL;
};

NoiseFit fitAt(const Variogram &variogram, double lengthM)
{
    double n = 0, x = 0, xx = 0, y = 0, xy = 0, yy = 0;
    for (std::size_t bin = 0; bin < binCount; ++bin) {
        const double count = variogram.count[bin];
        if (count < leastPairsInBin)
            continue;
        const double rise = 1 - std::exp(-variogram.way[bin] / count / lengthM);
        const double value = variogram.change[bin] / count;
        n += 1, x += rise, xx += rise * rise, y += value, xy += rise * value, yy += value * value;
    }
    NoiseFit fit;
    fit.lengthM = lengthM;
    const double determinant = n * xx - x * x;
    if (n < 4 || !(determinant > 1e-9))
        return fit;
    fit.slow = (n * xy - x * y) / determinant;
    fit.white = (y - fit.slow * x) / n;
    if (fit.white < 0) {
        fit.white = 0;
        fit.slow = xy / xx;
    }
    fit.slow = std::max(fit.slow, 0.0);
    fit.cost = yy - 2 * fit.slow * xy - 2 * fit.white * y + 2 * fit.slow * fit.white * x +
               fit.slow * fit.slow * xx + n * fit.white * fit.white;
    return fit;
}

double typicalChange(const std::vector<WhitenedDisagreement> &series)
{
    std::vector<double> squared;
    for (std::size_t i = 8; i < series.size(); ++i)
        squared.push_back((series[i].whitened - series[i - 8].whitened).squaredNorm());
    if (squared.empty())
        return 0;
    return upperMedian(std::move(squared));
}

/// Length of the way up to each sighting's time, from the first view that saw the robot there: metres, over
/// five sightings each, so that pixel noise is no way. Times without a sighting continue from the last.
std::vector<double> travelOf(const std::vector<std::vector<Sighting>> &views)
{
    const std::size_t times = views.empty() ? 0 : views.front().size();
    std::vector<double> travel(times);
    const auto step = [&](std::size_t i) {
        const std::size_t before = i > stepReach ? i - stepReach : 0,
                          behind = std::min(times - 1, i + stepReach);
        for (const auto &view : views) {
            if (view[before].seen && view[behind].seen && behind > before)
                return (view[behind].place.pointInWorld - view[before].place.pointInWorld).norm() /
                       static_cast<double>(behind - before);
        }
        return 0.0;
    };
    for (std::size_t i = 1; i < times; ++i)
        travel[i] = travel[i - 1] + step(i);
    return travel;
}

} // namespace

MeasurementNoise estimateOutlineNoise(const std::vector<std::vector<Sighting>> &views)
{
    const std::vector<double> travel = travelOf(views);
    Variogram variogram;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            const auto series = disagreements(views[a], views[b], travel);
            variogram.add(series, outlier * typicalChange(series));
        }
    }
    NoiseFit best;
    for (double lengthM = 0.02; lengthM < 0.3; lengthM *= 1.25) {
        if (const NoiseFit fit = fitAt(variogram, lengthM); fit.cost < best.cost)
            best = fit;
    }
    MeasurementNoise noise{1, usualSlowShare, usualSlowLengthM};
    const double total = best.white + best.slow;
    if (!(total > 0) || best.cost == HUGE_VAL)
        return noise;
    noise.scale = std::clamp(total, leastNoiseScale, mostScale);
    noise.slowShare = std::min(best.slow / total, mostSlowShare);
    noise.slowLengthM = best.lengthM;
    noise.trust = trust;
    return noise;
}

namespace {

constexpr double leastTrimmed = 0.4;  // share of the outlines
constexpr double scoreOfWhole = 0.25; // too little to learn from, enough to be measured by
constexpr double doubtRadii = 0.08;   // of where the outline's middle is

} // namespace

void doubtUntrimmed(const std::vector<std::vector<Observation> *> &views)
{
    double trimmed = 0, all = 0;
    for (const auto *view : views) {
        for (const Observation &one : *view) {
            all += one.found ? 1 : 0;
            trimmed += one.found && one.isTrimmed ? 1 : 0;
        }
    }
    if (trimmed < leastTrimmed * all)
        return;
    for (auto *view : views) {
        for (Observation &one : *view) {
            if (!one.found || one.isTrimmed)
                continue;
            const double doubtPx2 = doubtRadii * doubtRadii * one.areaPx / std::numbers::pi;
            one.score = std::min(one.score, scoreOfWhole);
            one.centreCovariancePx2 += Eigen::Matrix2d::Identity() * doubtPx2;
        }
    }
}

} // namespace odo
