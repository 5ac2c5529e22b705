// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/clip_evidence.h"
#include "core/workflow/trial_sources.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Where a registered camera hears from, over the floor that its markers span; nullopt where it is not
/// registered. Project's thread.
Result<std::optional<MicrophonePosition>> microphonePositionOf(Project &project, const RegisteredView &view);

/// What is to be found of some views' clocks.
struct ClipOffsetSearch
{
    std::string trial;
    std::vector<OffsetSource> sources; ///< that are allowed for each view but the first
    std::vector<RobotRecord> robots;
    std::vector<std::optional<MicrophonePosition>> microphones; ///< of each view
    bool isSlowMotion = false; ///< the files play at another rate than they were filmed at
    bool mayTakeFields = true; ///< interlaced frames may be counted by their fields
};

/// What is found of the clocks of all views.
struct FoundClocks
{
    std::vector<Result<FoundOffset>> views; ///< for each but the first, against the first as repaired
    std::vector<Message> frameSteps;        ///< whole sentences on frames that were missing or doubled
    std::optional<ClockRepair> first;       ///< of the first view's stamps
};

/// Reads all views once, tracks the robots where two views or more are registered and measures the light,
/// reads their sound, and finds for each view but the first its time offset to the first (findClipOffset):
/// Undetermined, with the reason, if nothing gives it. What no source asks for is not read. Touches no
/// project. Errors: a video that cannot be read; cancelled. Before that the frame times of each view by
/// itself are corrected (correctFrameTimes).
Result<FoundClocks> findClipOffsets(std::vector<RegisteredView> &views, const ClipOffsetSearch &search,
                                    const JobControl &control);

} // namespace odo
