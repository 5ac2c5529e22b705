// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/floor_lens.h"
#include "core/calibration/internal/registration_causes.h"
#include "core/calibration/internal/residual_pattern.h"

#include <optional>

namespace odo {

/// A camera at an impossible height is told the layout's likely unit.
Message unitAdvice(double heightM);

/// A sentence on a lens that was estimated from floor points (fitFloorLens), or that they hardly determine.
Message lensWords(const Intrinsics &lens);

/// What a verdict is made of. References live as long as the call.
struct RegistrationFacts
{
    const FloorRegistration &registration;
    const FloorView &view;
    const MarkerLayout &layout;
    const TriedMarkers &tried;
    const PlanePose &pose;
    const std::optional<FloorLens> &estimatedLens; ///< where none was calibrated
    const ResidualJudgement &residuals;
};

/// The sentences of FloorRegistration::verdict. Its level follows the misfit and the σ of the floor over the
/// whole layout, and is never "Good" over residuals with a pattern.
Message registrationWords(const RegistrationFacts &facts);

} // namespace odo
