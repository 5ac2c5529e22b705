// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"

#include <vector>

namespace odo {

/// A flat piece of one thing, at one moment of the exposure.
struct PaintedPiece
{
    std::vector<Eigen::Vector2d> outline; ///< luma pixels
    Rgb colour;
    double weight = 1; ///< share of the exposure, or opacity
};

/// A thing in the frame that is not always there, or moves: all its pieces are painted as one layer.
struct PaintedThing
{
    std::vector<PaintedPiece> pieces;
    PixelRect bounds;
};

/// Everything that moves or comes and goes, as a camera sees it in an exposure about a time, from the
/// farthest to the nearest: reflections, mirror images, shadows, robots and bystanders, occluders.
std::vector<PaintedThing> thingsInExposure(const SimulatedScene &scene, int camera,
                                           const ImageOutline &outline, double timeS);

/// Mean of the room's light over an exposure about a time, 1 where nothing changes it.
double lightInExposure(const std::vector<LightChange> &lights, double exposureS, double timeS);

/// Mean of the light's gain over an exposure about a time: drift and flicker.
double gainInExposure(const SensorModel &sensor, double timeS);

} // namespace odo
