// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/trial_document.h"

#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/school_repository.h"

#include <QJsonObject>
#include <algorithm>
#include <set>

namespace odo {

namespace {

constexpr std::size_t mostTasks = 64; ///< by which one trial was measured

QCborValue instantDocument(const std::optional<Instant> &instant)
{
    return instant ? QCborValue(qint64(instant->time_since_epoch().count())) : QCborValue(nullptr);
}

std::optional<Instant> instantIn(const DocumentFields &fields, const char *key)
{
    const auto milliseconds = fields.optionalInteger(key);
    return milliseconds ? std::optional(Instant(std::chrono::milliseconds(*milliseconds))) : std::nullopt;
}

/// That it was recorded in, here or at another bench.
Result<std::vector<std::string>> viewsOf(Project &project, const TrialRecord &trial)
{
    std::vector<std::string> views;
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    for (const RecordingRecord &recording : recordings)
        views.push_back(recording.cameraName);
    const auto identity = ODO_TRY(project.school().known(SchoolKind::Trial, trial.id));
    return views.empty() && identity ? identity->views : views;
}

/// Those that its analyses were measured by, and its own.
Result<QCborArray> tasksOf(Project &project, const TrialRecord &trial)
{
    std::set<RecordId> ids;
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
    for (const AnalysisRecord &analysis : analyses)
        ids.insert(analysis.task);
    if (!trial.task.empty())
        ids.insert(ODO_TRY(project.tasks().find(trial.task)).id);
    QCborArray list;
    for (const RecordId id : ids) {
        if (id == 0)
            continue;
        const auto task = ODO_TRY(project.tasks().get(id));
        list.append(taskDocument(task, {}));
    }
    return list;
}

/// Adds those that this project does not have; one of that name stays as it is.
Result<void> storeTasks(Project &project, const DocumentFields &fields)
{
    for (const DocumentFields &one : fields.parts("tasks", mostTasks)) {
        const TaskRecord task = taskIn(one);
        if (one.isSound() && !project.tasks().find(task.name))
            ODO_TRY(project.tasks().add(task));
    }
    return {};
}

Result<RecordId> teamFor(Project &project, const DocumentFields &fields)
{
    if (fields.text("name").empty())
        return 0;
    if (const auto known = project.teams().find(fields.text("name")))
        return known->id;
    TeamRecord team;
    team.name = fields.text("name");
    team.className = fields.text("class");
    team.pseudonym = fields.text("pseudonym");
    return ODO_TRY(project.teams().add(team)).id;
}

std::map<std::string, std::string> variablesIn(const DocumentFields &fields)
{
    std::map<std::string, std::string> variables;
    for (const DocumentFields &one : fields.parts("variables", mostVariables))
        variables.emplace(one.text("name"), one.text("value"));
    return variables;
}

/// A name that no other trial has.
Result<std::string> freeName(Project &project, const std::string &name, const std::string &owner,
                             RecordId row)
{
    const auto isFree = [&](const std::string &wanted) {
        const auto known = project.trials().find(wanted);
        return !known || known->id == row;
    };
    if (isFree(name))
        return name;
    for (int number = 1; number < 1000; ++number) {
        const std::string other =
            name + " (" + owner + (number > 1 ? " " + std::to_string(number) : std::string()) + ")";
        if (isFree(other))
            return other;
    }
    return fail(ErrorCode::AlreadyExists, trialSubject(name),
                ODO_TEXT("project.school_names_taken", "every name for it is taken here"),
                ODO_TEXT("project.school_rename_yours", "rename the trials of that name in this project"));
}

Result<void> setDetails(Project &project, const DocumentFields &fields, const TrialRecord &trial)
{
    TrialRepository &trials = project.trials();
    ODO_TRY(trials.setTags(trial.id, fields.texts("tags", mostTags)));
    ODO_TRY(trials.setVariables(trial.id, variablesIn(fields)));
    ODO_TRY(trials.setStarred(trial.id, fields.flag("starred")));
    ODO_TRY(trials.setArchived(trial.id, instantIn(fields, "archived_ms").has_value()));
    ODO_TRY(trials.setBinned(trial.id, instantIn(fields, "binned_ms").has_value()));
    return trials.setRange(trial.id, trial.range);
}

Result<RecordId> placeTrial(Project &project, TrialRecord &trial, RecordId existing)
{
    TrialRepository &trials = project.trials();
    if (existing == 0) {
        trial.syncMethod = "none"; // of views that are not here
        return ODO_TRY(trials.add(trial, {})).id;
    }
    ODO_TRY(trials.setName(existing, trial.name));
    ODO_TRY(trials.setTeam(existing, trial.team));
    ODO_TRY(trials.setTask(existing, trial.task));
    ODO_TRY(trials.setDate(existing, trial.date));
    ODO_TRY(trials.setNotes(existing, trial.notes));
    ODO_TRY(trials.setRobots(existing, trial.robots));
    return existing;
}

} // namespace

Result<QCborMap> trialDocument(Project &project, const TrialRecord &trial)
{
    QCborArray variables, robots;
    for (const auto &[name, value] : trial.variables)
        variables.append(QCborMap{{QStringLiteral("name"), documentText(name)},
                                  {QStringLiteral("value"), documentText(value)}});
    for (const RecordId id : trial.robots)
        robots.append(robotDocument(ODO_TRY(project.robots().get(id))));
    const auto views = ODO_TRY(viewsOf(project, trial));
    const QCborMap team{{QStringLiteral("name"), documentText(trial.teamName)},
                        {QStringLiteral("class"), documentText(trial.className)},
                        {QStringLiteral("pseudonym"), documentText(trial.teamPseudonym)}};
    const auto range = [&](Nanoseconds TimeSpan::*end) {
        return trial.range ? QCborValue(qint64(((*trial.range).*end).count())) : QCborValue(nullptr);
    };
    return QCborMap{{QStringLiteral("name"), documentText(trial.name)},
                    {QStringLiteral("team"), team},
                    {QStringLiteral("task"), documentText(trial.task)},
                    {QStringLiteral("date_ms"), qint64(trial.date.time_since_epoch().count())},
                    {QStringLiteral("notes"), documentText(trial.notes)},
                    {QStringLiteral("duration_s"), trial.durationS},
                    {QStringLiteral("range_from_ns"), range(&TimeSpan::begin)},
                    {QStringLiteral("range_to_ns"), range(&TimeSpan::end)},
                    {QStringLiteral("starred"), trial.starred},
                    {QStringLiteral("archived_ms"), instantDocument(trial.archived)},
                    {QStringLiteral("binned_ms"), instantDocument(trial.binned)},
                    {QStringLiteral("tags"), documentTexts(trial.tags)},
                    {QStringLiteral("variables"), variables},
                    {QStringLiteral("views"), documentTexts(views)},
                    {QStringLiteral("robots"), robots},
                    {QStringLiteral("tasks"), ODO_TRY(tasksOf(project, trial))},
                    {QStringLiteral("tracks"), tracksDocument(project, trial)},
                    {QStringLiteral("analyses"), ODO_TRY(analysesDocument(project, trial.id))}};
}

Result<QJsonArray> trialResults(Project &project, const TrialRecord &trial)
{
    QJsonArray results;
    if (trial.binned)
        return results;
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
    const std::string &shown = trial.teamPseudonym.empty() ? trial.teamName : trial.teamPseudonym;
    for (const AnalysisRecord &analysis : analyses) {
        QJsonArray metrics;
        for (const Metric &metric : analysis.profile.metrics)
            metrics.append(QJsonObject{
                {QStringLiteral("name"), documentText(metric.name)},
                {QStringLiteral("unit"), documentText(metric.unit)},
                {QStringLiteral("value"), metric.value},
                {QStringLiteral("sigma"), metric.sigma ? QJsonValue(*metric.sigma) : QJsonValue()},
                {QStringLiteral("at_least"), metric.isAtLeast}});
        results.append(QJsonObject{{QStringLiteral("robot"), documentText(analysis.robotName)},
                                   {QStringLiteral("name"), documentText(trial.name)},
                                   {QStringLiteral("team"), documentText(trial.teamName)},
                                   {QStringLiteral("shown_team"), documentText(shown)},
                                   {QStringLiteral("class"), documentText(trial.className)},
                                   {QStringLiteral("task"), documentText(trial.task)},
                                   {QStringLiteral("held_ms"), qint64(trial.date.time_since_epoch().count())},
                                   {QStringLiteral("duration_s"), trial.durationS},
                                   {QStringLiteral("metrics"), metrics}});
    }
    return results;
}

Result<RecordId> storeTrial(Project &project, const DocumentFields &fields, RecordId existing,
                            const std::string &owner)
{
    TrialRecord trial;
    trial.name = ODO_TRY(freeName(project, normalName(fields.text("name")), owner, existing));
    ODO_TRY(storeTasks(project, fields));
    trial.team = ODO_TRY(teamFor(project, fields.part("team")));
    trial.task = fields.text("task");
    trial.date = Instant(std::chrono::milliseconds(fields.integer("date_ms")));
    trial.notes = fields.text("notes", maxTextLength);
    trial.durationS = fields.real("duration_s");
    for (const DocumentFields &robot : fields.parts("robots", mostRobots)) {
        const auto id = ODO_TRY(robotFor(project, robot));
        if (std::ranges::find(trial.robots, id) == trial.robots.end())
            trial.robots.push_back(id);
    }
    const auto from = fields.optionalInteger("range_from_ns"), to = fields.optionalInteger("range_to_ns");
    if (from && to)
        trial.range = TimeSpan{Nanoseconds(*from), Nanoseconds(*to)};
    if (!fields.isSound())
        return 0;
    trial.id = ODO_TRY(placeTrial(project, trial, existing));
    ODO_TRY(setDetails(project, fields, trial));
    ODO_TRY(storeTracks(project, fields, trial.id));
    ODO_TRY(storeAnalyses(project, fields, trial.id));
    return trial.id;
}

} // namespace odo
