// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

void addToChain(std::vector<Eigen::Vector2d> &points, std::size_t first, double turn,
                const Eigen::Vector2d &point)
{
    while (points.size() >= first + 2 &&
           turn * cross(points.back() - points[points.size() - 2], point - points.back()) <= 0)
        points.pop_back();
    points.push_back(point);
}

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Eigen::Vector2d> hull;
    const auto addChain = [&hull](auto begin, auto end) {
        const std::size_t first = hull.size();
        for (auto point = begin; point != end; ++point)
            addToChain(hull, first, 1, *point);
        hull.pop_back(); // it begins the other chain
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

RegionMoments polygonMoments(const std::vector<Eigen::Vector2d> &corners)
{
    RegionMoments moments;
    if (corners.size() < 3)
        return moments;
    const Eigen::Vector2d &origin = corners.front(); // keeps the sums well conditioned
    double twice = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    Eigen::Vector2d p = corners.back() - origin;
    for (const Eigen::Vector2d &point : corners) {
        const Eigen::Vector2d q = point - origin, s = p + q;
        const double cross = p.x() * q.y() - p.y() * q.x();
        twice += cross;
        x += cross * s.x();
        y += cross * s.y();
        xx += cross * (p.x() * p.x() + q.x() * q.x() + s.x() * s.x());
        xy += cross * (p.x() * p.y() + q.x() * q.y() + s.x() * s.y());
        yy += cross * (p.y() * p.y() + q.y() * q.y() + s.y() * s.y());
        p = q;
    }
    moments.areaPx2 = std::abs(twice) / 2;
    if (moments.areaPx2 <= 0)
        return moments;
    const Eigen::Vector2d mean = Eigen::Vector2d(x, y) / (3 * twice);
    moments.centrePx = origin + mean;
    moments.covariancePx2 << xx, xy, xy, yy;
    moments.covariancePx2 /= 12 * twice;
    moments.covariancePx2 -= mean * mean.transpose();
    return moments;
}

} // namespace odo
