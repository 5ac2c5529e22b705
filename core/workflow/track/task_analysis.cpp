// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/task_analysis.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mostRefused = 0.2;

/// The part of the measured positions that is refused as spikes.
double refusedShare(const Profile &profile)
{
    constexpr SampleFlags spike =
        flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit) | flagBit(SampleFlag::AccelerationLimit);
    double measured = 0, refused = 0;
    const auto count = [&](bool isMeasured, SampleFlags flags) {
        measured += isMeasured;
        refused += isMeasured && (flags & spike) != 0;
    };
    for (const Sample &sample : profile.samples)
        count(sample.position.has_value(), sample.flags);
    for (const SampleFlags flags : profile.flags)
        count(!hasFlag(flags, SampleFlag::Lost), flags);
    return measured > 0 ? refused / measured : 0;
}

} // namespace

Result<TaskAnalysis> analyseByTask(const MakeProfile &make, const AnalysisOptions &options,
                                   const std::optional<TaskRecord> &task)
{
    const AnalysisOptions byTask = task ? withTask(options, task->task) : options;
    auto profile = make(byTask);
    const bool limited = task && (task->task.limits.maxSpeedMps || task->task.limits.maxAccelMps2);
    const double refused = profile ? refusedShare(*profile) : 1;
    if (!limited || refused <= mostRefused) {
        if (!profile)
            return tl::unexpected(profile.error());
        return TaskAnalysis{std::move(*profile), byTask, {}};
    }
    Task free = task->task;
    free.limits = {};
    const AnalysisOptions withoutLimits = withTask(options, free);
    auto second = make(withoutLimits);
    if (second && refusedShare(*second) < refused / 2) {
        const MessageArgument name = Named::task(task->name);
        const Message why =
            profile ? ODO_TEXT("workflow.beyond_limits",
                               "%1 of what was measured is beyond the limits of task '%2', so that they were "
                               "left out")(quantity(std::round(100 * refused), 0, "%"), name)
                    : ODO_TEXT("workflow.nearly_all_beyond_limits",
                               "nearly all that was measured is beyond the limits of task '%1', so that they "
                               "were left out")(name);
        return TaskAnalysis{std::move(*second), withoutLimits,
                            joined({why, ODO_TEXT("workflow.give_limits_of_fastest",
                                                  "give the task the limits of its fastest robot")},
                                   Join::Semicolon)};
    }
    if (!profile)
        return tl::unexpected(profile.error());
    return TaskAnalysis{std::move(*profile), byTask, {}};
}

} // namespace odo
