// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/plane_pose.h"

#include <span>

namespace odo {

/// What the markers' residuals follow beyond chance.
struct ResidualJudgement
{
    ResidualPattern pattern = ResidualPattern::None;
    /// One marker alone is off; the others are sound.
    bool isOneMarker = false;
    Message words; ///< a sentence with what to do; empty where nothing is found
};

/// Looks for a cause that explains the residuals of a fit: another lens, a layout whose two sides were
/// measured with different scales or not square to one another, one wrong marker, or else neighbours that
/// err alike. Each cause adds columns to the fit's linear model, and counts where it lowers the sum of the
/// squares more than 1 in 30,000 drawn errors would (F test; its tail by Paulson's normal approximation, Ann.
/// Math. Stat. 13, 1942) and by more than a marker's usual error; of several the one with
/// the smallest Bayesian information criterion is named. Too few markers, 8 where the lens was known and 12
/// where it was estimated from them, are not judged, except that from 6 markers on under a
/// known lens a wrong one is sought; of it a marker's usual error counts as four residuals more. pairs: floor
/// position, metres, and pixel. Pure; any thread.
ResidualJudgement judgeResiduals(std::span<const PointPair> pairs, const PlanePose &pose,
                                 bool intrinsicsKnown);

} // namespace odo
