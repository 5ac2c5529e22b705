// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_contradiction.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/contradiction_model.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/view_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double overwhelming = 15;  // nats: a cause that moves the position by little as well
constexpr double nearlyAsLikely = 6; // nats
constexpr std::size_t mostNamed = 3;
constexpr double tempered = 4;   // nats by which a cause is e times less likely: the models are not exact
constexpr double leastOff = 1.5; // σ of the position
// With a sure form: of 60 runs in which nothing was wrong (tests/trajectory/contradictory_runs.h) 59 stayed
// below 1.5 σ, one had 2.3.
constexpr double leastSureEvidence = 1.5, leastSureOff = 2.5;
constexpr double unmeasuredOffsetSigmaS = 0.001; // of one that was told
// of a plane by a given height: the clearance below is not given; a wrong height makes it look worse known
constexpr double mostGivenSigmaM = 0.003;
constexpr double aside = 0.25; // of a variance: what may be in other directions than the cause has it

double offsetSigmaS(const ViewTrack &a, const ViewTrack &b)
{
    const auto its = [](const ViewTrack &view) {
        return view.startOffsetSigmaS > 0 ? view.startOffsetSigmaS : unmeasuredOffsetSigmaS;
    };
    return std::hypot(its(a), its(b));
}

/// Two views that contradict each other, with the causes that may be.
struct ContradictedPair
{
    std::size_t a = 0, b = 0;
    std::vector<FittedCause> causes; ///< the best first; empty: they agree
};

std::vector<FittedCause> fitted(const std::vector<ViewTrack> &views,
                                const std::vector<std::vector<Sighting>> &sightings,
                                const ComparedPlane &plane, std::size_t a, std::size_t b)
{
    const double sigmaM = plane.isGiven ? std::min(plane.sigmaM, mostGivenSigmaM) : plane.sigmaM;
    const PairPriors priors{plane.heightM, sigmaM, plane.isGiven, offsetSigmaS(views[a], views[b])};
    return fitCauses(*views[a].floorView, *views[b].floorView, sightings[a], sightings[b], priors);
}

bool isSurelyOff(const FittedCause &cause, const ComparedPlane &plane)
{
    return plane.isFormSure && cause.logEvidence > leastSureEvidence && cause.significance > leastSureOff;
}

ContradictedPair findingOf(const std::vector<ViewTrack> &views,
                           const std::vector<std::vector<Sighting>> &sightings, const ComparedPlane &plane,
                           std::size_t a, std::size_t b)
{
    ContradictedPair finding{a, b, fitted(views, sightings, plane, a, b)};
    if (!finding.causes.empty()) {
        const FittedCause &best = finding.causes.front();
        const bool isOff = best.significance > leastOff || best.logEvidence > overwhelming;
        if (!(best.logEvidence > leastEvidence && isOff) && !isSurelyOff(best, plane))
            finding.causes.clear();
    }
    for (FittedCause &one : finding.causes) {
        one.cause.view = one.cause.view == 0 ? a : b;
        one.cause.otherView = one.cause.otherView == 0 ? a : b;
    }
    return finding;
}

bool areBothClear(const Sighting &a, const Sighting &b)
{
    return a.seen && b.seen && !a.cut && !b.cut;
}

/// Widens both views so that the joined position holds what the causes move it by, each as likely as it is.
void widen(std::vector<Sighting> &a, std::vector<Sighting> &b, const std::vector<FittedCause> &causes)
{
    std::vector<double> weights;
    double sum = 0;
    for (const FittedCause &cause : causes) {
        weights.push_back(std::exp((cause.logEvidence - causes.front().logEvidence) / tempered));
        sum += weights.back();
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        Eigen::Matrix2d whole = Eigen::Matrix2d::Zero();
        for (std::size_t c = 0; c < causes.size(); ++c) {
            const Eigen::Vector2d &off = causes[c].offM[i];
            whole += weights[c] / sum *
                     (off * off.transpose() + aside * off.squaredNorm() * Eigen::Matrix2d::Identity() +
                      causes[c].offCovarianceM2[i]);
        }
        // of two that weigh alike, half the variance of each is in the joined position
        const double share = areBothClear(a[i], b[i]) ? 2 : 1;
        a[i].position.calibrationCovariance += share * whole;
        b[i].position.calibrationCovariance += share * whole;
    }
}

/// How far two views are apart where the cause moves the position by more than its σ.
std::vector<double> apartBy(const FittedCause &cause, const std::vector<Sighting> &a,
                            const std::vector<Sighting> &b)
{
    std::vector<double> apartM(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (areBothClear(a[i], b[i]) && cause.offM[i].norm() > cause.sigmaM[i])
            apartM[i] = (a[i].position.pointInWorld - b[i].position.pointInWorld).norm();
    }
    return apartM;
}

