// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/region_moments.h"

#include <cmath>

namespace odo {

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
