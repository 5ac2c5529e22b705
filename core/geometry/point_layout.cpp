// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/point_layout.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace odo {

namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

constexpr std::size_t triedPoints = 16; // 1820 quadrilaterals

double heightOfTriangle(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    const Vector2d ab = b - a, ac = c - a;
    const double area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
    const double longest = std::max({ab.norm(), ac.norm(), (c - b).norm()});
    return longest > 0 ? area / longest : 0;
}

std::vector<int> candidates(const Points &points)
{
    std::vector<int> chosen(points.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    if (points.size() <= triedPoints)
        return chosen;
    chosen.clear();
    for (int i = 0; i < 8; ++i) {
        const double angle = i * std::numbers::pi / 4;
        const Vector2d direction(std::cos(angle), std::sin(angle));
        const auto farthest =
            std::ranges::max_element(points, {}, [&](const Vector2d &point) { return point.dot(direction); });
        chosen.push_back(static_cast<int>(farthest - points.begin()));
        chosen.push_back(static_cast<int>(points.size() * static_cast<std::size_t>(i) / 8));
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// The flattest of the four triangles of four points.
Spread spreadOf(const Points &points, const std::array<int, 4> &four)
{
    Spread spread{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t left = 0; left < 4; ++left) {
        std::array<int, 3> three{};
        std::copy_if(four.begin(), four.end(), three.begin(), [&](int i) { return i != four[left]; });
        const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(three[i])]; };
        const double height = heightOfTriangle(at(0), at(1), at(2));
        if (height < spread.flatness)
            spread = {height, three};
    }
    return spread;
}

} // namespace

double extentOf(const Points &points)
{
    if (points.empty())
        return 0;
    Vector2d low = points.front(), high = points.front();
    for (const Vector2d &point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).norm();
}

std::optional<std::array<int, 2>> coincidentPoints(const Points &points)
{
    const double least = 1e-4 * extentOf(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            if ((points[i] - points[j]).norm() <= least)
                return std::array{static_cast<int>(i), static_cast<int>(j)};
        }
    }
    return std::nullopt;
}

Spread widestQuadrilateral(const Points &points, double enough)
{
    const std::vector<int> chosen = candidates(points);
    const double extent = extentOf(points);
    Spread widest{-1, {}};
    for (std::size_t a = 0; a < chosen.size() && !(widest.flatness >= enough * extent); ++a) {
        for (std::size_t b = a + 1; b < chosen.size(); ++b) {
            for (std::size_t c = b + 1; c < chosen.size(); ++c) {
                for (std::size_t d = c + 1; d < chosen.size(); ++d) {
                    const Spread spread = spreadOf(points, {chosen[a], chosen[b], chosen[c], chosen[d]});
                    if (spread.flatness > widest.flatness)
                        widest = spread;
                }
            }
        }
    }
    widest.flatness = extent > 0 ? widest.flatness / extent : 0;
    return widest;
}

} // namespace odo
