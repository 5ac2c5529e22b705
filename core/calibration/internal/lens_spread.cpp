// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_spread.h"

#include <algorithm>

namespace odo {

Eigen::MatrixXd covarianceOf(const Intrinsics &lens, const LensSpread &spread)
{
    const auto size = Eigen::Index(4 + lens.distortion.size());
    const auto squared = [](double value) { return value * value; };
    const double side = std::max(lens.widthPx, lens.heightPx);
    Eigen::VectorXd variances = Eigen::VectorXd::Zero(size), both = Eigen::VectorXd::Zero(size);
    both.head<2>() << lens.fxPx, lens.fyPx;
    variances.head<2>() = (0.5 * spread.aspect * both.head<2>()).cwiseAbs2();
    variances.segment<2>(2).setConstant(squared(spread.centre * side));
    if (size > 4)
        variances(4) = squared(spread.k1);
    Eigen::MatrixXd covariance = variances.asDiagonal();
    return covariance + squared(spread.focal) * both * both.transpose();
}

} // namespace odo
