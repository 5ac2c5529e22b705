// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_disagreement.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

/// Each registered view's sightings at the samples' times.
std::vector<std::vector<Sighting>> sightingsOf(const Profile &profile, const std::vector<ViewTrack> &views)
{
    std::vector<Nanoseconds> times;
    for (const Sample &sample : profile.samples)
        times.push_back(sample.time);
    std::vector<std::vector<Sighting>> all;
    for (const ViewTrack &view : views)
        if (view.floorView)
            all.push_back(sightingsAt(times, positionObservations(view, silhouettePlaneM(profile.heightM))));
    return all;
}

/// The two largest variances of the views that saw the robot there, m²; 0: fewer than two.
double expectedSquare(const std::vector<std::vector<Sighting>> &views, std::size_t sample)
{
    double largest = 0, second = 0;
    for (const std::vector<Sighting> &view : views) {
        const Sighting &sighting = view[sample];
        if (!sighting.seen)
            continue;
        const double variance = totalCovariance(sighting.position).trace();
        second = std::max(second, std::min(largest, variance));
        largest = std::max(largest, variance);
    }
    return second > 0 ? largest + second : 0;
}

void count(ViewDisagreement &result)
{
    if (result.positions.empty())
        return;
    std::vector<double> apart;
    double squares = 0, expected = 0;
    for (const Disagreement &position : result.positions) {
        apart.push_back(position.apartM);
        squares += position.apartM * position.apartM;
        expected += position.expectedM * position.expectedM;
    }
    const auto number = static_cast<double>(apart.size());
    result.rmsM = std::sqrt(squares / number);
    result.expectedRmsM = std::sqrt(expected / number);
    std::sort(apart.begin(), apart.end());
    result.medianM = (apart[(apart.size() - 1) / 2] + apart[apart.size() / 2]) / 2;
    result.largestM = apart.back();
}

} // namespace

ViewDisagreement disagreementOf(const Profile &profile, const std::vector<ViewTrack> &views,
                                double stepSigmaS)
{
    ViewDisagreement result;
    const auto sightings = sightingsOf(profile, views);
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const Sample &sample = profile.samples[i];
        const double square = expectedSquare(sightings, i);
        if (!sample.viewDisagreementM || !sample.position || isRejected(sample.flags) || square <= 0)
            continue;
        const double step = profile.points[i].valid ? profile.points[i].speedMps * stepSigmaS : 0;
        result.positions.push_back(
            {sample.time, *sample.position, *sample.viewDisagreementM, std::sqrt(square + step * step)});
    }
    count(result);
    return result;
}

namespace {

constexpr Nanoseconds reach = std::chrono::seconds(1); // to both sides of a time
constexpr std::size_t fewestTimes = 10;                // in it, for a result
constexpr double leastContradiction = 13.82;           // of χ²(2): 99.9 %
// (4.303 / 1.960)²: what lasts is one draw, of two degrees of freedom
constexpr double studentFactor2 = 4.82;

/// Two views' positions at a common time.
struct Difference
{
    std::size_t index = 0; ///< of the time
    Nanoseconds time{0};
    double chiSquared = 0, apartM = 0;
};

std::vector<Difference> differencesOf(const std::vector<Sighting> &a, const std::vector<Sighting> &b)
{
    std::vector<Difference> differences;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (!a[i].seen || !b[i].seen || a[i].cut || b[i].cut)
            continue;
        const Eigen::Vector2d apart = a[i].position.pointInWorld - b[i].position.pointInWorld;
        const Eigen::Matrix2d covariance = totalCovariance(a[i].position) + totalCovariance(b[i].position);
        differences.push_back({i, a[i].time, apart.dot(covariance.inverse() * apart), apart.norm()});
    }
    return differences;
}

/// What is found of a pair of views at a time that both saw.
struct PairFinding
{
    bool isSeen = false;
    /// by which their variances are too small; 1: by nothing, or it isn't known
    double factor = 1, apartM = 0;
};

std::vector<PairFinding> findingsOf(const std::vector<Sighting> &a, const std::vector<Sighting> &b)
{
    const std::vector<Difference> differences = differencesOf(a, b);
    std::vector<PairFinding> findings(a.size());
    std::size_t begin = 0, end = 0;
    std::vector<double> chiSquared, apartM;
    for (const Difference &here : differences) {
        while (differences[begin].time < here.time - reach)
            ++begin;
        while (end < differences.size() && differences[end].time <= here.time + reach)
            ++end;
        findings[here.index].isSeen = true;
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
            findings[here.index] = {true, studentFactor2 * median / 2, here.apartM};
    }
    return findings;
}

struct ViewPair
{
    std::size_t a = 0, b = 0;
    std::vector<PairFinding> findings; ///< at each time
};

