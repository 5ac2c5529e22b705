// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/round_markers.h"
#include "core/geometry/floor_view.h"

#include <optional>

namespace odo {

/// The picture of a dot's middle: its outline laid on the floor is a circle again, whose middle is seen where
/// it is. outline: of the dot in the picture of view. nullopt where the outline reaches beyond the horizon.
/// Thread-safe.
std::optional<Eigen::Vector2d> dotCentre(const EllipseOutline &outline, const FloorView &view);

} // namespace odo
