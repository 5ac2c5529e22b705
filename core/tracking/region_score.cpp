// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/region_score.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

double bellOf(double x)
{
    return std::exp(-0.5 * x * x);
}

double compactness(const Eigen::Matrix2d &covariance, double area)
{
    const double determinant = covariance.determinant();
    if (determinant <= 0)
        return 0;
    const double fill = area / (4 * std::numbers::pi * std::sqrt(determinant));
    const double solid = std::clamp((fill - 0.5) / 0.35, 0.0, 1.0);
    const double halfTrace = covariance.trace() / 2;
    const double spread = std::sqrt(std::max(0.0, halfTrace * halfTrace - determinant));
    const double longOverShort = std::sqrt((halfTrace + spread) / std::max(halfTrace - spread, 1e-9));
    return solid * bellOf(std::max(0.0, longOverShort - 4.0) / 1.5);
}

double sizeLikelihood(double fractionOfPicture)
{
    constexpr double small = 1e-4, large = 0.2;
    return fractionOfPicture / (fractionOfPicture + small) *
           bellOf(std::max(0.0, fractionOfPicture - large) / 0.1);
}

} // namespace odo
