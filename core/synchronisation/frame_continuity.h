// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/geometry/floor_view.h"
#include "core/synchronisation/clock_repair.h"
#include "core/tracking/observation.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace odo {

/// Where a view saw one robot in one frame: all of it, and well.
struct FramePosition
{
    std::int64_t frame = 0;
    double timeS = 0; ///< as stamped, zero at the view's first frame
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double areaPx = 0;
    double metresPerPx = 0;
    bool isRepeat = false; ///< the frame is the one before, once more
};

/// A robot's way through the frames of one view, in order.
using FrameTrack = std::vector<FramePosition>;

/// Of what a view observed of a robot: the frames that show all of it.
FrameTrack frameTrack(const FloorView &view, double heightM, const std::vector<Observation> &observations);

/// A moment at which a single view's frames do not follow each other as their time stamps say.
struct FrameStep
{
    enum class Kind {
        Lost,     ///< frames are missing, and the stamps go on as if they were not
        Doubled,  ///< frames repeat the one before, and later stamps are late
        Stood,    ///< likewise, or a slow robot stopped so briefly; nothing is corrected
        Leap,     ///< the robot is somewhere else in the next frame; why is not known
        Frozen,   ///< frames repeat the one before, and then the robot is where it would have got meanwhile
        Repeated, ///< all along one frame in so many repeats the one before (FrameConversion)
        Fields,   ///< all along the frames are the two fields of interlaced ones, each at its own time
        Combed    ///< all along each frame holds two fields, and was measured whole
    };
    Kind kind = Kind::Leap;
    std::int64_t frame = 0;  ///< the first frame after it
    std::int64_t frames = 0; ///< missing, doubled, stood or frozen, or in how many one repeats; 0 of a leap
    double leapM = 0;        ///< how far the robots got beyond what the time stamps explain
    ClockStep step;          ///< that corrects the stamps; of length 0 of others
};

/// Tests each interval between two frames of one view by how the robots move: over lost frames all of them
/// leap along their ways, with the same velocity before and after, by a whole number of frames; where a frame
/// was doubled, all stand for it and then go on with the velocity they had, as none could that stops. The
/// motion before and after is fitted by one cubic in time whose second part is delayed (least squares); a
/// collision, a start and a brake change the velocity, not the position, and explain nothing of either. Where
/// robots leap at once, but not along one smooth way, it is a Leap. Steps need robots that move: one that
/// rests shows no time. In order; pure, any thread. tracks: of all robots of a view; frameTimes: of all its
/// frames.
std::vector<FrameStep> findFrameSteps(const std::vector<FrameTrack> &tracks,
                                      const std::vector<Nanoseconds> &frameTimes);

/// What corrects the stamps: of lost and doubled frames.
ClockRepair repairOf(const std::vector<FrameStep> &steps);

} // namespace odo
