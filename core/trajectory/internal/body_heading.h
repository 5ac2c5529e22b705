// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/trajectory/internal/body_direction.h"

#include <optional>
#include <vector>

namespace odo {

/// Which end of a body is its front: the axes of a run, which outlines show modulo π, each turned by half a
/// turn where needed so that the body turns on without a jump over each stretch in which its axis was known
/// throughout, also where it reverses. It is assumed to move forwards at first, unless more than two
/// thirds of its path would be backwards. Of a robot that moves only backward the rear is called its front,
/// always alike. axes, sightings: of every observation of every view (trackAxis, positionBody). Pure.
std::vector<std::vector<BodyAxis>> directedAxes(const std::vector<ViewTrack> &views,
                                                const std::vector<std::vector<Sighting>> &sightings,
                                                std::vector<std::vector<BodyAxis>> axes);

/// What is known of a body's axis over a run.
struct TrackedBody
{
    SolidShape shape;
    bool isLengthGiven = false;                   ///< then it points ahead; else it may be the wider side
    std::vector<std::vector<BodyAxis>> axes = {}; ///< smoothed, of every observation of every view
    std::vector<MeasuredAxis> measured = {};      ///< before smoothing
    double shapeSigmaRad = 0;                     ///< what the body's unknown shape leaves of the heading
};

/// The body's heading at each observation of the first view, from the axes that the outlines of all views
/// show next to it in time; directed as by directedAxes. A body whose size is not given is assumed to move
/// along its width, if it mostly does. nullopt where no outline shows it, and everywhere for one that is
/// nearly square and moves along no side of it. With unknownFrontSigmaRad in a stretch in which it does not
/// move along. Pure.
std::vector<std::optional<MeasuredHeading>>
headingsOfBody(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
               const TrackedBody &body);

} // namespace odo
