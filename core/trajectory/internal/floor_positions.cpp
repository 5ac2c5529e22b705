// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/floor_positions.h"

#include "core/base/percentile.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/body_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace odo {

namespace {

constexpr double unknownSigmaPx = 0.5;
constexpr std::size_t leastClear = 10;
constexpr double largestUsualExcess = 0.15; // of the area's logarithm
constexpr double oddAreaScatter = 5,
                 oddAreaUncertainty = 4; // times the usual scatter, and times the uncertainty of outlines
constexpr double leastSigmaPx = 0.1; // what all edges of an outline share, whatever the noise of each says
// What coding, shading and the lens's blur leave in all of a run's outlines alike: the centres of known
// outlines come back from H.264 and MJPEG files with so much bias (docs/accuracy.md).
constexpr double lastingSigmaPx = 0.05;

Eigen::Matrix2d usableCovariance(const Eigen::Matrix2d &covariancePx2)
{
    const double determinant = covariancePx2.determinant();
    const bool usable = covariancePx2.allFinite() && covariancePx2(0, 0) > 0 && determinant > 0;
    const Eigen::Matrix2d base =
        usable ? Eigen::Matrix2d((covariancePx2 + covariancePx2.transpose()) / 2)
               : Eigen::Matrix2d(Eigen::Matrix2d::Identity() * unknownSigmaPx * unknownSigmaPx);
    return base + Eigen::Matrix2d::Identity() * leastSigmaPx * leastSigmaPx;
}

/// What an observation shows besides the position.
Sighting sightingOf(const ViewTrack &view, const Observation &observation, bool repeated)
{
    Sighting sighting;
    sighting.time = timeOf(view, observation);
    sighting.score = observation.score;
    sighting.cut = observation.touchesBorder;
    sighting.ofOutline = !observation.supportPx.empty();
    sighting.duplicate = observation.found && (observation.duplicateFrame || repeated);
    return sighting;
}

bool canBePositioned(const Observation &observation, const Sighting &sighting)
{
    return observation.found && !sighting.duplicate && observation.ellipse.centrePx.allFinite();
}

void layAt(Sighting &sighting, const FloorView &view, const Eigen::Vector2d &pixel,
           const Eigen::Matrix2d &covariance, double planeM, double unexplainedPx = 0)
{
    const auto position = view.locate(pixel, covariance, planeM);
    const double lastingVariancePx2 = lastingSigmaPx * lastingSigmaPx + unexplainedPx * unexplainedPx;
    const auto lasting = view.locate(pixel, Eigen::Matrix2d::Identity() * lastingVariancePx2, planeM);
    if (position && position->pointInWorld.allFinite() && position->pixelCovariance.allFinite()) {
        sighting.seen = true;
        sighting.position = *position;
        sighting.position.calibrationCovariance += lasting->pixelCovariance;
    }
}

/// What shadows leave ambiguous of an outline, on the plane where it was positioned.
void addAmbiguity(Sighting &sighting, const FloorView &view, const Observation &observation, double planeM)
{
    const Eigen::Matrix2d &lastingPx2 = observation.lastingCovariancePx2;
    if (!sighting.seen || lastingPx2.isZero() || !lastingPx2.allFinite())
        return;
    if (const auto spread = view.locate(observation.ellipse.centrePx, lastingPx2, planeM))
        sighting.lastingCovariance = spread->pixelCovariance;
}

} // namespace

std::vector<Sighting> positionObservations(const ViewTrack &view, double planeM)
{
    std::vector<Sighting> sightings;
    sightings.reserve(view.observations.size());
    const std::vector<bool> repeated = repeatedFrames(view.observations);
    for (std::size_t i = 0; i < view.observations.size(); ++i) {
        const Observation &observation = view.observations[i];
        Sighting sighting = sightingOf(view, observation, repeated[i]);
        if (canBePositioned(observation, sighting))
            layAt(sighting, *view.floorView, observation.ellipse.centrePx,
                  usableCovariance(observation.centreCovariancePx2), planeM);
        addAmbiguity(sighting, *view.floorView, observation, planeM);
        sightings.push_back(sighting);
    }
    return sightings;
}

