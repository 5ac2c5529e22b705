// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/trajectory/internal/pair_correction.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace odo {

inline constexpr Eigen::Index rotationParameters = 3;

/// A kind of cause with its parameters, in this order: rotations of the views, an offset and a rate, a
/// height.
struct CauseModel
{
    ContradictionCause::Kind kind = ContradictionCause::Kind::CameraMoved;
    bool rotatesA = false, rotatesB = false, shiftsTime = false, changesRate = false, raises = false;
    std::optional<double> sinceS = {}; ///< of the rotation
    std::vector<double> scales = {};   ///< factors of the standard deviations to try
    std::vector<double> sigmas = {};   ///< of the parameters, at a factor of one

    Eigen::Index size() const { return static_cast<Eigen::Index>(sigmas.size()); }
};

/// Each kind of cause that lasts the whole run. isHeightGiven: the plane's height, and not estimated from the
/// positions that are compared.
std::vector<CauseModel> lastingCauses(bool isHeightGiven);

/// What would make the views agree by a cause of this size. aboutS: of an offset that grows.
PairCorrection correctionBy(const CauseModel &model, const Eigen::VectorXd &parameters, double aboutS);

} // namespace odo
