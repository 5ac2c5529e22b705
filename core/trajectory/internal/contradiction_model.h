// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/trajectory/internal/compared_pair.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/pair_correction.h"

#include <span>
#include <vector>

namespace odo {

/// A possible cause of a contradiction, fitted to a pair of views.
struct FittedCause
{
    ContradictionCause cause; ///< with the numbers of the pair: 0 and 1
    PairCorrection correction;
    double logEvidence = 0;  ///< against that of errors as stated
    double significance = 0; ///< root mean square of offM over that of its σ, while the cause is there
    std::vector<Eigen::Vector2d> offM;            ///< by what the fused position is off at each time
    std::vector<Eigen::Matrix2d> offCovarianceM2; ///< of that
    std::vector<double> sigmaM; ///< of the fused position as stated, both coordinates together
};

/// Which causes explain the differences of two views' positions over floor and time better than the errors
/// that are stated: those of the registrations (correlated over the floor as FloorView says), of the height,
/// of the time offset, and of the outlines (an Ornstein–Uhlenbeck process along the way, of a size that the
/// differences show themselves). All of it is one normal distribution, and so is each cause: a rotation of a
/// camera, from the beginning or from some time on, an offset, a rate, a height. Compared are the evidences,
/// the likelihood integrated over the cause's size, which has its own price for what can explain everything
/// (MacKay 1992). The large ones are fitted by Gauss–Newton steps first. a, b: at the same times, on one
/// plane. The best first; empty with fewer than 20 times in common. Pure.
std::vector<FittedCause> fitCauses(const FloorView &viewA, const FloorView &viewB,
                                   std::span<const Sighting> a, std::span<const Sighting> b,
                                   const PairPriors &priors);

} // namespace odo
