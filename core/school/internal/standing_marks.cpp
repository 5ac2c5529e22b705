// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/standing_marks.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

const char *standingOf(RecordId trial, const CountingGrounds &grounds)
{
    if (std::ranges::binary_search(grounds.otherwise, trial, {}, &OtherwiseMeasured::trial))
        return standingWord::otherwise;
    const auto verdict = grounds.verdicts.find(trial);
    if (verdict == grounds.verdicts.end() || verdict->second.isSound())
        return standingWord::pass;
    return verdict->second.level() == CheckLevel::Bad ? standingWord::bad : standingWord::doubtful;
}

} // namespace

Result<std::map<RecordId, QJsonObject>> standingMarks(Project &project)
{
    const auto grounds = ODO_TRY(countingGrounds(project, {}, {}));
    const auto metrics = ODO_TRY(scoreMetrics(project, Instant::min(), Instant::max()));
    const auto robots = ODO_TRY(project.robots().all());
    std::map<RecordId, QJsonObject> scores;
    for (const TrialMetric &one : metrics) {
        const auto robot = std::ranges::find(robots, one.robot, &RobotRecord::id);
        if (robot == robots.end())
            continue;
        scores[one.trial][QString::fromStdString(robot->name)] = QJsonObject{
            {QStringLiteral("value"), one.metric.value},
            {QStringLiteral("sigma"), one.metric.sigma ? QJsonValue(*one.metric.sigma) : QJsonValue()}};
    }
    const auto trials = ODO_TRY(project.trials().all());
    std::map<RecordId, QJsonObject> marks;
    for (const TrialRecord &trial : trials)
        if (!trial.binned)
            marks[trial.id] = {{QStringLiteral("standing"), QLatin1String(standingOf(trial.id, grounds))},
                               {QStringLiteral("scores"), scores[trial.id]}};
    return marks;
}

} // namespace odo
