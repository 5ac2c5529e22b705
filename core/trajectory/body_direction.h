// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/body_outline.h"
#include "core/trajectory/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// Which end of a body is its front: the axes of a run, which outlines tell modulo π, each turned by half a turn where needed so that the body
/// turns on without a jump, and moves forward rather than backward over each stretch in which its axis was known throughout. Of a robot that
/// moves only backward the rear is called its front, always alike. axes, sightings: of every observation of every view (trackAxis, placeBody).
std::vector<std::vector<BodyAxis>> directedAxes(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
                                                std::vector<std::vector<BodyAxis>> axes);

/// The directions of a body that moves along its length, as wheels make it: at each observation of each view that of the motion, from the places within
/// a fifth of a second around, or the end of the axis that is near it; unknown where it hardly moves. Guesses to begin with, where outlines do not tell the
/// axis well.
std::vector<std::vector<BodyAxis>> directionsOfMotion(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
                                                      const std::vector<std::vector<BodyAxis>> &axes);

/// How a body moves at a time.
struct BodyMotion
{
    double directionRad = 0; ///< of the velocity
    double curvature = 0;    ///< of the path, 1/m; positive to the left
};

/// From the places within a quarter of a second around, of all views, each by a parabola over time. nullopt: too few, or it hardly moves. Pure.
std::optional<BodyMotion> motionAt(const std::vector<std::vector<Sighting>> &sightings, Nanoseconds time);

} // namespace odo
