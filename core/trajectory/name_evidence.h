// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/name_assignment.h"
#include "core/trajectory/tracklets.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// One tracklet of one view; slot is the tracker's robot, among those considered.
struct TrackletOf
{
    std::size_t view = 0, slot = 0;
    Tracklet tracklet;
};

/// Where a slot's robot is on the floor, as a line: seen at the height h it is at onFloor + h·perMetreHeight.
struct FloorSight
{
    bool seen = false;
    std::optional<std::size_t> tracklet; ///< of the evidence, that was seen there; none where it is too short for one
    Eigen::Vector2d onFloor = Eigen::Vector2d::Zero(), perMetreHeight = Eigen::Vector2d::Zero();

    Eigen::Vector2d at(double heightM) const { return onFloor + heightM * perMetreHeight; }
};

/// All slots of all registered views at one time: sights[view][slot].
struct FloorMoment
{
    double timeS = 0;
    std::vector<std::vector<FloorSight>> sights;
};

/// Calls look(one, other) with each two sights of two views that show a tracklet each.
template <class Look>
void forEachTwo(const FloorMoment &moment, const Look &look)
{
    for (std::size_t a = 0; a < moment.sights.size(); ++a)
        for (std::size_t b = a + 1; b < moment.sights.size(); ++b)
            for (const FloorSight &one : moment.sights[a])
                for (const FloorSight &other : moment.sights[b])
                    if (one.tracklet && other.tracklet)
                        look(one, other);
}

/// What there is to decide the names of some robots from. Slots index the robots given, in all views.
struct NameEvidence
{
    std::vector<TrackletOf> tracklets; ///< in order of their begin
    std::vector<FloorMoment> moments;  ///< every 50 ms, where at least two views saw anything; in order
    std::vector<double> hueShiftRad;   ///< for each view, of all its robots against their told colours
    std::vector<std::optional<double>> toldHueRad; ///< for each robot; none where no colour was told
};

/// robots: indices of those considered.
NameEvidence gatherEvidence(const std::vector<NamedView> &views, const std::vector<NamedRobot> &robots,
                            const std::vector<std::size_t> &considered);

/// Of the colour that was told, if one was.
std::optional<double> toldHue(const NamedRobot &robot);

/// Hue of a chroma, and the distance of two in (−π, π].
double hueOf(const Eigen::Vector2d &chroma);
double hueDifference(double a, double b);

} // namespace odo
