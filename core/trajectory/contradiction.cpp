// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/contradiction.h"

#include "core/base/units.h"
#include "core/base/upper_median.h"
#include "core/trajectory/track_profile.h"

#include <Eigen/LU>
#include <algorithm>

namespace odo {

namespace {

constexpr Nanoseconds reach = std::chrono::seconds(1); // to both sides of a time
constexpr std::size_t fewestTimes = 10;                // in it, that tell anything
constexpr double leastContradiction = 13.82;           // of χ²(2): 99.9 %
constexpr double studentFactor2 = 4.82;                // (4.303 / 1.960)²: what lasts is one draw, of two degrees of freedom

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
    double factor = 1, apartM = 0; ///< by which their variances are too small; 1: by nothing, or it isn't known
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
    if (2 * found.apartM.size() < found.seen || double(found.used) >= leastUsed * double(found.seen) || found.apartM.empty())
        return {};
    return fail(ErrorCode::Undetermined, cannotMeasurePath,
                "the views put it " + formatNumber(1000 * upperMedian(std::move(found.apartM)), 0) +
                    " mm apart: a camera was moved after it was registered, the videos belong to other cameras, or one view follows something else",
                "look at the outlines, and register the cameras again");
}

} // namespace odo
