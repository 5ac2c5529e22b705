// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/contradiction.h"

#include "core/base/units.h"
#include "core/base/upper_median.h"
#include "core/trajectory/track_profile.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace odo {

namespace {

constexpr Nanoseconds reach = std::chrono::seconds(1); // to both sides of a time
constexpr std::size_t fewestTimes = 10;                // in it, that tell anything
constexpr double leastContradiction = 13.82;           // of χ²(2): 99.9 %

/// Two views' places at a time of both.
struct Difference
{
    std::size_t index = 0; ///< of the time
    Nanoseconds time{0};
    double chiSquared = 0, apartM = 0;
};

Eigen::Matrix2d covarianceOf(const Sighting &sighting)
{
    return sighting.place.pixelCovariance + sighting.place.calibrationCovariance;
}

std::vector<Difference> differencesOf(const std::vector<Sighting> &a, const std::vector<Sighting> &b)
{
    std::vector<Difference> differences;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (!a[i].seen || !b[i].seen || a[i].cut || b[i].cut)
            continue;
        const Eigen::Vector2d apart = a[i].place.pointInWorld - b[i].place.pointInWorld;
        const Eigen::Matrix2d covariance = covarianceOf(a[i]) + covarianceOf(b[i]);
        differences.push_back({i, a[i].time, apart.dot(covariance.inverse() * apart), apart.norm()});
    }
    return differences;
}

/// At each time of a pair of views, by how much their variances are too small; 1: by nothing, or it isn't known.
std::vector<double> factorsOf(const std::vector<Sighting> &a, const std::vector<Sighting> &b)
{
    const std::vector<Difference> differences = differencesOf(a, b);
    std::vector<double> factors(a.size(), 1);
    std::size_t begin = 0, end = 0;
    std::vector<double> chiSquared, apartM;
    for (const Difference &here : differences) {
        while (differences[begin].time < here.time - reach)
            ++begin;
        while (end < differences.size() && differences[end].time <= here.time + reach)
            ++end;
        if (end - begin < fewestTimes)
            continue;
        chiSquared.clear();
        apartM.clear();
        for (std::size_t i = begin; i < end; ++i) {
            chiSquared.push_back(differences[i].chiSquared);
            apartM.push_back(differences[i].apartM);
        }
        const double median = upperMedian(chiSquared);
        if (median > leastContradiction && upperMedian(apartM) < farApartM)
            factors[here.index] = median / 2;
    }
    return factors;
}

} // namespace

std::vector<bool> widenByContradiction(std::vector<std::vector<Sighting>> &views)
{
    if (views.empty())
        return {};
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const std::size_t times = views.front().size();
    std::vector<std::vector<double>> least(views.size(), std::vector<double>(times, unknown)); // of a view's pairs
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            const std::vector<double> factors = factorsOf(views[a], views[b]);
            for (std::size_t i = 0; i < times; ++i) {
                if (!views[a][i].seen || !views[b][i].seen)
                    continue;
                least[a][i] = std::min(least[a][i], factors[i]);
                least[b][i] = std::min(least[b][i], factors[i]);
            }
        }
    }
    std::vector<bool> isContradicted(times);
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t i = 0; i < times; ++i) {
            if (least[v][i] == unknown || least[v][i] <= 1)
                continue;
            isContradicted[i] = true;
            views[v][i].place.calibrationCovariance += (least[v][i] - 1) * covarianceOf(views[v][i]);
        }
    }
    return isContradicted;
}

void flagContradictions(FusedTrack &track, const std::vector<bool> &isContradicted)
{
    for (std::size_t i = 0; i < isContradicted.size(); ++i) {
        if (!isContradicted[i] || !track.samples[i].viewDisagreementM)
            continue;
        track.evidence[i].isContradicted = true;
        track.samples[i].flags |= flagBit(SampleFlag::ViewsDisagree);
    }
}

Result<void> checkAgreement(const std::vector<Sample> &samples)
{
    constexpr double leastUsed = 0.1; // of those that several views saw
    std::size_t seen = 0, used = 0;
    std::vector<double> apartM;
    for (const Sample &sample : samples) {
        if (!sample.viewDisagreementM)
            continue;
        ++seen;
        used += isUsed(sample);
        if (hasFlag(sample.flags, SampleFlag::ViewsDisagree))
            apartM.push_back(*sample.viewDisagreementM);
    }
    if (2 * apartM.size() < seen || double(used) >= leastUsed * double(seen) || apartM.empty())
        return {};
    return fail(ErrorCode::Undetermined, cannotMeasurePath,
                "the views put it " + formatNumber(1000 * upperMedian(std::move(apartM)), 0) +
                    " mm apart: a camera was moved after it was registered, the videos belong to other cameras, or one view follows something else",
                "look at the outlines, and register the cameras again");
}

} // namespace odo
