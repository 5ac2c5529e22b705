// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_coverage.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double wantedPlace = 0.7, wantedSize = 0.4, wantedSlope = 0.5;
constexpr int wantedPictures = 10, manyPictures = 40;
constexpr double wantedPart = 0.5;

double part(double value, double wanted) { return std::clamp(value / wanted, 0.0, 1.0); }

/// How far the slopes spread: the largest difference of two. One tilt against a frontal picture is half of it.
double spreadOfSlopes(const std::vector<BoardPlacement> &placements)
{
    double widest = 0;
    for (const BoardPlacement &one : placements) {
        widest = std::max(widest, 0.5 * one.skew());
        for (const BoardPlacement &other : placements)
            widest = std::max(widest, 0.5 * (one.slope - other.slope).norm());
    }
    return widest;
}

} // namespace

double BoardCoverage::coveredPart() const
{
    const auto covered = std::ranges::count_if(corners, [](int count) { return count > 0; });
    return static_cast<double>(covered) / static_cast<double>(corners.size());
}

bool BoardCoverage::isEnough() const
{
    const bool full = x >= 1 && y >= 1 && size >= 1 && skew >= 1 && coveredPart() >= wantedPart;
    return (full && pictures >= wantedPictures) || pictures >= manyPictures;
}

BoardCoverage coverageOf(const std::vector<BoardView> &views, const std::vector<BoardPlacement> &placements,
                         int widthPx, int heightPx)
{
    BoardCoverage coverage;
    coverage.pictures = static_cast<int>(views.size());
    for (const BoardView &view : views) {
        for (const Eigen::Vector2d &pixel : view.pixels) {
            const int x = std::clamp(static_cast<int>(pixel.x() * BoardCoverage::across / widthPx), 0,
                                     BoardCoverage::across - 1);
            const int y =
                std::clamp(static_cast<int>(pixel.y() * BoardCoverage::down / heightPx), 0, BoardCoverage::down - 1);
            ++coverage.corners[static_cast<std::size_t>(y * BoardCoverage::across + x)];
        }
    }
    if (placements.empty())
        return coverage;
    Eigen::Vector2d least = placements.front().place, most = least;
    double largest = 0;
    for (const BoardPlacement &placement : placements) {
        least = least.cwiseMin(placement.place);
        most = most.cwiseMax(placement.place);
        largest = std::max(largest, placement.size);
    }
    coverage.x = part((most - least).x(), wantedPlace);
    coverage.y = part((most - least).y(), wantedPlace);
    coverage.size = part(largest, wantedSize);
    coverage.skew = part(spreadOfSlopes(placements), wantedSlope);
    return coverage;
}

} // namespace odo
