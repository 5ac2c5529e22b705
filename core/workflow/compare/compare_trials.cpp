// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/compare_trials.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/result_axes.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/stored_verdicts.h"

#include <algorithm>

namespace odo {

namespace {

Message comparisonOf(const std::string &trial)
{
    return ODO_TEXT("workflow.comparison_of_trial", "comparison of trial '%1'")(Named::trial(trial));
}

Result<AnalysisRecord> analysisOf(Project &project, const TrialRecord &trial, const std::string &robot,
                                  const Message &what)
{
    const auto analyses = ODO_TRY(project.analyses().current(trial.id));
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(), trackItFirst());
    std::vector<std::string> names;
    for (const AnalysisRecord &analysis : analyses) {
        if (analysis.robotName == robot || (robot.empty() && analyses.size() == 1))
            return analysis;
        names.push_back(analysis.robotName);
    }
    if (robot.empty())
        return fail(ErrorCode::Undetermined, what, severalRobots(names),
                    ODO_TEXT("workflow.choose_one_of_them", "choose one of them"));
    return fail(ErrorCode::NotFound, what, robotNotTracked(robot, names),
                ODO_TEXT("workflow.track_or_choose_another", "track it, or choose another"));
}

Result<std::optional<TaskRecord>> commonTask(Project &project, const std::vector<ComparedTrial> &runs)
{
    std::string name;
    for (const ComparedTrial &run : runs) {
        if (run.trial.task.empty())
            continue;
        if (!name.empty() && name != run.trial.task)
            return std::nullopt;
        name = run.trial.task;
    }
    if (name.empty())
        return std::nullopt;
    const auto task = ODO_TRY(project.tasks().find(name));
    return task;
}

Result<bool> sharesCalibration(Project &project, const AnalysisRecord &a, const AnalysisRecord &b)
{
    const bool isRegistered = std::ranges::any_of(a.registrations, [](RecordId id) { return id != 0; });
    if (!isRegistered || a.robot != b.robot || a.profile.heightEstimated || b.profile.heightEstimated)
        return false;
    return haveSameRegistrations(project, a, b);
}

Result<MessageArgument> layoutNameOf(Project &project, const AnalysisRecord &analysis)
{
    const RecordId id = ODO_TRY(layoutOf(project, analysis));
    const auto layout = ODO_TRY(project.layouts().get(id));
    return Named::layout(layout.layout.name);
}

/// Checks that all runs are in one set of axes.
Result<void> checkCommonAxes(Project &project, const std::vector<ComparedTrial> &runs)
{
    const ComparedTrial &first = runs.front();
    for (const ComparedTrial &run : runs) {
        if (ODO_TRY(haveCommonAxes(project, first.analysis, run.analysis)))
            continue;
        const auto layout = ODO_TRY(layoutNameOf(project, run.analysis));
        const auto other = ODO_TRY(layoutNameOf(project, first.analysis));
        return fail(ErrorCode::InvalidInput, comparisonOf(run.trial.name),
                    ODO_TEXT("workflow.runs_in_other_axes",
                             "it has other axes (layout '%1') than trial '%2' (layout '%3')")(
                        layout, Named::trial(first.trial.name), other),
                    ODO_TEXT("workflow.choose_run_on_layout", "choose a run on the same layout"));
    }
    return {};
}

} // namespace

std::string runName(const ComparedTrial &run)
{
    return run.trial.robots.size() > 1 ? run.analysis.robotName + " in " + run.trial.name : run.trial.name;
}

Result<ComparedTrial> readComparedTrial(Project &project, const CompareSettings::Run &run,
                                        const Message &what)
{
    ComparedTrial read;
    read.trial = ODO_TRY(project.trials().find(run.trial));
    read.analysis = ODO_TRY(analysisOf(project, read.trial, run.robot, what));
    if (ODO_TRY(bringToPresentAxes(project, read.trial, read.analysis)))
        return read;
    const auto layout = ODO_TRY(layoutNameOf(project, read.analysis));
    return fail(
        ErrorCode::InvalidInput, what,
        ODO_TEXT("workflow.run_in_older_axes",
                 "it has other axes: those of layout '%1' were changed after it was analysed")(layout),
        ODO_TEXT("workflow.analyse_it_again", "reanalyse it"));
}

Result<ComparedTrials> readComparedTrials(Project &project, const CompareSettings &settings)
{
    ComparedTrials read;
    for (const CompareSettings::Run &run : settings.runs) {
        auto compared = ODO_TRY(readComparedTrial(project, run, comparisonOf(run.trial)));
        const bool isTwice = std::ranges::any_of(
            read.runs, [&](const ComparedTrial &other) { return other.analysis.id == compared.analysis.id; });
        if (isTwice)
            return fail(ErrorCode::InvalidInput, comparisonOf(run.trial),
                        ODO_TEXT("workflow.compared_with_itself", "a run cannot be compared with itself"),
                        chooseAnotherOne());
        read.runs.push_back(std::move(compared));
    }
    if (read.runs.size() < 2)
        return takesTwoRuns();
    ODO_TRY(checkCommonAxes(project, read.runs));
    std::set<RecordId> trials;
    for (const ComparedTrial &run : read.runs)
        trials.insert(run.trial.id);
    const auto verdicts = ODO_TRY(trialVerdicts(project, trials));
    for (ComparedTrial &run : read.runs)
        if (const auto verdict = verdicts.find(run.trial.id); verdict != verdicts.end())
            run.verdict = verdict->second;
    auto task = ODO_TRY(commonTask(project, read.runs));
    read.task = std::move(task);
    const AnalysisRecord &first = read.runs.front().analysis;
    read.shareCalibration = read.shareTask = true;
    for (auto run = read.runs.begin() + 1; run != read.runs.end(); ++run) {
        read.shareCalibration =
            read.shareCalibration && ODO_TRY(sharesCalibration(project, first, run->analysis));
        read.shareTask = read.shareTask && first.task == run->analysis.task;
    }
    return read;
}

Result<TrialComparison> compareTrials(const ComparedTrials &trials, const CompareSettings &settings)
{
    ComparisonOptions options;
    if (trials.task)
        options.task = trials.task->task;
    options.alignBy = settings.alignBy;
    options.handTimesS = settings.handTimesS;
    options.stationM = settings.stationM;
    options.shareCalibration = trials.shareCalibration;
    std::vector<ComparedRun> runs;
    for (const ComparedTrial &run : trials.runs)
        runs.push_back({nameAlone(runName(run)), &run.analysis.profile});
    auto comparison = ODO_TRY(compareRuns(runs, options));
    TrialComparison result;
    result.comparison = std::move(comparison);
    for (std::size_t run = 1; run < runs.size(); ++run)
        result.metrics.push_back(metricDifferences(*runs.front().profile, *runs[run].profile,
                                                   trials.shareCalibration, trials.shareTask));
    if (options.task)
        result.gates = gatesOnPath(result.comparison.path, options.task->gates);
    if (result.gates.empty())
        result.gates = thirdsOf(result.comparison);
    result.sectors = sectorTimes(result.comparison, result.gates);
    return result;
}

} // namespace odo
