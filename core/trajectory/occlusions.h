// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/units.h"
#include "core/geometry/floor_view.h"
#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// Why a view did not measure the whole of a robot that was in its frames.
enum class OcclusionCause {
    HiddenBehind,       ///< another robot was nearer to the camera, and this one was not found
    PartlyHiddenBehind, ///< the same, but some of its outline was found
    OneOutline,         ///< its outline and another robot's were one
    CutByEdge,          ///< the frame's edge cut its outline
    NotVisible,         ///< not found; by what it was hidden is not known
    PartlyVisible,      ///< its outline was smaller than usual
    OutlineTooLarge     ///< its outline was larger than usual: something touched it, or its shape changed
};
/// "hidden_behind", "partly_hidden_behind", "one_outline", "cut_by_edge", "not_visible", "partly_visible",
/// "outline_too_large".
std::string_view occlusionCauseName(OcclusionCause cause);

/// A stretch of a trial in which one view did not measure the whole of a robot. Its position then comes from
/// the other views, or from its motion before and after: σ is larger, and nothing is a spike.
struct Occlusion
{
    TimeSpan span; ///< since the first view's first frame
    OcclusionCause cause = OcclusionCause::NotVisible;
    std::string view;  ///< the camera's name
    std::string other; ///< the other robot's name; empty where none is known
};
/// "hidden behind Blue 1 in view A".
Message occlusionWords(const Occlusion &occlusion);
/// "hidden behind Blue 1 in view A (3.20 s to 3.90 s)".
Message occlusionSentence(const Occlusion &occlusion);
/// A spike's reason with what happened then, from the robot's occlusions: "jump of 84 mm; hidden behind Blue
/// 1 in view A".
Message reasonAmong(const std::vector<Occlusion> &occlusions, const Spike &spike);

/// A view of a trial. floorView: nullptr where the camera is not registered.
struct OcclusionView
{
    std::string name;
    const FloorView *floorView = nullptr;
    ViewClock clock;
};

/// A robot of a trial. profile: nullptr where it was not analysed. observations: one list a view, in order of
/// frames.
struct OcclusionRobot
{
    std::string name;
    const Profile *profile = nullptr;
    std::vector<std::span<const Observation>> observations;
};

/// Of each robot, in order of time, those that last for 0.1 s or longer. They follow from the observations
/// and the positions; nothing is found where a position is not known at all, or lies outside a view's frame.
/// Pure.
std::vector<std::vector<Occlusion>> findOcclusions(std::span<const OcclusionView> views,
                                                   std::span<const OcclusionRobot> robots);

/// A sentence for every stretch, after the robot was first seen, in which no view saw it for so long that the
/// profile has nothing there: between sightings longer than a gap that is bridged, or over half a second at
/// the end. It says when and where the robot left and what to do. Without subject, to be put behind
/// "robot R: ".
std::vector<Message> describeGaps(const Profile &profile, Nanoseconds longestBridgedGap);
/// Of a gap in whatever track, without subject.
Message unmeasuredSentence(const TimeSpan &gap);

} // namespace odo
