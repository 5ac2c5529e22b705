// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/flash_synchronisation.h"
#include "core/synchronisation/internal/sound_synchronisation.h"
#include "core/trajectory/name_assignment.h"

#include <memory>
#include <optional>
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
    std::shared_ptr<const SoundCourse> sound = nullptr; ///< null: not looked for, or there is none
    Message whyNoSound = {}; ///< where there is none: "view 'A' has no sound"; empty: not looked for
    std::optional<MicrophonePosition> microphone = std::nullopt; ///< where it is known
};

/// For each view the tracks of all robots, by its own clock; none where it is not registered. Robots of like
/// colours may have changed their names in one view and not in the other: of such a group it is the middle,
/// wherever as many of them are seen as ever are together in any view, and that is the same whatever the
/// names.
std::vector<std::vector<MotionTrack>> motionTracks(const std::vector<NamedView> &views,
                                                   const std::vector<NamedRobot> &robots,
                                                   const std::vector<std::string> &names);

/// By what an offset is found, or may be.
enum class OffsetSource { Any, Motion, Flash, Sound };

/// The offset of the second view against the first, and from what it is known.
struct FoundOffset
{
    ClipOffset clock;
    OffsetSource from = OffsetSource::Motion;
    std::vector<Message> remarks; ///< on what does not fit
};

/// From the motion of the robots (of several robots the one that determines the offset best), a flash of
/// light or a sound: the one with the least σ. If the motion alone fits at several offsets, or the offset is
/// beyond the searched range, it is the motion near the offset of the sound or the flash. Disagreement is
/// reported as a remark. allowed: if not Any, nothing else is looked at. Pure; any thread. Undetermined: none
/// of those allowed determines it.
Result<FoundOffset> findClipOffset(const ClipEvidence &first, const ClipEvidence &second,
                                   const OffsetRange &range, OffsetSource allowed = OffsetSource::Any);

} // namespace odo
