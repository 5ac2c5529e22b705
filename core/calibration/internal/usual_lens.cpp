// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/usual_lens.h"

#include "core/calibration/internal/lens_spread.h"

#include <algorithm>

namespace odo {

namespace {

// One σ each, beyond those of assumedLensSpread; that of k2 is about k2ByK1 · k1.
constexpr double k2Spread = 0.2;
constexpr double tangentialSpread = 0.003, k3Spread = 0.1;

} // namespace

UsualLens usualLens(const Intrinsics &lens, double sigmaPx)
{
    constexpr Eigen::Index size = intrinsicsSize(LensModel::Standard);
    const double side = std::max(lens.widthPx, lens.heightPx);
    UsualLens usual{Eigen::MatrixXd::Zero(size - 1, size), Eigen::VectorXd::Zero(size)};
    const double aspect = 1 / (assumedLensSpread.aspect * lens.fxPx);
    const double centre = 1 / (assumedLensSpread.centre * side);
    usual.weights.topLeftCorner<1, 2>() << aspect, -aspect;
    Eigen::VectorXd diagonal(size - 2);
    diagonal << centre, centre, 1 / assumedLensSpread.k1, 1 / k2Spread, 1 / tangentialSpread,
        1 / tangentialSpread, 1 / k3Spread;
    usual.weights.bottomRightCorner(size - 2, size - 2) = diagonal.asDiagonal();
    usual.weights(4, 4) = -k2ByK1 / k2Spread;
    usual.weights *= sigmaPx;
    usual.values.segment<2>(2) << 0.5 * (lens.widthPx - 1), 0.5 * (lens.heightPx - 1);
    return usual;
}

} // namespace odo
