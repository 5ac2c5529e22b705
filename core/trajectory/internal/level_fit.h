// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/body_direction.h"
#include "core/trajectory/internal/body_outline.h"

#include <optional>
#include <vector>

namespace odo {

/// A guess that a fit begins with, for it ends in the solid that is next to it.
struct LevelStart
{
    /// by how much the lowest level is larger than the middle one, and that than the highest, as a share
    double taper = 0;
    double topShift = 0; ///< of the highest level along the heading, as a share of the length
};

struct LevelFit
{
    SolidShape shape;   ///< Form::Levels
    double widerPx = 0; ///< by how much all outlines are drawn too wide
    double misfit = 0;  ///< RMS of what it leaves of the supports, over their σ of half a pixel
    double sigmaTopM = 0;
    double lastingPx = 0;        ///< RMS of what the solid leaves of the outlines' centroids
    std::vector<BodyPose> poses; ///< at the times it was fitted to, in order
};

/// The outlines that a solid of levels is fitted to.
std::vector<CommonOutlines> levelTimes(const std::vector<ViewTrack> &views);

/// The convex solid of three levels whose silhouettes a robot's outlines are, where a box is not enough:
/// clearance, a chassis, wheels, a narrower upper part, round corners. Fitted together with a pose for each
/// of some forty times by weighted least squares of the outlines' supports over all views (Ceres, Cauchy's
/// loss), from the box that is known and the directions that the body then had. The convex hull of a
/// silhouette is the silhouette of the body's convex hull, so only outlines that are hulls tell the body of a
/// robot with wheels and gaps. What was told of its height and size is kept. axes: directed (directedAxes).
/// sightings: where the box was seen; the heading of what moves is mostly along its way (motionAt). nullopt:
/// too few outlines, or nothing better was found. Pure. times: levelTimes(views), which several fits share.
std::optional<LevelFit> fitLevels(const std::vector<CommonOutlines> &times,
                                  const std::vector<ViewTrack> &views,
                                  const std::vector<std::vector<BodyAxis>> &axes,
                                  const std::vector<std::vector<Sighting>> &sightings, const SolidShape &box,
                                  const RobotShape &told, const LevelStart &start);

} // namespace odo
