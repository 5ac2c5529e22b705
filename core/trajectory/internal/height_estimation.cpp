// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/height_estimation.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/view_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr std::size_t leastPairs = 10;
constexpr double largestHeightSigmaM = 0.025;
constexpr double highestPlaneM = 2.5; // a mark on a person's head is the highest that is of use
constexpr double huberLimit = 1.5;

/// Two views at one time: their difference at z = 0 and how it changes with the height.
struct ViewPair
{
    Eigen::Vector2d difference, differencePerMetre;
    Eigen::Matrix2d information; ///< of the frame to frame part
    Eigen::Matrix2d calibrationCovariance;
};

std::vector<ViewPair> collectPairs(const std::vector<std::vector<Sighting>> &views)
{
    std::vector<ViewPair> pairs;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            for (std::size_t i = 0; i < std::min(views[a].size(), views[b].size()); ++i) {
                const Sighting &first = views[a][i], &second = views[b][i];
                if (!first.seen || !second.seen || first.cut || second.cut)
                    continue;
                const FloorPosition &p = first.position, &q = second.position;
                pairs.push_back({p.pointInWorld - q.pointInWorld,
                                 p.displacementPerMetreHeight - q.displacementPerMetreHeight,
                                 (p.pixelCovariance + q.pixelCovariance).inverse(),
                                 p.calibrationCovariance + q.calibrationCovariance});
            }
        }
    }
    return pairs;
}

/// The height a single pair asks for; NaN-free because pairs without parallax weigh nothing.
double medianHeight(const std::vector<ViewPair> &pairs)
{
    std::vector<double> heights;
    for (const ViewPair &pair : pairs) {
        const double parallax = pair.differencePerMetre.squaredNorm();
        if (parallax > 1e-4)
            heights.push_back(-pair.differencePerMetre.dot(pair.difference) / parallax);
    }
    if (heights.empty())
        return 0;
    return upperMedian(std::move(heights));
}

double distanceAt(const ViewPair &pair, double height)
{
    const Eigen::Vector2d r = pair.difference + height * pair.differencePerMetre;
    return std::sqrt(std::max(0.0, r.dot(pair.information * r)));
}

} // namespace

std::optional<PlaneEstimate> estimatePlane(const std::vector<std::vector<Sighting>> &views)
{
    const std::vector<ViewPair> pairs = collectPairs(views);
    if (pairs.size() < leastPairs)
        return std::nullopt;

    double height = medianHeight(pairs);
    double information = 0, variance = 0, calibrationVariance = 0;
    for (int pass = 0; pass < 20; ++pass) {
        std::vector<double> distances;
        for (const ViewPair &pair : pairs)
            distances.push_back(distanceAt(pair, height));
        const double scale = std::max(1.0, upperMedian(distances) / 1.177); // median of a Rayleigh variable

        double projection = 0, weightSum = 0, residual = 0;
        information = 0;
        calibrationVariance = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const ViewPair &pair = pairs[i];
            const double weight = std::min(1.0, huberLimit * scale / std::max(distances[i], 1e-12));
            const Eigen::Vector2d lever = weight * (pair.information * pair.differencePerMetre);
            information += lever.dot(pair.differencePerMetre);
            projection -= lever.dot(pair.difference);
            calibrationVariance += std::sqrt(std::max(0.0, lever.dot(pair.calibrationCovariance * lever)));
            residual += weight * distances[i] * distances[i];
            weightSum += weight;
        }
        if (!(information > 1e-9))
            return std::nullopt;
        const double next = projection / information;
        variance = std::max(1.0, residual / (2 * weightSum));
        const bool settled = std::abs(next - height) < 1e-7;
        height = next;
        if (settled)
            break;
    }
    // The uncertainty of the calibration is the same at all times: it does not average out.
    const double common = calibrationVariance / information;
    const double sigma = std::sqrt(variance / information + common * common);
    if (!std::isfinite(sigma) || sigma > largestHeightSigmaM)
        return std::nullopt;
    return PlaneEstimate{std::clamp(height, 0.0, highestPlaneM), sigma};
}

namespace {

// A given height is that of the top; the end of the colour is known less well.
constexpr double givenPlaneSigmaM = 0.002;
// A robot of unknown height seen by one view is taken to lie on the floor; most are less than 120 mm high.
constexpr double unknownPlaneSigmaM = 0.03;

} // namespace

std::vector<std::vector<Sighting>> viewFromAllSides(const std::vector<ViewTrack> &views,
                                                    const std::vector<Nanoseconds> &times, double planeM)
{
    std::vector<std::vector<Sighting>> all;
    for (const ViewTrack &view : views)
        all.push_back(view.floorView ? sightingsAt(times, positionObservations(view, planeM))
                                     : std::vector<Sighting>(times.size()));
    return all;
}

PlaneChoice choosePlane(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                        const RobotShape &shape)
{
    if (shape.heightM) {
        const bool mark = isMarkAtTop(views, *shape.heightM);
        return {mark ? *shape.heightM : silhouettePlaneM(*shape.heightM), givenPlaneSigmaM, *shape.heightM,
                false};
    }
    if (const auto estimate = estimatePlane(viewFromAllSides(views, times, 0))) {
        const bool mark = isMarkAtTop(views, estimate->planeM);
        return {estimate->planeM, estimate->sigmaM, mark ? estimate->planeM : 2 * estimate->planeM, true};
    }
    return {0, unknownPlaneSigmaM, 0, false};
}

namespace {

constexpr double markShare = 0.5; // of the span from foot to top; a body covers all of it and more

/// The outline's length along the image of a vertical from the floor to heightM, as a share of that
/// vertical.
std::optional<double> verticalShare(const FloorView &view, const Ellipse &ellipse, double heightM)
{
    const auto position = view.floorFromPixel(ellipse.centrePx, heightM);
    if (!position)
        return std::nullopt;
    const auto foot = view.pixelFromWorld({position->x(), position->y(), 0});
    const auto top = view.pixelFromWorld({position->x(), position->y(), heightM});
    if (!foot || !top)
        return std::nullopt;
    const Eigen::Vector2d span = *top - *foot;
    if (span.norm() < 1)
        return std::nullopt; // seen from straight above: undetermined
    const double angle = std::atan2(span.y(), span.x()) - ellipse.angleRad;
    const double extent =
        2 * std::hypot(ellipse.semiMajorPx * std::cos(angle), ellipse.semiMinorPx * std::sin(angle));
    return extent / span.norm();
}

} // namespace

bool isMarkAtTop(const std::vector<ViewTrack> &views, double heightM)
{
    std::vector<double> shares;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        for (const Observation &observation : view.observations) {
            if (!observation.found || observation.touchesBorder || observation.isByHand)
                continue;
            if (const auto share = verticalShare(*view.floorView, observation.ellipse, heightM))
                shares.push_back(*share);
        }
    }
    if (shares.empty())
        return false;
    return upperMedian(std::move(shares)) < markShare;
}

} // namespace odo
