// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/free_height.h"

#include "core/base/upper_median.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastHeights = 10;
constexpr double highestJumpM = 0.15;
constexpr double neighbourSigmaM = 0.01; // of a height taken from the frames around
constexpr std::size_t medianReach = 8;   // frames to either side; a quarter of a second at 30 frames/s
constexpr double leastParallax =
    0.05; // metres on the floor per metre of height: below it the rays are as good as one

struct TimedHeight
{
    double heightM = 0, varianceM2 = 0;
};

/// The height at which the views' rays come nearest at one time.
std::optional<TimedHeight> heightAt(const std::vector<std::vector<Sighting>> &views, std::size_t i)
{
    double information = 0, projection = 0, parallax = 0;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            const Sighting &first = views[a][i], &second = views[b][i];
            if (!first.seen || !second.seen || first.cut || second.cut)
                continue;
            const Eigen::Vector2d perMetre =
                first.place.displacementPerMetreHeight - second.place.displacementPerMetreHeight;
            const Eigen::Matrix2d weight =
                (first.place.pixelCovariance + second.place.pixelCovariance).inverse();
            information += perMetre.dot(weight * perMetre);
            projection -= perMetre.dot(weight * (first.place.pointInWorld - second.place.pointInWorld));
            parallax = std::max(parallax, perMetre.norm());
        }
    }
    if (parallax < leastParallax || !(information > 0))
        return std::nullopt;
    return TimedHeight{projection / information, 1 / information};
}

/// Median of the known heights near a time, the reach widened until there are some.
double medianNear(const std::vector<std::optional<TimedHeight>> &heights, std::size_t i)
{
    for (std::size_t reach = medianReach;; reach *= 2) {
        std::vector<double> near;
        const std::size_t begin = i > reach ? i - reach : 0, end = std::min(heights.size(), i + reach + 1);
        for (std::size_t k = begin; k < end; ++k) {
            if (heights[k])
                near.push_back(heights[k]->heightM);
        }
        if (!near.empty())
            return upperMedian(std::move(near));
    }
}

} // namespace

std::optional<FreeHeightSightings> freeHeight(std::vector<std::vector<Sighting>> views)
{
    const std::size_t times = views.empty() ? 0 : views.front().size();
    std::vector<std::optional<TimedHeight>> heights(times);
    std::vector<double> known;
    for (std::size_t i = 0; i < times; ++i) {
        heights[i] = heightAt(views, i);
        if (heights[i])
            known.push_back(heights[i]->heightM);
    }
    if (known.size() < leastHeights)
        return std::nullopt;
    for (std::size_t i = 0; i < times; ++i) {
        const double near = medianNear(heights, i);
        const bool sure = heights[i] && std::abs(heights[i]->heightM - near) <= highestJumpM;
        const double height = sure ? heights[i]->heightM : near;
        const double variance = sure ? heights[i]->varianceM2 : neighbourSigmaM * neighbourSigmaM;
        for (auto &view : views) {
            FloorPosition &place = view[i].place;
            place.pointInWorld += height * place.displacementPerMetreHeight;
            place.pixelCovariance +=
                variance * place.displacementPerMetreHeight * place.displacementPerMetreHeight.transpose();
        }
    }
    return FreeHeightSightings{std::move(views), upperMedian(std::move(known))};
}

double heightScatterM(const std::vector<std::vector<Sighting>> &views, double heightM)
{
    std::vector<double> deviations;
    for (std::size_t i = 0; i < (views.empty() ? 0 : views.front().size()); ++i) {
        if (const auto height = heightAt(views, i))
            deviations.push_back(std::abs(height->heightM - heightM));
    }
    return deviations.size() < leastHeights ? 0 : 1.4826 * upperMedian(std::move(deviations));
}

} // namespace odo
