// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/stored_verdicts.h"

#include "core/base/job_control.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/trial_verdict.h"

#include <algorithm>

namespace odo {

namespace {

Result<StoredVerdict> computeVerdict(Project &project, const TrialRecord &trial,
                                     const std::vector<AnalysisRecord> &analyses, std::string basis)
{
    StoredVerdict stored{trial.id, {}, std::move(basis), {}};
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    std::vector<const RecordingRecord *> views;
    for (const RecordingRecord &recording : recordings)
        views.push_back(&recording);
    stored.verdict = ODO_TRY(verdictOn(project, trial, views, analyses));
    for (const AnalysisRecord &analysis : analyses) {
        std::vector<std::string> &bounds = stored.lowerBounds[analysis.id];
        for (const Metric &metric : analysis.profile.metrics)
            if (metric.isAtLeast)
                bounds.push_back(metric.name);
    }
    return stored;
}

/// The basis is read first: where somebody else analyses the trial meanwhile, the verdict is out of date.
Result<StoredVerdict> computeVerdict(Project &project, RecordId id)
{
    auto basis = ODO_TRY(project.verdicts().basis(id));
    const auto trial = ODO_TRY(project.trials().get(id));
    const auto analyses = ODO_TRY(project.analyses().current(id));
    return computeVerdict(project, trial, analyses, std::move(basis));
}

/// Only what a list shows.
TrialVerdict withoutPassed(TrialVerdict verdict)
{
    std::erase_if(verdict.checks, [](const TrialCheck &check) { return check.level == CheckLevel::Pass; });
    return verdict;
}

Message verdictSubject(const std::string &trial)
{
    return ODO_TEXT("workflow.verdict_on", "verdict on trial '%1'")(Named::trial(trial));
}

} // namespace

Result<TrialVerdict> storeVerdict(Project &project, const TrialRecord &trial,
                                  const std::vector<AnalysisRecord> &made)
{
    const auto newest = ODO_TRY(project.analyses().currentMetrics(trial.id));
    const bool isComplete = std::ranges::all_of(newest, [&made](const AnalysisRecord &one) {
        return std::ranges::find(made, one.id, &AnalysisRecord::id) != made.end();
    });
    auto basis = ODO_TRY(project.verdicts().basis(trial.id));
    auto computed = ODO_TRY(isComplete ? computeVerdict(project, trial, made, std::move(basis))
                                       : computeVerdict(project, trial.id));
    ODO_TRY(project.verdicts().set(computed));
    return std::move(computed.verdict);
}

Result<std::vector<StoredVerdict>> computeVerdicts(Project &project, const std::vector<RecordId> &trials)
{
    std::vector<StoredVerdict> verdicts;
    const CancelToken *cancel = CancelScope::current();
    for (const RecordId trial : trials) {
        if (cancel && cancel->isCancelled())
            return cancelled(ODO_TEXT("workflow.checking_trials", "checks of the trials"));
        if (auto computed = computeVerdict(project, trial))
            verdicts.push_back(std::move(*computed));
    }
    return verdicts;
}

Result<void> storeVerdicts(Project &project, const std::vector<StoredVerdict> &verdicts)
{
    return project.inTransaction([&]() -> Result<void> {
        for (const StoredVerdict &verdict : verdicts)
            ODO_TRY(project.verdicts().set(verdict));
        return {};
    });
}

Result<void> storeMissingVerdicts(Project &project)
{
    const auto missing = ODO_TRY(project.verdicts().missing(Instant::min(), Instant::max()));
    const auto computed = ODO_TRY(computeVerdicts(project, missing));
    return storeVerdicts(project, computed);
}

Result<std::map<RecordId, TrialVerdict>> trialVerdicts(Project &project, const std::set<RecordId> &trials)
{
    auto verdicts = ODO_TRY(project.verdicts().all(Instant::min(), Instant::max()));
    std::erase_if(verdicts, [&trials](const auto &each) { return !trials.contains(each.first); });
    auto missing = ODO_TRY(project.verdicts().missing(Instant::min(), Instant::max()));
    std::erase_if(missing, [&trials](RecordId trial) { return !trials.contains(trial); });
    auto computed = ODO_TRY(computeVerdicts(project, missing));
    for (StoredVerdict &one : computed)
        verdicts[one.trial] = withoutPassed(std::move(one.verdict));
    return verdicts;
}

Result<void> acceptVerdict(Project &project, const std::string &trialName, const std::string &reason)
{
    const auto trial = ODO_TRY(project.trials().find(trialName));
    const auto computed = ODO_TRY(computeVerdict(project, trial.id));
    const TrialVerdict verdict = withoutPassed(computed.verdict);
    const Message what = verdictSubject(trial.name);
    if (computed.verdict.checks.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(), trackItFirst());
    if (verdict.level() == CheckLevel::Pass)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.nothing_to_accept", "all checks were passed"),
                    ODO_TEXT("workflow.use_as_it_is", "use the results as they are"));
    if (verdict.level() == CheckLevel::Bad) {
        const auto bad = std::ranges::find(verdict.checks, CheckLevel::Bad, &TrialCheck::level);
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("workflow.bad_is_not_accepted", "bad results cannot be accepted (%1)")(bad->text),
            ODO_TEXT("workflow.remove_cause", "remove the cause and reanalyse, or record it again"));
    }
    VerdictAcceptance acceptance{reason, instantNow(), {}};
    for (const TrialCheck &check : verdict.checks)
        acceptance.checks.push_back(check.code);
    std::ranges::sort(acceptance.checks);
    return project.change(
        ODO_TEXT("workflow.accept_results", "accept the results of %1")(Named::trial(trial.name)),
        [&]() -> Result<void> {
            ODO_TRY(project.verdicts().set(computed));
            return project.verdicts().setAcceptance(trial.id, acceptance);
        });
}

Result<void> withdrawAcceptance(Project &project, const std::string &trialName)
{
    const auto trial = ODO_TRY(project.trials().find(trialName));
    const auto acceptance = ODO_TRY(project.verdicts().acceptance(trial.id));
    if (!acceptance)
        return fail(ErrorCode::NotFound, verdictSubject(trial.name),
                    ODO_TEXT("workflow.was_not_accepted", "nobody accepted it"),
                    ODO_TEXT("workflow.nothing_to_withdraw", "leave it as it is"));
    return project.change(
        ODO_TEXT("workflow.withdraw_acceptance", "withdraw the acceptance of %1")(Named::trial(trial.name)),
        [&] { return project.verdicts().setAcceptance(trial.id, std::nullopt); });
}

} // namespace odo
