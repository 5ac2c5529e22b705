// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/motion_stretches.h"
#include "core/analysis/task.h"

#include <cstddef>
#include <vector>

namespace odo {

/// How a position of a track relates to a zone: its distance beyond the edge, inwards (Side::Inside) or
/// outwards, by the rule of ZoneRule.
struct Standing
{
    double timeS = 0;
    double beyondM = 0;           ///< above zero: beyond the edge by so much
    double ownM = 0, commonM = 0; ///< σ across the nearest edge
    bool joined = false;
};

/// beyond: which side of the edge is meant.
enum class ZoneSide { Inside, Outside };
std::vector<Standing> standingsOf(const Zone &zone, ZoneSide beyond,
                                  const std::vector<MeasuredPosition> &positions);

/// A stretch beyond a shifted edge.
struct Stretch
{
    double fromS = 0, toS = 0;
    std::size_t deepest = 0, first = 0;        ///< standings
    double beginVariance = 0, endVariance = 0; ///< s², of its two moments by the track's own noise
    bool sure = false;
};

/// Where the track is beyond an edge that lies by shift further out. A stretch ends where the robot surely is
/// back: a robot that is parked on the edge, to and fro by noise, is beyond it once.
std::vector<Stretch> stretchesBeyond(const std::vector<Standing> &standings, double shiftM);

double timeOf(const std::vector<Stretch> &stretches);

/// σ of that time: half of its difference when the edge moves in or out by the calibration's σ, and at each
/// end the track's own noise over the speed across the edge, as independent, or half of the difference by
/// that noise.
struct StretchTimeSigma
{
    double ownVariance = 0, commonS = 0;
};
StretchTimeSigma sigmaOfTime(const std::vector<Standing> &standings, const std::vector<Stretch> &stretches);

/// The largest of the calibration's σ across the edge.
double commonSigmaM(const std::vector<Standing> &standings);

/// Of a zone's outline the point that is nearest; whether a point is within it.
Eigen::Vector2d nearestOnEdge(const Zone &zone, const Eigen::Vector2d &point);
bool isWithin(const Zone &zone, const Eigen::Vector2d &point);

} // namespace odo