namespace {

constexpr int anglesOfUnknownAxis = 6;

/// The pixel of the body's middle, and what the uncertainty of its axis adds to its covariance.
struct BodyPixel
{
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

std::optional<BodyPixel> bodyPixel(const FloorView &view, const SolidShape &shape,
                                   const Observation &observation, const BodyAxis &axis,
                                   const OutlineDifference &outlines)
{
    const Eigen::Vector2d &centroid = observation.ellipse.centrePx;
    if (shape.form == SolidShape::Form::Cylinder || axis.sigmaRad <= unknownAxisSigmaRad) {
        const auto here = pixelOfBodyMiddle(view, shape, centroid, axis.angleRad);
        const auto turned = pixelOfBodyMiddle(view, shape, centroid, axis.angleRad + axis.sigmaRad);
        if (!here || !turned)
            return std::nullopt;
        const Eigen::Vector2d shift = *turned - *here;
        const auto start = view.floorFromPixel(*here, middleHeightM(shape));
        const auto placed =
            start ? positionBySupport(view, shape, observation, outlines, {*start, axis}) : std::nullopt;
        const auto middle =
            placed ? view.pixelFromWorld({placed->position.x(), placed->position.y(), middleHeightM(shape)})
                   : std::nullopt;
        return BodyPixel{middle.value_or(*here), shift * shift.transpose()};
    }
    BodyPixel mean;
    std::vector<Eigen::Vector2d> pixels;
    // after which it looks the same
    const double turn = shape.form == SolidShape::Form::Levels ? 2 * std::numbers::pi : std::numbers::pi;
    for (int i = 0; i < anglesOfUnknownAxis; ++i) {
        const auto pixel = pixelOfBodyMiddle(view, shape, centroid, i * turn / anglesOfUnknownAxis);
        if (!pixel)
            return std::nullopt;
        pixels.push_back(*pixel);
        mean.pixel += *pixel / anglesOfUnknownAxis;
    }
    for (const Eigen::Vector2d &pixel : pixels)
        mean.covariance += (pixel - mean.pixel) * (pixel - mean.pixel).transpose() / anglesOfUnknownAxis;
    return mean;
}

/// Logarithm of the area seen over the solid's, at its position.
double areaExcess(const FloorView &view, const SolidShape &shape, const Observation &observation,
                  const Sighting &sighting, const BodyAxis &axis)
{
    const auto model = silhouetteMoments(view, shape, sighting.position.pointInWorld, axis.angleRad);
    return model && model->areaPx2 > 0 && observation.areaPx > 0
               ? std::log(observation.areaPx / model->areaPx2)
               : 0;
}

/// One view's sightings of the body, with what its outlines' areas say.
struct BodySightings
{
    std::vector<Sighting> sightings;
    std::vector<double> excess; ///< of the area's logarithm, for each
    std::vector<double> clear;  ///< of those that are not cut
    double areaShare = 0;       ///< the usual uncertainty of an area
};

BodySightings positionInView(const ViewTrack &view, const SolidShape &shape,
                             const std::vector<BodyAxis> &axes, const SolidUncertainty &uncertainty)
{
    BodySightings placed;
    placed.excess.resize(view.observations.size());
    placed.sightings.reserve(view.observations.size());
    const std::vector<bool> repeated = repeatedFrames(view.observations);
    std::vector<double> areaShares;
    for (std::size_t i = 0; i < view.observations.size(); ++i) {
        const Observation &observation = view.observations[i];
        Sighting sighting = sightingOf(view, observation, repeated[i]);
        const auto pixel = canBePositioned(observation, sighting)
                               ? bodyPixel(*view.floorView, shape, observation, axes[i], uncertainty.outlines)
                               : std::nullopt;
        if (pixel)
            layAt(sighting, *view.floorView, pixel->pixel,
                  usableCovariance(observation.centreCovariancePx2) + pixel->covariance, middleHeightM(shape),
                  uncertainty.unexplainedPx);
        addAmbiguity(sighting, *view.floorView, observation, middleHeightM(shape));
        if (sighting.seen) {
            const Eigen::Vector2d forward(std::cos(axes[i].angleRad), std::sin(axes[i].angleRad)),
                left(-forward.y(), forward.x());
            sighting.position.calibrationCovariance +=
                uncertainty.forwardM * uncertainty.forwardM * forward * forward.transpose() +
                uncertainty.leftM * uncertainty.leftM * left * left.transpose();
            placed.excess[i] = areaExcess(*view.floorView, shape, observation, sighting, axes[i]);
            areaShares.push_back(sigmaOfOutline(outlineMoments(observation)).areaShare);
            if (!sighting.cut)
                placed.clear.push_back(placed.excess[i]);
        }
        placed.sightings.push_back(sighting);
    }
    placed.areaShare = areaShares.empty() ? 0 : upperMedian(std::move(areaShares));
    return placed;
}

/// Takes the score of outlines that are larger or smaller than a view usually sees the solid.
void uncertaintyOfOddAreas(BodySightings &placed, double usual)
{
    std::vector<double> deviations;
    for (const double excess : placed.clear) {
        if (std::abs(excess - usual) < largestUsualExcess)
            deviations.push_back(std::abs(excess - usual));
    }
    const double scatter = deviations.empty() ? 0 : 1.4826 * upperMedian(std::move(deviations));
    const double limit = std::max(oddAreaScatter * scatter, oddAreaUncertainty * placed.areaShare);
    for (std::size_t i = 0; i < placed.sightings.size(); ++i) {
        Sighting &sighting = placed.sightings[i];
        if (sighting.seen && !sighting.cut && std::abs(placed.excess[i] - usual) > limit)
            sighting.score = 0;
    }
}

/// What a view usually sees too much or too little of the solid. A view that mostly sees only a part of it
/// must not take that for the rule: then it is as for the view that fits best.
std::vector<double> usualExcess(const std::vector<BodySightings> &views)
{
    std::vector<double> usual;
    double best = HUGE_VAL;
    for (const BodySightings &view : views) {
        const double median = view.clear.size() < leastClear ? 0 : upperMedian(view.clear);
        usual.push_back(median);
        if (view.clear.size() >= leastClear && std::abs(median) < std::abs(best))
            best = median;
    }
    if (std::abs(best) > largestUsualExcess)
        best = 0;
    for (double &one : usual) {
        if (std::abs(one - best) > largestUsualExcess)
            one = best;
    }
    return usual;
}

} // namespace

std::vector<std::vector<Sighting>> positionBody(const std::vector<ViewTrack> &views, const SolidShape &shape,
                                                const std::vector<std::vector<BodyAxis>> &axes,
                                                const SolidUncertainty &uncertainty)
{
    std::vector<BodySightings> placed(views.size());
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (views[v].floorView)
            placed[v] = positionInView(views[v], shape, axes[v], uncertainty);
    }
    const std::vector<double> usual = usualExcess(placed);
    std::vector<std::vector<Sighting>> sightings;
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (placed[v].clear.size() >= leastClear)
            uncertaintyOfOddAreas(placed[v], usual[v]);
        sightings.push_back(std::move(placed[v].sightings));
    }
    return sightings;
}

