// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"

#include <Eigen/Core>

namespace odo {

/// The ellipse about a centre that has these second moments.
Ellipse ellipseOf(const Eigen::Vector2d &centrePx, const Eigen::Matrix2d &covariance);

} // namespace odo
