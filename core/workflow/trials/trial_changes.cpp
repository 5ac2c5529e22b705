// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trials/trial_changes.h"

#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/teams.h"
#include "core/workflow/shared_words.h"

#include <algorithm>

namespace odo {

Message editTrialWords(const std::string &trial)
{
    return ODO_TEXT("workflow.edit_trial", "edit trial %1")(Named::trial(trial));
}

namespace {

std::ptrdiff_t changesIn(const TrialEdit &edit)
{
    return std::ranges::count(
        std::initializer_list<bool>{edit.name.has_value(), edit.team || edit.className, edit.date.has_value(),
                                    edit.task.has_value(), edit.robots.has_value(), edit.notes.has_value(),
                                    edit.tags.has_value(), !edit.variables.empty(), edit.range.has_value()},
        true);
}

Message wordsOf(const std::string &trial, const TrialEdit &edit)
{
    const MessageArgument name = Named::trial(trial);
    if (changesIn(edit) == 1) {
        if (edit.name)
            return ODO_TEXT("workflow.rename_trial", "rename trial %1 to %2")(name, Named::trial(*edit.name));
        if (edit.team && !edit.team->empty())
            return ODO_TEXT("workflow.give_team", "assign %1 to team %2")(name, Named::team(*edit.team));
        if (edit.task && !edit.task->empty())
            return giveTaskChange(trial, *edit.task);
        if (edit.range)
            return rangeChange(trial, *edit.range);
        if (edit.notes)
            return ODO_TEXT("ui.write_notes", "write notes of %1")(name);
        if (edit.tags)
            return ODO_TEXT("ui.change_tags", "change the tags of %1")(name);
    }
    return editTrialWords(trial);
}

tl::unexpected<Error> ofAnotherClass(const TeamRecord &team, const std::string &className, Message advice)
{
    return fail(ErrorCode::InvalidInput, teamSubject(team.name),
                ODO_TEXT("workflow.team_of_another_class", "it belongs to class %1, not to class %2")(
                    Named::schoolClass(team.className), Named::schoolClass(className)),
                std::move(advice));
}

/// The team that the trial is to have, in the class that it is to be in; without an id: none.
Result<TeamRecord> wantedTeam(Project &project, const TrialRecord &trial, const TrialEdit &edit)
{
    const std::string name = edit.team ? normalName(*edit.team) : trial.teamName;
    if (name.empty() && edit.className)
        return fail(ErrorCode::InvalidInput, trialSubject(trial.name),
                    ODO_TEXT("workflow.class_without_team", "without a team it belongs to no class"),
                    ODO_TEXT("workflow.give_team_too", "give it a team too"));
    if (name.empty())
        return TeamRecord();
    auto team = ODO_TRY(findOrAddTeam(project, name, edit.className ? std::string() : trial.className));
    if (!edit.className) {
        if (!trial.className.empty() && !team.className.empty() && team.className != trial.className)
            return ofAnotherClass(team, trial.className,
                                  ODO_TEXT("workflow.give_class_too", "give its class too, or another team"));
        return team;
    }
    const std::string className = normalName(*edit.className);
    ODO_TRY(checkName(RecordKind::Class, className));
    if (team.className.empty()) {
        team.className = className;
        ODO_TRY(project.teams().set(team));
    } else if (team.className != className) {
        return ofAnotherClass(
            team, className,
            ODO_TEXT("workflow.give_another_team", "give another team, or change the class of this one"));
    }
    return team;
}

Result<std::vector<RecordId>> robotsNamed(Project &project, const std::vector<std::string> &names)
{
    std::vector<RecordId> robots;
    for (const std::string &name : names) {
        const auto robot = ODO_TRY(project.robots().find(name));
        if (std::ranges::find(robots, robot.id) == robots.end())
            robots.push_back(robot.id);
    }
    return robots;
}

std::map<std::string, std::string> changedVariables(std::map<std::string, std::string> variables,
                                                    const std::map<std::string, std::string> &changes)
{
    for (const auto &[name, value] : changes) {
        if (value.empty())
            variables.erase(normalName(name));
        else
            variables.insert_or_assign(normalName(name), value);
    }
    return variables;
}

Result<void> apply(Project &project, const TrialRecord &trial, const TrialEdit &edit)
{
    TrialRepository &trials = project.trials();
    if (edit.name)
        ODO_TRY(trials.setName(trial.id, *edit.name));
    if (edit.team || edit.className) {
        const auto team = ODO_TRY(wantedTeam(project, trial, edit));
        ODO_TRY(trials.setTeam(trial.id, team.id));
    }
    if (edit.date)
        ODO_TRY(trials.setDate(trial.id, *edit.date));
    if (edit.task && !edit.task->empty())
        ODO_TRY(project.tasks().find(*edit.task));
    if (edit.task)
        ODO_TRY(trials.setTask(trial.id, *edit.task));
    if (edit.robots) {
        const auto robots = ODO_TRY(robotsNamed(project, *edit.robots));
        ODO_TRY(trials.setRobots(trial.id, robots));
    }
    if (edit.tags)
        ODO_TRY(trials.setTags(trial.id, *edit.tags));
    if (!edit.variables.empty())
        ODO_TRY(trials.setVariables(trial.id, changedVariables(trial.variables, edit.variables)));
    if (edit.range) {
        RangeJob job(edit.name ? normalName(*edit.name) : trial.name, *edit.range);
        ODO_TRY(runToEnd(job, project, JobControl()));
    }
    return edit.notes ? trials.setNotes(trial.id, *edit.notes) : Result<void>();
}

} // namespace

bool isEmpty(const TrialEdit &edit)
{
    return changesIn(edit) == 0;
}

Result<TrialRecord> editTrial(Project &project, RecordId id, const TrialEdit &edit)
{
    const auto trial = ODO_TRY(project.trials().get(id));
    if (edit.date && *edit.date > instantNow())
        return fail(ErrorCode::WrongCall, trialSubject(trial.name),
                    ODO_TEXT("workflow.date_to_come", "its new date is in the future"),
                    ODO_TEXT("workflow.give_date_of_run", "give the date of the run"));
    return changing(project, wordsOf(trial.name, edit), [&]() -> Result<TrialRecord> {
        ODO_TRY(apply(project, trial, edit));
        return project.trials().get(trial.id);
    });
}

Result<std::vector<TrialRecord>> editTrials(Project &project, const std::vector<RecordId> &trials,
                                            const TrialEdit &edit)
{
    std::vector<TrialRecord> edited;
    const auto editAll = [&]() -> Result<void> {
        for (const RecordId trial : trials)
            edited.push_back(ODO_TRY(editTrial(project, trial, edit)));
        return {};
    };
    ODO_TRY(trials.size() == 1
                ? editAll()
                : project.change(ODO_TEXT("workflow.edit_trials", "edit %1 trials")(trials.size()), editAll));
    return edited;
}

Result<void> addTrial(Project &project, const Message &words, const std::function<Result<RecordId>()> &add)
{
    RecordId trial = 0;
    return project.change(
        words, [&] { return project.trials().setBinned(trial, false); },
        [&]() -> Result<void> {
            trial = ODO_TRY(add());
            return project.trials().setBinned(trial, true);
        });
}

namespace {

Message binWords(const std::vector<TrialRecord> &trials, bool isInBin)
{
    if (trials.size() == 1) {
        const MessageArgument name = Named::trial(trials.front().name);
        return isInBin ? ODO_TEXT("ui.delete_trial", "delete %1")(name)
                       : ODO_TEXT("ui.undelete_trial", "restore %1 from the bin")(name);
    }
    return isInBin ? ODO_TEXT("ui.delete_trials", "delete %1 trials")(trials.size())
                   : ODO_TEXT("ui.undelete_trials", "restore %1 trials from the bin")(trials.size());
}

} // namespace

Result<void> setInBin(Project &project, const std::vector<TrialRecord> &trials, bool isInBin)
{
    return project.change(binWords(trials, isInBin), [&]() -> Result<void> {
        for (const TrialRecord &trial : trials)
            ODO_TRY(project.trials().setBinned(trial.id, isInBin));
        return {};
    });
}

} // namespace odo
