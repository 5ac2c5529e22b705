// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/body_outline.h"

#include <vector>

namespace odo {

/// The body's axis at the time of every observation of every view, in their order: from the outlines of all
/// views, smoothed over time together (as the point (cos 2α, sin 2α), which knows no jump at the half turn,
/// by the Kalman smoother that serves the positions). σ is at least that of the doubt about the outlines,
/// which does not average out. Where no outline tells, σ is larger than unknownAxisSigmaRad. Views that are
/// not registered give nothing.
std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape);

/// The same for a solid whose two ends differ, near the directions that are known (directedAxes), which tell front from back.
std::vector<std::vector<BodyAxis>> refineDirections(const std::vector<ViewTrack> &views, const SolidShape &shape,
                                                    std::vector<std::vector<BodyAxis>> directed);

} // namespace odo
