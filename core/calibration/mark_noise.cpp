// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/mark_noise.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double priorFreedom = 4;
constexpr double refutedBeyond = 3; // times the prior

} // namespace

double markSigmaPx(double squaresPx2, double freedom)
{
    freedom = std::max(0.0, freedom);
    if (freedom >= 1 && std::sqrt(squaresPx2 / freedom) > refutedBeyond * usualMarkSigmaPx)
        return std::sqrt(squaresPx2 / freedom);
    return std::sqrt((priorFreedom * usualMarkSigmaPx * usualMarkSigmaPx + squaresPx2) /
                     (priorFreedom + freedom));
}

} // namespace odo