Nanoseconds typicalInterval(const std::vector<Sighting> &sightings)
{
    std::vector<Nanoseconds> intervals;
    for (std::size_t i = 1; i < sightings.size(); ++i)
        intervals.push_back(sightings[i].time - sightings[i - 1].time);
    if (intervals.empty())
        return Nanoseconds{0};
    return upperMedian(std::move(intervals));
}

namespace {

constexpr double stillPx = 0.06, stillShare = 0.06; // of a usual step
constexpr double leastStepPx = 0.8;
constexpr std::size_t mostRepeats = 4;
constexpr double missedShare = 0.35; // of what was to be caught up may be explained by acceleration

bool isUsable(const Observation &observation)
{
    return observation.found && !observation.duplicateFrame && observation.ellipse.centrePx.allFinite();
}

/// Pixels a second between two neighbouring observations; nullopt where there is none.
std::optional<Eigen::Vector2d> velocityBetween(const Observation &a, const Observation &b)
{
    const double dt = toSeconds(b.time - a.time);
    if (!isUsable(a) || !isUsable(b) || !(dt > 0))
        return std::nullopt;
    return Eigen::Vector2d((b.ellipse.centrePx - a.ellipse.centrePx) / dt);
}

/// Whether observations [first, last] repeat frame first − 1.
bool isRepeat(const std::vector<Observation> &all, std::size_t first, std::size_t last)
{
    if (first < 2 || last + 2 >= all.size())
        return false;
    const Observation &before = all[first - 1], &after = all[last + 1];
    const auto in = velocityBetween(all[first - 2], before), out = velocityBetween(after, all[last + 2]);
    if (!in || !out || !isUsable(after))
        return false;
    const Eigen::Vector2d usual = (*in + *out) / 2;
    const double frameS = toSeconds(after.time - before.time) / static_cast<double>(last - first + 2);
    const double stepPx = usual.norm() * frameS;
    if (stepPx < leastStepPx || (*in - *out).norm() > usual.norm())
        return false;
    for (std::size_t i = first; i <= last; ++i) {
        if (!isUsable(all[i]) || (all[i].ellipse.centrePx - before.ellipse.centrePx).norm() >
                                     std::max(stillPx, stillShare * stepPx))
            return false;
    }
    const Eigen::Vector2d expected = usual * toSeconds(after.time - before.time);
    const double missedPx = stepPx * static_cast<double>(last - first + 1);
    return (after.ellipse.centrePx - before.ellipse.centrePx - expected).norm() < missedShare * missedPx;
}

} // namespace

std::vector<bool> repeatedFrames(const std::vector<Observation> &observations)
{
    std::vector<bool> repeated(observations.size());
    for (std::size_t i = 2; i < observations.size(); ++i) {
        for (std::size_t count = 1; count <= mostRepeats; ++count) {
            if (!isRepeat(observations, i, i + count - 1))
                continue;
            std::fill_n(repeated.begin() + static_cast<std::ptrdiff_t>(i), count, true);
            i += count;
            break;
        }
    }
    return repeated;
}

} // namespace odo
