// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/observation.h"

#include <algorithm>
#include <cmath>

namespace odo {

void ShadowAmbiguity::addPart(const ShadowAmbiguity &part, float share)
{
    deep += share * part.deep;
    tinted += share * part.tinted;
    light += share * part.light;
    near += share * part.near;
    apart += share * part.apart;
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