/// Widens or leaves out what contradicts at one time; gives how far apart it is.
double settleAt(std::size_t i, const std::vector<ViewPair> &pairs, std::vector<std::vector<Sighting>> &views)
{
    double apartM = 0;
    bool doAnyAgree = false;
    std::vector<double> least(views.size(), 0); // factor of a view's pairs; 0: no other saw it
    for (const ViewPair &pair : pairs) {
        const PairFinding &finding = pair.findings[i];
        if (!finding.isSeen)
            continue;
        apartM = std::max(apartM, finding.factor > 1 ? finding.apartM : 0);
        doAnyAgree |= finding.factor == 1;
        for (const std::size_t view : {pair.a, pair.b})
            least[view] = least[view] == 0 ? finding.factor : std::min(least[view], finding.factor);
    }
    for (std::size_t v = 0; apartM > 0 && v < views.size(); ++v) {
        Sighting &sighting = views[v][i];
        if (least[v] <= 1)
            continue;
        if (doAnyAgree)
            sighting.seen = false;
        else
            sighting.position.calibrationCovariance += (least[v] - 1) * totalCovariance(sighting.position);
    }
    return apartM;
}

} // namespace

std::vector<double> settleContradictions(std::vector<std::vector<Sighting>> &views)
{
    std::vector<ViewPair> pairs;
    for (std::size_t a = 0; a < views.size(); ++a)
        for (std::size_t b = a + 1; b < views.size(); ++b)
            pairs.push_back({a, b, findingsOf(views[a], views[b])});
    std::vector<double> apartM(views.empty() ? 0 : views.front().size());
    for (std::size_t i = 0; i < apartM.size(); ++i)
        apartM[i] = settleAt(i, pairs, views);
    return apartM;
}

void flagContradictions(FusedTrack &track, const std::vector<double> &apartM)
{
    for (std::size_t i = 0; i < apartM.size(); ++i) {
        Sample &sample = track.samples[i];
        if (apartM[i] == 0)
            continue;
        track.evidence[i].isContradicted = true;
        sample.flags |= flagBit(SampleFlag::ViewsDisagree);
        sample.viewDisagreementM = std::max(sample.viewDisagreementM.value_or(0), apartM[i]);
    }
}

ViewsApart viewsApart(const std::vector<Sample> &samples)
{
    ViewsApart found;
    for (const Sample &sample : samples) {
        if (!sample.viewDisagreementM)
            continue;
        ++found.seen;
        found.used += isUsed(sample);
        if (hasFlag(sample.flags, SampleFlag::ViewsDisagree))
            found.apartM.push_back(*sample.viewDisagreementM);
    }
    return found;
}

Result<void> checkAgreement(const std::vector<Sample> &samples)
{
    constexpr double leastUsed = 0.1; // of those that several views saw
    ViewsApart found = viewsApart(samples);
    if (2 * found.apartM.size() < found.seen || double(found.used) >= leastUsed * double(found.seen) ||
        found.apartM.empty())
        return {};
    return fail(
        ErrorCode::Undetermined, cannotMeasurePath(),
        joined({ODO_TEXT("trajectory.views_apart", "the views' floor positions differ by %1")(
                    quantity(toMillimetres(upperMedian(std::move(found.apartM))), 0, "mm")),
                ODO_TEXT("trajectory.why_views_apart",
                         "a camera has moved since it was registered, the videos belong to other cameras, or "
                         "one view follows something else")},
               Join::Colon),
        ODO_TEXT("trajectory.look_and_register", "check the outlines, and register the cameras again"));
}

namespace {

constexpr double sureScore = 0.3;
constexpr double usualSlowShare = 0.8, usualSlowLengthM = 0.1;
constexpr double mostSlowShare = 0.98, leastNoiseScale = 0.1, mostScale = 100;
constexpr std::size_t binCount = 16;
constexpr double longestPathM = 0.4;
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
        const Eigen::LLT<Eigen::Matrix2d> root(a[i].position.pixelCovariance + b[i].position.pixelCovariance);
        found.push_back(
            {travel[i], root.matrixL().solve(a[i].position.pointInWorld - b[i].position.pointInWorld)});
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
                const double pathM = series[j].travelM - series[i].travelM;
                if (pathM >= longestPathM)
                    break;
                const double squared = (series[j].whitened - series[i].whitened).squaredNorm();
                if (squared > mostChange)
                    continue;
                const auto bin = static_cast<std::size_t>(pathM / longestPathM * binCount);
                way[bin] += pathM;
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
                return (view[behind].position.pointInWorld - view[before].position.pointInWorld).norm() /
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

constexpr double leastTrimmed = 0.4;      // share of the outlines
constexpr double scoreOfWhole = 0.25;     // too little to learn from, enough to be measured by
constexpr double uncertaintyRadii = 0.08; // of where the outline's middle is

} // namespace

void uncertaintyUntrimmed(const std::vector<std::vector<Observation> *> &views)
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
            const double uncertaintyPx2 = uncertaintyRadii * uncertaintyRadii * one.areaPx / std::numbers::pi;
            one.score = std::min(one.score, scoreOfWhole);
            one.centreCovariancePx2 += Eigen::Matrix2d::Identity() * uncertaintyPx2;
        }
    }
}

} // namespace odo