double medianApart(const std::vector<Sighting> &a, const std::vector<Sighting> &b)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i].seen && b[i].seen)
            distances.push_back((a[i].position.pointInWorld - b[i].position.pointInWorld).norm());
    return distances.size() < 10 ? HUGE_VAL : upperMedian(std::move(distances));
}

/// Whether what was found before is a special case of a cause, which then says no more.
bool isSimplerThere(const std::vector<ContradictionCause> &before, const ContradictionCause &cause)
{
    using Kind = ContradictionCause::Kind;
    return std::ranges::any_of(before, [&](const ContradictionCause &one) {
        // a height is fitted with every other cause
        return one.kind == Kind::Height || (one.kind == Kind::Offset && cause.kind == Kind::ClockRate) ||
               (one.kind == Kind::CameraMoved && !one.since && cause.kind == Kind::CamerasMoved) ||
               (one.kind == Kind::CameraMoved && cause.kind == Kind::CameraMoved && one.view == cause.view);
    });
}

} // namespace

std::optional<PairCorrection> likelyCorrection(const std::vector<ViewTrack> &views,
                                               const std::vector<std::vector<Sighting>> &sightings,
                                               const ComparedPlane &plane, double least)
{
    if (views.size() != 2 || !views[0].floorView || !views[1].floorView)
        return std::nullopt;
    const auto causes = fitted(views, sightings, plane, 0, 1);
    if (causes.empty() || (causes.front().logEvidence < least && !isSurelyOff(causes.front(), plane)))
        return std::nullopt;
    return causes.front().correction;
}

std::optional<ExplainedContradiction> explainContradiction(const std::vector<ViewTrack> &views,
                                                           std::vector<std::vector<Sighting>> &sightings,
                                                           const ComparedPlane &plane)
{
    std::vector<ContradictedPair> findings;
    std::size_t registered = 0;
    for (std::size_t a = 0; a < views.size(); ++a) {
        registered += views[a].floorView.has_value();
        for (std::size_t b = a + 1; b < views.size(); ++b)
            if (views[a].floorView && views[b].floorView)
                findings.push_back(findingOf(views, sightings, plane, a, b));
    }
    const auto worst = std::ranges::max_element(findings, {}, [](const ContradictedPair &one) {
        return one.causes.empty() ? 0.0 : one.causes.front().logEvidence;
    });
    if (worst == findings.end() || worst->causes.empty())
        return std::nullopt;
    ExplainedContradiction found;
    found.apartM = apartBy(worst->causes.front(), sightings[worst->a], sightings[worst->b]);
    std::vector<double> apart;
    std::ranges::copy_if(found.apartM, std::back_inserter(apart), [](double one) { return one > 0; });
    found.contradiction.apartM = apart.empty() ? 0 : upperMedian(std::move(apart));
    // a view that agrees with a third one is not the one that moved
    const auto agrees = [&](std::size_t view) {
        return std::ranges::any_of(findings, [&](const ContradictedPair &one) {
            return one.causes.empty() && (one.a == view || one.b == view);
        });
    };
    for (const FittedCause &one : worst->causes) {
        if (one.logEvidence < worst->causes.front().logEvidence - nearlyAsLikely ||
            found.contradiction.causes.size() == mostNamed)
            break;
        const bool isOther = registered > 2 && one.cause.kind == ContradictionCause::Kind::CameraMoved &&
                             agrees(one.cause.view);
        if (!isOther && !isSimplerThere(found.contradiction.causes, one.cause))
            found.contradiction.causes.push_back(one.cause);
    }
    if (registered == 2)
        widen(sightings[worst->a], sightings[worst->b], worst->causes);
    return found;
}

std::optional<std::pair<std::size_t, std::size_t>>
exchangedViews(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
               double planeM)
{
    constexpr double farBetter = 0.25, nearM = 0.1;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            if (!views[a].floorView || !views[b].floorView)
                continue;
            const double asGivenM = medianApart(sightings[a], sightings[b]);
            if (asGivenM < nearM)
                continue;
            std::vector<Nanoseconds> times;
            for (const Sighting &sighting : sightings[a])
                times.push_back(sighting.time);
            std::vector<ViewTrack> pair{views[a], views[b]};
            std::swap(pair[0].floorView, pair[1].floorView);
            const auto onFloor = viewFromAllSides(pair, times, 0);
            const auto plane = estimatePlane(onFloor);
            const auto exchanged = viewFromAllSides(pair, times, plane ? plane->planeM : planeM);
            if (medianApart(exchanged[0], exchanged[1]) < std::min(nearM, farBetter * asGivenM))
                return std::pair(a, b);
        }
    }
    return std::nullopt;
}

} // namespace odo
