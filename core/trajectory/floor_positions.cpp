// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/floor_positions.h"

#include "core/trajectory/repeated_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double unknownSigmaPx = 0.5;
constexpr std::size_t leastClear = 10;
constexpr double oddAreaScatter = 5,
                 oddAreaDoubts = 4;  // times the usual scatter, and times the doubt about outlines
constexpr double leastSigmaPx = 0.1; // what all edges of an outline share, whatever the noise of each says

Eigen::Matrix2d usableCovariance(const Eigen::Matrix2d &covariancePx2)
{
    const double determinant = covariancePx2.determinant();
    const bool usable = covariancePx2.allFinite() && covariancePx2(0, 0) > 0 && determinant > 0;
    const Eigen::Matrix2d base =
        usable ? Eigen::Matrix2d((covariancePx2 + covariancePx2.transpose()) / 2)
               : Eigen::Matrix2d(Eigen::Matrix2d::Identity() * unknownSigmaPx * unknownSigmaPx);
    return base + Eigen::Matrix2d::Identity() * leastSigmaPx * leastSigmaPx;
}

/// What an observation says, but for the place.
Sighting sightingOf(const ViewTrack &view, const Observation &observation, bool repeated)
{
    Sighting sighting;
    sighting.time = observation.time + view.startOffset;
    sighting.score = observation.score;
    sighting.cut = observation.touchesBorder;
    sighting.duplicate = observation.found && (observation.duplicateFrame || repeated);
    return sighting;
}

bool canBePlaced(const Observation &observation, const Sighting &sighting)
{
    return observation.found && !sighting.duplicate && observation.ellipse.centrePx.allFinite();
}

void layAt(Sighting &sighting, const FloorView &view, const Eigen::Vector2d &pixel,
           const Eigen::Matrix2d &covariance, double planeM)
{
    const auto place = view.locate(pixel, covariance, planeM);
    if (place && place->pointInWorld.allFinite() && place->pixelCovariance.allFinite()) {
        sighting.seen = true;
        sighting.place = *place;
    }
}

} // namespace

std::vector<Sighting> placeObservations(const ViewTrack &view, double planeM)
{
    std::vector<Sighting> sightings;
    sightings.reserve(view.observations.size());
    const std::vector<bool> repeated = repeatedPictures(view.observations);
    for (std::size_t i = 0; i < view.observations.size(); ++i) {
        const Observation &observation = view.observations[i];
        Sighting sighting = sightingOf(view, observation, repeated[i]);
        if (canBePlaced(observation, sighting))
            layAt(sighting, *view.floorView, observation.ellipse.centrePx,
                  usableCovariance(observation.centreCovariancePx2), planeM);
        sightings.push_back(sighting);
    }
    return sightings;
}

namespace {

constexpr int anglesOfUnknownAxis = 6;

/// The pixel of the body's middle, and what the doubt about its axis adds to its covariance.
struct BodyPixel
{
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

std::optional<BodyPixel> bodyPixel(const FloorView &view, const SolidShape &shape,
                                   const Eigen::Vector2d &centroid, const BodyAxis &axis)
{
    if (shape.form == SolidShape::Form::Cylinder || axis.sigmaRad <= unknownAxisSigmaRad) {
        const auto here = pixelOfBodyMiddle(view, shape, centroid, axis.angleRad);
        const auto turned = pixelOfBodyMiddle(view, shape, centroid, axis.angleRad + axis.sigmaRad);
        if (!here || !turned)
            return std::nullopt;
        const Eigen::Vector2d shift = *turned - *here;
        return BodyPixel{*here, shift * shift.transpose()};
    }
    BodyPixel mean;
    std::vector<Eigen::Vector2d> pixels;
    for (int i = 0; i < anglesOfUnknownAxis; ++i) {
        const auto pixel =
            pixelOfBodyMiddle(view, shape, centroid, i * std::numbers::pi / anglesOfUnknownAxis);
        if (!pixel)
            return std::nullopt;
        pixels.push_back(*pixel);
        mean.pixel += *pixel / anglesOfUnknownAxis;
    }
    for (const Eigen::Vector2d &pixel : pixels)
        mean.covariance += (pixel - mean.pixel) * (pixel - mean.pixel).transpose() / anglesOfUnknownAxis;
    return mean;
}

/// Logarithm of the area seen over the solid's, where it stands.
double areaExcess(const FloorView &view, const SolidShape &shape, const Observation &observation,
                  const Sighting &sighting, const BodyAxis &axis)
{
    const auto model = silhouetteMoments(view, shape, sighting.place.pointInWorld, axis.angleRad);
    return model && model->areaPx2 > 0 && observation.areaPx > 0
               ? std::log(observation.areaPx / model->areaPx2)
               : 0;
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Takes the score of outlines that are larger or smaller than this view usually sees the solid.
void doubtOddAreas(std::vector<Sighting> &sightings, const std::vector<double> &excess, double areaShare)
{
    std::vector<double> clear;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        if (sightings[i].seen && !sightings[i].cut)
            clear.push_back(excess[i]);
    }
    if (clear.size() < leastClear)
        return;
    const double usual = medianOf(clear);
    for (double &one : clear)
        one = std::abs(one - usual);
    const double limit = std::max(oddAreaScatter * 1.4826 * medianOf(clear), oddAreaDoubts * areaShare);
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        if (sightings[i].seen && !sightings[i].cut && std::abs(excess[i] - usual) > limit)
            sightings[i].score = 0;
    }
}

} // namespace

std::vector<Sighting> placeBody(const ViewTrack &view, const SolidShape &shape,
                                const std::vector<BodyAxis> &axes)
{
    std::vector<Sighting> sightings;
    std::vector<double> excess(view.observations.size()), areaShares;
    const std::vector<bool> repeated = repeatedPictures(view.observations);
    sightings.reserve(view.observations.size());
    for (std::size_t i = 0; i < view.observations.size(); ++i) {
        const Observation &observation = view.observations[i];
        Sighting sighting = sightingOf(view, observation, repeated[i]);
        const auto pixel = canBePlaced(observation, sighting)
                               ? bodyPixel(*view.floorView, shape, observation.ellipse.centrePx, axes[i])
                               : std::nullopt;
        if (pixel)
            layAt(sighting, *view.floorView, pixel->pixel,
                  usableCovariance(observation.centreCovariancePx2) + pixel->covariance,
                  middleHeightM(shape));
        if (sighting.seen) {
            excess[i] = areaExcess(*view.floorView, shape, observation, sighting, axes[i]);
            areaShares.push_back(sigmaOfOutline(outlineMoments(observation)).areaShare);
        }
        sightings.push_back(sighting);
    }
    if (!areaShares.empty())
        doubtOddAreas(sightings, excess, medianOf(std::move(areaShares)));
    return sightings;
}

Nanoseconds typicalInterval(const std::vector<Sighting> &sightings)
{
    std::vector<Nanoseconds> intervals;
    for (std::size_t i = 1; i < sightings.size(); ++i)
        intervals.push_back(sightings[i].time - sightings[i - 1].time);
    if (intervals.empty())
        return Nanoseconds{0};
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    return *middle;
}

} // namespace odo
