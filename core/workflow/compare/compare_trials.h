// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/run_differences.h"
#include "core/project/records.h"
#include "core/project/verdict_repository.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Which runs are compared, and how they are aligned.
struct CompareSettings
{
    struct Run
    {
        std::string trial;
        std::string robot; ///< empty: the trial's only one
    };
    std::vector<Run> runs;          ///< the others are compared with the first
    std::optional<AlignBy> alignBy; ///< as ComparisonOptions
    std::vector<double> handTimesS; ///< of each run, since its first view's first frame
    std::optional<double> stationM;
};

/// What is read of one run.
struct ComparedTrial
{
    TrialRecord trial;
    AnalysisRecord analysis;
    TrialVerdict verdict = {}; ///< on the trial, without the checks that were passed
};

/// The runs with what they have in common.
struct ComparedTrials
{
    std::vector<ComparedTrial> runs;
    std::optional<TaskRecord> task; ///< of all runs that have one; none where they differ
    bool shareCalibration = false;  ///< as ComparisonOptions
    bool shareTask = false;         ///< all were measured by the same one
};

/// A comparison with all that is shown of it.
struct TrialComparison
{
    RunComparison comparison;
    std::vector<std::vector<MetricDifference>> metrics; ///< of each run but the first against it
    std::vector<PathGate> gates;      ///< the task's, or else two that part the way into three
    std::vector<SectorTimes> sectors; ///< by these gates
};

/// "Red 2 in trial 3", for words.
std::string runName(const ComparedTrial &run);

/// Reads a run's newest analysis in the present axes of its layout, without a verdict, on the project's
/// thread. what: that errors are about. Errors: as of readComparedTrials.
Result<ComparedTrial> readComparedTrial(Project &project, const CompareSettings::Run &run,
                                        const Message &what);

/// Reads the runs' newest analyses, on the project's thread. Calibration is shared by runs of one robot whose
/// views' registrations were the same and whose height was given: with another robot or a height of its own
/// each has its own error. Runs that were analysed before the axes of their layout were changed are put into
/// the present ones. Errors: InvalidInput for runs in axes that are not known to each other; NotFound for a
/// trial, a robot or an analysis that is not there; Undetermined where a robot must be chosen; InvalidInput
/// for fewer than two runs or one with itself.
Result<ComparedTrials> readComparedTrials(Project &project, const CompareSettings &settings);

/// Compares what was read; some ten milliseconds for minutes of video. Pure, any thread. Errors: those of
/// compareRuns.
Result<TrialComparison> compareTrials(const ComparedTrials &trials, const CompareSettings &settings);

} // namespace odo
