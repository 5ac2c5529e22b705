// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/flash_synchronisation.h"
#include "core/trajectory/name_assignment.h"

#include <string>
#include <vector>

namespace odo {

/// Where one robot was on the floor, as one view saw it; or the middle of several robots that the view cannot
/// distinguish.
struct MotionTrack
{
    std::vector<std::string> robots; ///< their names
    std::vector<TimedPosition> positions;
};

/// What one view offers to find when it started.
struct ClipEvidence
{
    std::vector<MotionTrack> tracks; ///< as many and of the same robots as the other views'
    /// where there are none: "the project has no robot to look for"
    Message whyNoTracks;
    LightCourse light;
};

/// For each view the tracks of all robots, by its own clock; none where it is not registered. Robots of like
/// colours may have changed their names in one view and not in the other: of such a group it is the middle,
/// wherever as many of them are seen as ever are together in any view, and that is the same whatever the
/// names.
std::vector<std::vector<MotionTrack>> motionTracks(const std::vector<NamedView> &views,
                                                   const std::vector<NamedRobot> &robots,
                                                   const std::vector<std::string> &names);

/// The offset of the second view against the first, and from what it is known.
struct FoundOffset
{
    ClipOffset clock;
    bool fromFlash = false;
    std::vector<Message> remarks; ///< on what does not fit
};

/// From the motion of the robots if it determines the offset (of several robots the one that does so best),
/// because that is the most precise; if the motion alone fits at several offsets, or the offset is beyond the
/// searched range, from the motion near a flash of light. Otherwise from the flash. Disagreement is reported
/// as a remark. Pure; any thread. Undetermined: neither determines it.
Result<FoundOffset> findClipOffset(const ClipEvidence &first, const ClipEvidence &second,
                                   const OffsetRange &range);

} // namespace odo
