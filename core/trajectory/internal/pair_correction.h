// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// What would make two views agree.
struct PairCorrection
{
    Eigen::Vector3d turnA = Eigen::Vector3d::Zero(),
                    turnB = Eigen::Vector3d::Zero(); ///< of the cameras, world
    std::optional<Nanoseconds> since;                ///< of the turns
    double laterS = 0, laterPerS = 0, aboutS = 0;    ///< the second view was seen so much later, at aboutS
    double raiseM = 0;                               ///< of the plane, where its height is wrong
};

/// Where a ray meets the plane z = planeM after its camera was turned.
Eigen::Vector2d turnedOnPlane(const Eigen::Vector3d &cameraInWorld, const Eigen::Vector3d &rotation,
                              const Eigen::Vector2d &position, double planeM);

/// Two views with a correction applied. One whose camera moved during the run is there twice, last as it was
/// before.
std::vector<ViewTrack> correctedViews(const ViewTrack &a, const ViewTrack &b,
                                      const PairCorrection &correction);
/// Sightings of correctedViews as the views are registered and synchronised, on the plane they are on.
std::vector<std::vector<Sighting>> withoutCorrection(std::vector<std::vector<Sighting>> corrected,
                                                     const FloorView &viewA, const FloorView &viewB,
                                                     const PairCorrection &correction, double planeM);

} // namespace odo
