// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/height_estimation.h"

#include "core/base/upper_median.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

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
                const FloorPosition &p = first.place, &q = second.place;
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
    // The calibration's error is common to all times: it does not average out.
    const double common = calibrationVariance / information;
    const double sigma = std::sqrt(variance / information + common * common);
    if (!std::isfinite(sigma) || sigma > largestHeightSigmaM)
        return std::nullopt;
    return PlaneEstimate{std::clamp(height, 0.0, highestPlaneM), sigma};
}

} // namespace odo
