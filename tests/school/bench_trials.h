// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"

namespace odo::test {

/// What a failure says; nothing of a success.
template <class Value>
std::string whyNot(const Result<Value> &outcome)
{
    return outcome ? std::string() : outcome.error().message();
}

/// Adds trials "run 1", "run 2", … with an analysis of 300 samples each; of another bench others.
inline Result<void> addBenchTrials(Project &project, int bench, int trials)
{
    RecordSource source(std::uint32_t(100 + bench));
    return project.inTransaction([&]() -> Result<void> {
        const auto robot =
            ODO_TRY(project.robots().add({0, "red", {}, RobotRecord::Height::Automatic, {}, {}, {}}));
        for (int i = 0; i < trials; ++i) {
            TrialRecord trial;
            trial.name = "run " + std::to_string(i + 1);
            trial.notes = "bench " + std::to_string(bench);
            trial.syncMethod = "none";
            trial.robots = {robot.id};
            const auto stored = ODO_TRY(project.trials().add(trial, {}));
            AnalysisRecord analysis = source.analysis(stored.id, robot.id, 300);
            analysis.profile.passages.clear();
            ODO_TRY(project.analyses().add(analysis));
        }
        return {};
    });
}

} // namespace odo::test
