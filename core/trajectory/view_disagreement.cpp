// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_disagreement.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

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
            all.push_back(sightingsAt(times, placeObservations(view, silhouettePlaneM(profile.heightM))));
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
        const double variance = totalCovariance(sighting.place).trace();
        second = std::max(second, std::min(largest, variance));
        largest = std::max(largest, variance);
    }
    return second > 0 ? largest + second : 0;
}

void count(ViewDisagreement &result)
{
    if (result.places.empty())
        return;
    std::vector<double> apart;
    double squares = 0, expected = 0;
    for (const Disagreement &place : result.places) {
        apart.push_back(place.apartM);
        squares += place.apartM * place.apartM;
        expected += place.expectedM * place.expectedM;
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
        result.places.push_back(
            {sample.time, *sample.position, *sample.viewDisagreementM, std::sqrt(square + step * step)});
    }
    count(result);
    return result;
}

namespace {

constexpr Nanoseconds reach = std::chrono::seconds(1); // to both sides of a time
constexpr std::size_t fewestTimes = 10;                // in it, that tell anything
constexpr double leastContradiction = 13.82;           // of χ²(2): 99.9 %
// (4.303 / 1.960)²: what lasts is one draw, of two degrees of freedom
constexpr double studentFactor2 = 4.82;

/// Two views' places at a time of both.
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
        const Eigen::Vector2d apart = a[i].place.pointInWorld - b[i].place.pointInWorld;
        const Eigen::Matrix2d covariance = totalCovariance(a[i].place) + totalCovariance(b[i].place);
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
            sighting.place.calibrationCovariance += (least[v] - 1) * totalCovariance(sighting.place);
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
        joined({ODO_TEXT("trajectory.views_apart", "the views put it %1 apart")(
                    quantity(toMillimetres(upperMedian(std::move(found.apartM))), 0, "mm")),
                ODO_TEXT("trajectory.why_views_apart",
                         "a camera was moved after it was registered, the videos belong to other cameras, or "
                         "one view follows something else")},
               Join::Colon),
        ODO_TEXT("trajectory.look_and_register", "look at the outlines, and register the cameras again"));
}

} // namespace odo
