// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/repeated_views.h"

#include "core/calibration/board_placement.h"
#include "core/geometry/homography.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace odo {

namespace {

constexpr double nearOfExtent = 0.02, nearOfSquare = 0.25;
constexpr double commonPart = 0.9; // of the corners: some may be covered, misread or just cut off
constexpr double sameTiltDegrees = 8;
constexpr int mostSteps = 3;

/// The smallest distance between two corners in the image.
double leastSpacingPx(const std::vector<Eigen::Vector2d> &pixels)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, (pixels[i] - pixels[j]).squaredNorm());
    }
    return std::sqrt(least);
}

/// Whether enough of the pixels are so near to one of the others.
bool coincide(const std::vector<Eigen::Vector2d> &pixels, const std::vector<Eigen::Vector2d> &others,
              double nearPx)
{
    auto mayMiss = static_cast<std::size_t>((1 - commonPart) * static_cast<double>(pixels.size()));
    for (const Eigen::Vector2d &pixel : pixels) {
        const bool isNear = std::ranges::any_of(others, [&](const Eigen::Vector2d &other) {
            return (pixel - other).squaredNorm() <= nearPx * nearPx;
        });
        if (!isNear && mayMiss-- == 0)
            return false;
    }
    return true;
}

bool sameTilt(const BoardView &view, const BoardView &other)
{
    const auto slope = slopeOf(view), there = slopeOf(other);
    return slope && there && (*slope - *there).norm() * BoardPlacement::fullSlopeDegrees < sameTiltDegrees;
}

} // namespace

bool repeatsPosition(const BoardView &view, const BoardView &other)
{
    const double nearPx = nearOfExtent * extentOf(other.pixels);
    // The spacing and the tilt take long: only where they may matter.
    return coincide(view.pixels, other.pixels, nearPx) &&
           coincide(view.pixels, other.pixels,
                    std::min(nearPx, nearOfSquare * leastSpacingPx(other.pixels))) &&
           sameTilt(view, other);
}

BoardPositions positionsIn(const std::vector<BoardView> &views)
{
    std::vector<std::size_t> left(views.size()); // the most corners first
    std::iota(left.begin(), left.end(), std::size_t(0));
    std::ranges::stable_sort(left, std::ranges::greater{},
                             [&](std::size_t i) { return views[i].pixels.size(); });
    BoardPositions positions;
    positions.shownBy.resize(views.size());
    while (!left.empty()) {
        const std::size_t counting = left.front();
        left.erase(left.begin());
        positions.counting.push_back(counting);
        positions.shownBy[counting] = counting;
        std::vector<std::size_t> reached{counting};
        for (int step = 0; step < mostSteps && !reached.empty(); ++step) {
            const auto next = std::stable_partition(left.begin(), left.end(), [&](std::size_t i) {
                return std::ranges::none_of(
                    reached, [&](std::size_t there) { return repeatsPosition(views[i], views[there]); });
            });
            reached.assign(next, left.end());
            left.erase(next, left.end());
            for (std::size_t i : reached)
                positions.shownBy[i] = counting;
        }
    }
    std::ranges::sort(positions.counting);
    return positions;
}

} // namespace odo
