// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"

#include <optional>
#include <vector>

namespace odo {

/// Curves that quantityValues derives from more than one number of a point; as it describes them. Pure.

std::optional<CurveValue> lateralAccelerationOf(const ProfilePoint &point);
std::vector<std::optional<CurveValue>> jerkValues(const Profile &profile);
std::vector<std::optional<CurveValue>> distanceValues(const Profile &profile);
std::vector<std::optional<CurveValue>> displacementValues(const Profile &profile);
std::vector<std::optional<CurveValue>> separationValues(const Profile &profile, OtherProfiles others);

} // namespace odo
