// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/zone_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace odo {

using Eigen::Vector2d;

namespace {

constexpr double sigmasToBreach = sureSigmas;
constexpr double leastDepthM = 0.0005;

} // namespace

Vector2d nearestOnEdge(const Zone &zone, const Vector2d &point)
{
    Vector2d nearest = zone.corners.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const Vector2d &from = zone.corners[i], along = zone.corners[(i + 1) % zone.corners.size()] - from;
        const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vector2d here = from + share * along;
        if (const double distance = (point - here).squaredNorm(); distance < least) {
            least = distance;
            nearest = here;
        }
    }
    return nearest;
}

/// By the edges that a ray to the right crosses (Shimrat 1962).
bool isWithin(const Zone &zone, const Vector2d &point)
{
    bool within = false;
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
        const Vector2d &a = zone.corners[i], &b = zone.corners[(i + 1) % zone.corners.size()];
        if ((a.y() > point.y()) == (b.y() > point.y()))
            continue;
        if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            within = !within;
    }
    return within;
}

std::vector<Standing> standingsOf(const Zone &zone, ZoneSide beyond,
                                  const std::vector<MeasuredPosition> &positions)
{
    std::vector<Standing> standings;
    for (const MeasuredPosition &position : positions) {
        const Vector2d &point = position.point->position;
        const Vector2d across = point - nearestOnEdge(zone, point);
        const double depth = isWithin(zone, point) ? across.norm() : -across.norm();
        const Vector2d direction = across.norm() > 0 ? Vector2d(across.normalized()) : Vector2d(1, 0);
        standings.push_back({position.timeS, beyond == ZoneSide::Inside ? depth : -depth,
                             sigmaAlong(position.own, direction), sigmaAlong(position.common, direction),
                             position.joined});
    }
    return standings;
}

namespace {

/// The moment between two standings at which the shifted edge is crossed, and its variance.
double edgeCrossing(const Standing &a, const Standing &b, double shiftM, double &variance)
{
    const double rise = b.beyondM - a.beyondM, share = (shiftM - a.beyondM) / rise;
    const double step = b.timeS - a.timeS;
    const double ownM = (1 - share) * a.ownM + share * b.ownM;
    // A track that touches the edge without speed across it is not known to better than the frames around,
    // times a few.
    const double sigmaS = std::min(ownM * step / std::abs(rise), 10 * step);
    variance = sigmaS * sigmaS;
    return a.timeS + share * step;
}

/// How far beyond an edge is surely beyond it.
double sureDepthM(const Standing &standing)
{
    return std::max(leastDepthM, sigmasToBreach * standing.ownM);
}

} // namespace

std::vector<Stretch> stretchesBeyond(const std::vector<Standing> &standings, double shiftM)
{
    std::vector<Stretch> stretches;
    std::optional<Stretch> open;
    bool isWithin = false; // it may have come back from the open one
    const auto close = [&] {
        if (open->sure)
            stretches.push_back(*open);
        open.reset();
    };
    for (std::size_t i = 0; i < standings.size(); ++i) {
        const Standing &here = standings[i];
        const double beyondM = here.beyondM - shiftM;
        const Standing *before = i > 0 && here.joined ? &standings[i - 1] : nullptr;
        if (open && !before) {
            if (!isWithin)
                open->toS = standings[i - 1].timeS;
            close();
        }
        if (beyondM > 0 && !open) {
            open = Stretch{here.timeS, here.timeS, i, i};
            if (before)
                open->fromS = edgeCrossing(*before, here, shiftM, open->beginVariance);
        } else if (beyondM <= 0 && open && !isWithin) {
            open->toS = edgeCrossing(*before, here, shiftM, open->endVariance);
        }
        isWithin = beyondM <= 0;
        if (!open)
            continue;
        if (here.beyondM > standings[open->deepest].beyondM)
            open->deepest = i;
        open->sure = open->sure || beyondM > sureDepthM(here);
        if (beyondM < -sureDepthM(here))
            close();
    }
    if (open) {
        if (!isWithin)
            open->toS = standings.back().timeS;
        close();
    }
    return stretches;
}

double timeOf(const std::vector<Stretch> &stretches)
{
    double time = 0;
    for (const Stretch &stretch : stretches)
        time += stretch.toS - stretch.fromS;
    return time;
}

double commonSigmaM(const std::vector<Standing> &standings)
{
    double largest = 0;
    for (const Standing &standing : standings)
        largest = std::max(largest, standing.commonM);
    return largest;
}

namespace {

/// The track's own, where the robot may be on the edge.
double ownSigmaM(const std::vector<Standing> &standings)
{
    double largest = 0;
    for (const Standing &standing : standings)
        if (std::abs(standing.beyondM) <= sigmasToBreach * standing.ownM)
            largest = std::max(largest, standing.ownM);
    return largest;
}

/// By how much the time changes, to either side, when the edge is shifted.
double changeOfTime(const std::vector<Standing> &standings, double shiftM)
{
    return std::abs(timeOf(stretchesBeyond(standings, -shiftM)) -
                    timeOf(stretchesBeyond(standings, shiftM))) /
           2;
}

} // namespace

StretchTimeSigma sigmaOfTime(const std::vector<Standing> &standings, const std::vector<Stretch> &stretches)
{
    double crossings = 0, variance = 0;
    for (const Stretch &stretch : stretches) {
        crossings += (stretch.beginVariance > 0) + (stretch.endVariance > 0);
        variance += stretch.beginVariance + stretch.endVariance;
    }
    // Of a robot that is parked on an edge its crossings say too little.
    return {std::max(variance,
                     std::pow(changeOfTime(standings, ownSigmaM(standings)), 2) / std::max(1.0, crossings)),
            changeOfTime(standings, commonSigmaM(standings))};
}

} // namespace odo
