// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/flash_synchronisation.h"
#include "core/trajectory/name_assignment.h"

#include <string>
#include <vector>

namespace odo {

/// Where one robot was on the floor, as one view saw it; or the middle of several robots that the view cannot
/// tell apart.
struct MotionTrack
{
    std::vector<std::string> robots; ///< their names
    std::vector<TimedPosition> positions;
};

/// What one view tells of the moment at which it was begun.
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

/// From the motion of the robots where it tells (of several that which tells best), for that is the finest;
/// where a flash of light is known, and the motion alone fits at several offsets, or lies further apart than
/// is searched, from the motion near the flash. Else from the flash. What disagrees is remarked. Pure; any
/// thread. Undetermined: neither tells.
Result<FoundOffset> findClipOffset(const ClipEvidence &first, const ClipEvidence &second,
                                   const OffsetRange &range);

} // namespace odo
