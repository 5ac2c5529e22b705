// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/polygon_moments.h"

#include <algorithm>
#include <cmath>

namespace odo {

OutlineMoments momentsOf(const std::vector<Eigen::Vector2d> &polygon)
{
    OutlineMoments moments;
    if (polygon.size() < 3)
        return moments;
    const Eigen::Vector2d origin = polygon.front(); // keeps the sums well conditioned
    double twice = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    Eigen::Vector2d p = polygon.back() - origin;
    for (const Eigen::Vector2d &point : polygon) {
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
    moments.area = std::abs(twice) / 2;
    if (moments.area <= 0)
        return moments;
    const Eigen::Vector2d mean = Eigen::Vector2d(x, y) / (3 * twice);
    moments.centre = origin + mean;
    moments.covariance << xx, xy, xy, yy;
    moments.covariance /= 12 * twice;
    moments.covariance -= mean * mean.transpose();
    return moments;
}

Ellipse ellipseOf(const Eigen::Vector2d &centrePx, const Eigen::Matrix2d &covariance)
{
    const double mean = covariance.trace() / 2, half = (covariance(0, 0) - covariance(1, 1)) / 2;
    const double spread = std::hypot(half, covariance(0, 1));
    Ellipse ellipse;
    ellipse.centrePx = centrePx;
    ellipse.semiMinorPx = 2 * std::sqrt(std::max(0.0, mean - spread));
    ellipse.semiMajorPx = 2 * std::sqrt(std::max(0.0, mean + spread));
    ellipse.angleRad = std::atan2(covariance(0, 1), half) / 2;
    return ellipse;
}

} // namespace odo
