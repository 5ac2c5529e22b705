// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/body_outline.h"
#include "core/trajectory/internal/floor_positions.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace odo {

/// The directions of a body that moves along its length, as wheels make it: at each observation of each view
/// that of the motion, from the positions within a fifth of a second around, or the end of the axis that is
/// near it; unknown where it hardly moves. Guesses to begin with, where outlines do not determine the axis
/// well.
std::vector<std::vector<BodyAxis>> directionsOfMotion(const std::vector<ViewTrack> &views,
                                                      const std::vector<std::vector<Sighting>> &sightings,
                                                      const std::vector<std::vector<BodyAxis>> &axes);

/// How a body moves at a time.
struct BodyMotion
{
    double directionRad = 0; ///< of the velocity
    double curvature = 0;    ///< of the path, 1/m; positive to the left
};

/// From the positions within a quarter of a second around, of all views, each by a parabola over time.
/// nullopt: too few, or it hardly moves. Pure.
std::optional<BodyMotion> motionAt(const std::vector<std::vector<Sighting>> &sightings, Nanoseconds time);

/// The axis that one outline shows, before smoothing.
struct MeasuredAxis
{
    std::uint32_t view = 0, observation = 0;
    BodyAxis axis;
};

/// The body's axis at the time of every observation of every view, in their order: from the outlines of all
/// views, smoothed over time together (as the point (cos 2α, sin 2α), which knows no jump at the half turn,
/// by the Kalman smoother that serves the positions). σ is at least the uncertainty of the outlines, which
/// does not average out. Where no outline shows the axis, σ is larger than unknownAxisSigmaRad. Views that
/// are not registered give nothing. measured: is given what was smoothed, in order of time.
std::vector<std::vector<BodyAxis>> trackAxis(const std::vector<ViewTrack> &views, const SolidShape &shape,
                                             std::vector<MeasuredAxis> *measured = nullptr);

/// Position and direction of a body at a time.
struct BodyPose
{
    Nanoseconds time{0}; ///< of the first view's clock
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    double headingRad = 0;
};

/// The same of a solid whose two ends differ, as the supports of its outlines show it (positionBySupport):
/// followed from observation to observation, from the poses that are known, of which there is at least one,
/// in order. Directions modulo 2π.
std::vector<std::vector<BodyAxis>> trackDirection(const std::vector<ViewTrack> &views,
                                                  const SolidShape &shape,
                                                  const OutlineDifference &difference,
                                                  const std::vector<BodyPose> &poses,
                                                  std::vector<MeasuredAxis> *measured = nullptr);

/// Angles of half a turn that a body's axis is searched at.
constexpr std::size_t axisBins = 48;
double angleOfBin(std::size_t bin);

/// How badly each angle explains an outline: squared misfit in σ².
using AxisCosts = std::array<float, axisBins>;

/// One time of a run: what an outline says of the axis, or nothing.
struct AxisEvidence
{
    double timeS = 0;
    std::optional<AxisCosts> costs;
};

/// The angles of the likeliest turning through all times (Viterbi 1967): an outline seen face on fits two
/// angles mirrored about it nearly as well, and only what comes before and after shows which. A body turns at
/// some 4 rad/s (σ); an outline costs at most 25, so a wrong one is overridden. One bin for each of `times`
/// times, whose evidence is asked for once each, in their order.
std::vector<std::uint8_t> likeliestPath(std::size_t times,
                                        const std::function<AxisEvidence(std::size_t)> &evidenceAt);

} // namespace odo
