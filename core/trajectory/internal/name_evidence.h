// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/name_assignment.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace odo {

/// A stretch of one robot's observations in one view in which it surely stays the same thing: found in every
/// frame with a usable score. Between two of them it was lost, or merged with another robot in the frame, and
/// may have been mistaken for another one.
struct Tracklet
{
    struct End
    {
        double timeS = 0; ///< on the first view's clock
        Eigen::Vector2d positionPx = Eigen::Vector2d::Zero(), velocityPxPerS = Eigen::Vector2d::Zero();
        double radiusPx = 0; ///< of the circle of the region's area
    };
    std::size_t first = 0, last = 0; ///< indices of observations, both inside
    End begin, end;
    Eigen::Vector2d meanChroma = Eigen::Vector2d::Zero(); ///< zero where unknown
};

/// Whether an observation surely shows one robot, whichever. Below this score it may be a part of one, or
/// several.
bool isSure(const Observation &observation);

/// Cuts a robot's observations (in order of time) into tracklets. Stretches of fewer than three frames are
/// left out: they show no motion.
std::vector<Tracklet> cutIntoTracklets(const std::vector<Observation> &observations, const ViewClock &clock);

/// What speaks against one robot having run from the end of one tracklet to the begin of a later one: half
/// the squared standard deviations, capped, of where both motions put it halfway and of the change of
/// velocity. Allows for an acceleration of some two metres per second squared of a robot of the usual size.
double costOfJoining(const Tracklet::End &end, const Tracklet::End &begin);

/// One tracklet of one view; slot is the tracker's robot, among those considered, and behind them what else
/// was followed.
struct TrackletOf
{
    std::size_t view = 0, slot = 0;
    Tracklet tracklet;
    double likeness = 1; ///< to a robot, 0 to 1: it moves over the floor, and stays within the frame
    std::optional<std::size_t> pointedOut; ///< the robot, among those considered, that a person says it is
    /// of a square of its area at its floor position, the median; 0 where that is not known
    double sizeM = 0;
};

/// Where a slot's robot is on the floor, as a line: seen at the height h it is at onFloor + h·perMetreHeight.
struct FloorSight
{
    bool seen = false;
    /// of the evidence, that was seen there; none where it is too short for one
    std::optional<std::size_t> tracklet;
    Eigen::Vector2d onFloor = Eigen::Vector2d::Zero(), perMetreHeight = Eigen::Vector2d::Zero();
    double sizeM = 0; ///< of a square of its area there

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

/// What there is to decide the names of some robots from.
struct NameEvidence
{
    /// of each view: one for each robot, in order, and then one for each other thing
    std::vector<std::size_t> slots;
    std::vector<TrackletOf> tracklets; ///< in order of their begin
    std::vector<FloorMoment> moments;  ///< every 50 ms, where at least two views saw anything; in order
    std::vector<double> hueShiftRad;   ///< for each view, of all its robots against their given colours
    std::vector<std::optional<double>> givenHueRad; ///< for each robot; none if no colour is given
    std::vector<std::pair<std::size_t, std::size_t>> nothingThere; ///< as of NameOutcome
};

/// considered: indices of robots. Only robots without a given colour may be something else that was followed.
NameEvidence gatherEvidence(const std::vector<NamedView> &views, const std::vector<NamedRobot> &robots,
                            const std::vector<std::size_t> &considered);

/// What a slot of a view holds. considered: as of gatherEvidence.
const std::vector<Observation> &observationsOf(const NamedView &view,
                                               const std::vector<std::size_t> &considered, std::size_t slot);

/// Of the given colour, if there is one.
std::optional<double> givenHue(const NamedRobot &robot);

/// Hue of a chroma, and the distance of two in (−π, π].
double hueOf(const Eigen::Vector2d &chroma);
double hueDifference(double a, double b);

} // namespace odo
