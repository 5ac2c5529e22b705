// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/geometry/floor_view.h"
#include "core/tracking/observation.h"

#include <optional>
#include <utility>
#include <vector>

namespace odo {

/// The properties of a robot that help to distinguish it.
struct NamedRobot
{
    std::optional<RgbColour> colour; ///< given
    std::optional<double> heightM;   ///< of its top; empty: estimated
};

/// Where a person says that a robot is in one frame of a view.
struct PointedOut
{
    std::size_t robot = 0;
    std::int64_t frame = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// What one view saw of all robots.
struct NamedView
{
    std::optional<FloorView> floorView; ///< empty: not registered; motion and colour alone decide
    Nanoseconds startOffset{0};         ///< how much later its first frame was taken than the first view's
    std::vector<std::vector<Observation>>
        robots; ///< for each robot its observations; equally many, of equal frames
    /// likewise of the other followed things, which may be robots without a given colour
    std::vector<std::vector<Observation>> others = {};
    double clockRate = 0; ///< by how much its clock runs faster than the first view's
    std::vector<PointedOut> pointedOut = {};
};

/// An interval after which it is ambiguous which robot is which.
struct NameAmbiguity
{
    std::size_t robot = 0;
    double fromS = 0, toS = 0; ///< of the first view's clock
    /// that it may be from then on, in order; empty where that is not known
    std::vector<std::size_t> others = {};
};

struct NameOutcome
{
    std::int64_t renamed = 0;               ///< observations (found ones) that changed their robot
    std::vector<NameAmbiguity> ambiguities; ///< in order, those of a robot apart from one another
    /// view and number of what was pointed out where nothing was followed
    std::vector<std::pair<std::size_t, std::size_t>> nothingThere;
};

/// The robots in groups whose given colours might be mistaken for one another, and those without a colour; a
/// robot of a colour of its own is a group.
std::vector<std::vector<std::size_t>> robotsOfLikeColours(const std::vector<NamedRobot> &robots);

/// Decides which robot is which, in all views at once, where colours alone may fail: robots that overlap in
/// one view are usually apart in another, so their floor positions distinguish them.
///
/// The tracker follows each view by itself, from frame to frame. Its observations are cut into tracklets
/// wherever a robot was lost or had merged with another in the frame (score below 0.2). Each tracklet then
/// gets the name under which all of it is cheapest (or none, where a view followed more than the robots): the
/// views agree on the floor, each name's motion goes on from tracklet to tracklet, and the tracklets' mean
/// hues fit the given colours (but for a shift common to the view's robots). Solved by dynamic programming
/// along time over the views' naming, kept to the best few hundred (exact for two or three robots). A second
/// round knows each robot's height and appearance from the first one, for each view.
///
/// Only robots whose given hues are within 40° of each other are ever renamed, at most eight of them; of
/// equal colours no one can say which is which, but the names stay the same throughout and in all views.
///
/// Made before the observations are stored: the share-out of observations among names is a decision of the
/// tracking, needs the tracker's mean chroma, which is not kept, and all who read the project later must see
/// the same names. Observations themselves are not changed, only moved between robots, all of a frame's
/// staying in their frame. Where another way to name the tracklets explains them nearly as well, the time
/// between the two that it would not join is ambiguous. Pure and thread-safe.
NameOutcome assignNames(std::vector<NamedView> &views, const std::vector<NamedRobot> &robots);

} // namespace odo
