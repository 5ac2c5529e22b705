// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/demo_testbed.h"
#include "core/workflow/record/live_tracking.h"
#include "core/workflow/record/live_trial.h"
#include "core/workflow/record/run_control.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odo {

constexpr double longestRecordingS = 24 * 3600, longestPreRollS = 30;

struct RecordSettings
{
    std::string trial;
    std::vector<std::pair<std::string, std::string>>
        cameras; ///< camera's name and its address, first view first
    /// from when all cameras deliver, or from a start by itself; where it ends by itself: at most
    double seconds = 10;
    double preRollS = 0; ///< so long before, the cameras run already, and that is recorded too: 30 s at most
    std::vector<std::string> robots;
    /// of what should be known while it still records; on the calling thread
    std::function<void(const Message &)> warn = {};
    /// to where the robots' live positions are sent; empty: none are computed
    std::optional<BroadcastTarget> broadcast = {};
    std::string task = {};                ///< its name; empty: none
    std::optional<RunTrigger> start = {}; ///< waited for before it is recorded; empty: it starts at once
    std::optional<RunTrigger> stop = {};  ///< what ends it before its seconds are over
};

/// Records a trial from cameras: every frame of every view to the disk, the views synchronised by the
/// cameras' clocks. Long, on the project's thread. One that is cancelled before it began leaves nothing
/// behind (Cancelled); one that is cancelled later, or ends early because a file has ended or the disk fails,
/// keeps what there is, and its warnings say so. Where the project's file was taken away meanwhile, a warning
/// says in which copy of it the trial is. Sending live positions never delays it. Undetermined where they, or
/// a start or an end by itself, need a registered camera and there is none; InvalidInput and NotFound for a
/// gate or zone that the task does not have.
Result<std::shared_ptr<LiveTrial>> recordTrial(Project &project, const RecordSettings &settings,
                                               const JobControl &control);

/// What simulated cameras are to show of a project's robots.
std::vector<RobotAppearance> appearancesOf(const std::vector<RobotRecord> &robots);

} // namespace odo
