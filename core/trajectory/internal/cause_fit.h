// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/pair_errors.h"

#include <vector>

namespace odo {

/// A cause fitted to a pair of views.
struct CauseFit
{
    CauseModel model;
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance; ///< of them
    double logEvidence = 0;
};

/// Each possible cause, from the beginning or from some time on, fitted by Gauss–Newton steps; the likeliest
/// first. isFirstLook: fewer steps and times. The evidence is that of the likelihood integrated over the
/// cause's size.
std::vector<CauseFit> fitAllCauses(const ComparedPair &pair, const PairErrors &errors, bool isFirstLook);

} // namespace odo
