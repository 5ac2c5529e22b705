// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/floor_view.h"
#include "core/geometry/region_moments.h"

#include <Eigen/Core>
#include <optional>

namespace odo {

/// The coloured solid of a robot: an upright box or cylinder between two heights above the floor. A plate on
/// a robot of another colour has equal heights. Metres.
struct SolidShape
{
    enum class Form { Box, Cylinder };
    Form form = Form::Box;
    double lengthM = 0, widthM = 0; ///< along and across the heading; of a cylinder both are the diameter
    double baseM = 0, topM = 0;     ///< above the floor
};

/// What a view sees of the solid whose footprint's centre stands at a place of the floor, its length turned
/// by headingRad from the world's X: the moments of the outline that its projected edges enclose (for a
/// convex solid the convex hull of its corners; a circle is taken as 24 corners of the same area). Edges
/// count as straight between corners: over the size of a robot a lens bends them by less than 0.05 px.
/// nullopt: a corner lies behind the camera, or where the lens model folds.
std::optional<RegionMoments> silhouetteMoments(const FloorView &view, const SolidShape &shape,
                                               const Eigen::Vector2d &positionInWorld, double headingRad);

} // namespace odo
