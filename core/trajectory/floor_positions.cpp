// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/floor_positions.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double unknownSigmaPx = 0.5;
constexpr double leastSigmaPx = 0.02; // no outline is known better; keeps matrices regular

Eigen::Matrix2d usableCovariance(const Eigen::Matrix2d &covariancePx2)
{
    const double determinant = covariancePx2.determinant();
    const bool usable = covariancePx2.allFinite() && covariancePx2(0, 0) > 0 && determinant > 0;
    const Eigen::Matrix2d base =
        usable ? Eigen::Matrix2d((covariancePx2 + covariancePx2.transpose()) / 2)
               : Eigen::Matrix2d(Eigen::Matrix2d::Identity() * unknownSigmaPx * unknownSigmaPx);
    return base + Eigen::Matrix2d::Identity() * leastSigmaPx * leastSigmaPx;
}

} // namespace

std::vector<Sighting> placeObservations(const ViewTrack &view, double planeM)
{
    std::vector<Sighting> sightings;
    sightings.reserve(view.observations.size());
    for (const Observation &observation : view.observations) {
        Sighting sighting;
        sighting.time = observation.time + view.startOffset;
        sighting.score = observation.score;
        sighting.cut = observation.touchesBorder;
        const bool found = observation.found && observation.ellipse.centrePx.allFinite();
        sighting.duplicate = found && observation.duplicateFrame;
        if (found && !observation.duplicateFrame) {
            const auto place = view.floorView->locate(
                observation.ellipse.centrePx, usableCovariance(observation.centreCovariancePx2), planeM);
            if (place && place->pointInWorld.allFinite() && place->pixelCovariance.allFinite()) {
                sighting.seen = true;
                sighting.place = *place;
            }
        }
        sightings.push_back(sighting);
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
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    return *middle;
}

} // namespace odo
