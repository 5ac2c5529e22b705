// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_layout.h"

#include "core/geometry/homography.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int mostSquares = 24;
constexpr double worstNodeMisfit = 0.2; // of a square

std::vector<PointPair> squaresByPixels(const std::vector<ReadMarker> &markers, const CharucoLayout &layout)
{
    std::vector<PointPair> pairs;
    for (const ReadMarker &marker : markers) {
        const auto square = layout.squareOf(marker.id);
        if (!square)
            return {};
        pairs.push_back({marker.centre(), square->cast<double>() + Vector2d(0.5, 0.5), {}});
    }
    return pairs;
}

/// RMS distance in squares; nullopt where a number is too high or no homography exists.
std::optional<double> misfit(const std::vector<ReadMarker> &markers, const CharucoLayout &layout)
{
    const std::vector<PointPair> pairs = squaresByPixels(markers, layout);
    const auto squareFromPixel = Homography::estimate(pairs);
    if (!squareFromPixel)
        return std::nullopt;
    // A board seen from behind cannot be: its markers would not have been read.
    if (squareFromPixel->matrix().determinant() < 0)
        return std::nullopt;
    double squares = 0;
    for (const PointPair &pair : pairs)
        squares += (*squareFromPixel->map(pair.source) - pair.target).squaredNorm();
    return std::sqrt(squares / static_cast<double>(pairs.size()));
}

} // namespace

Vector2d ReadMarker::centre() const
{
    const Eigen::Vector3d one = corners[0].homogeneous().cross(corners[2].homogeneous());
    const Eigen::Vector3d other = corners[1].homogeneous().cross(corners[3].homogeneous());
    return one.cross(other).hnormalized();
}

int CharucoLayout::markerCount() const
{
    return (squaresX * squaresY + (startsWithMarker ? 1 : 0)) / 2;
}

std::optional<Eigen::Vector2i> CharucoLayout::squareOf(int id) const
{
    if (id < 0 || id >= markerCount())
        return std::nullopt;
    for (int y = 0, next = 0; y < squaresY; ++y) {
        const int first = ((y % 2 == 0) == startsWithMarker) ? 0 : 1;
        const int inRow = (squaresX - first + 1) / 2;
        if (id < next + inRow)
            return Eigen::Vector2i(first + 2 * (id - next), y);
        next += inRow;
    }
    return std::nullopt;
}

std::optional<CharucoLayout> explainMarkers(const std::vector<ReadMarker> &markers, int columns, int rows)
{
    if (markers.size() < 4)
        return std::nullopt;
    const int highest = std::ranges::max_element(markers, {}, &ReadMarker::id)->id;
    std::optional<CharucoLayout> best;
    double least = worstNodeMisfit;
    const auto consider = [&](const CharucoLayout &layout) {
        const auto off = misfit(markers, layout);
        if (!off || *off >= least)
            return;
        least = *off;
        best = layout;
    };
    for (bool startsWithMarker : {false, true}) {
        if (columns > 0) {
            consider({columns + 1, rows + 1, startsWithMarker});
            consider({rows + 1, columns + 1, startsWithMarker});
            continue;
        }
        for (int squaresX = 3; squaresX <= mostSquares; ++squaresX) {
            CharucoLayout layout{squaresX, 3, startsWithMarker};
            while (layout.squaresY < mostSquares && layout.markerCount() <= highest)
                ++layout.squaresY;
            consider(layout);
        }
    }
    return best;
}

double measuredMarkerRatio(const std::vector<ReadMarker> &markers, const CharucoLayout &layout)
{
    const auto squareFromPixel = Homography::estimate(squaresByPixels(markers, layout));
    std::vector<double> sides;
    for (const ReadMarker &marker : markers) {
        for (std::size_t i = 0; squareFromPixel && i < 4; ++i) {
            const auto a = squareFromPixel->map(marker.corners[i]);
            const auto b = squareFromPixel->map(marker.corners[(i + 1) % 4]);
            if (a && b)
                sides.push_back((*a - *b).norm());
        }
    }
    if (sides.empty())
        return 0;
    const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
    std::nth_element(sides.begin(), middle, sides.end());
    return *middle;
}

} // namespace odo
