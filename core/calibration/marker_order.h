// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/plane_pose.h"

#include <span>
#include <string>

namespace odo {

/// Looks for the mistake in labels that do not fit: each exchange of two labels, and for four markers each
/// order, is fitted. Returns words such as "with U and V exchanged they fit to 0.3 px", for every exchange
/// that fits to within fitPx, with semicolons between them; empty where nothing helps. The camera is taken to
/// be above the floor.
std::string betterOrder(std::span<const PointPair> pairs, const CameraModel &camera, FocalLength focal,
                        double fitPx);

} // namespace odo
