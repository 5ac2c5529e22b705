// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/task_answers.h"
#include "core/exchange/task_file.h"
#include "core/project/changing.h"
#include "core/project/repositories.h"

#include <QJsonArray>

namespace odo {

namespace {

QString summary(const TaskRecord &task)
{
    const std::string_view kind = taskTemplateWord(task.task.kind);
    return QStringLiteral("  %1  %2  %3%4%5%6")
        .arg(QString::fromStdString(task.name), -24)
        .arg(QString::fromUtf8(kind.data(), qsizetype(kind.size())), -13)
        .arg(counted(task.task.gates.size(), QStringLiteral("gate")))
        .arg(task.task.path.points.empty() ? QString() : QStringLiteral(", reference path"),
             task.task.limits.maxSpeedMps || task.task.limits.maxAccelMps2 ? QStringLiteral(", limits") : QString(),
             task.task.zones.empty() ? QString() : QStringLiteral(", ") + counted(task.task.zones.size(), QStringLiteral("zone")));
}

Result<void> addTask(const CommandCall &call)
{
    const auto task = readTaskFile(call.text(3));
    if (!task)
        return tl::unexpected(task.error());
    const auto project = call.openProject(1, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto added =
        changing(**project, "add task " + call.text(2), [&] { return (*project)->tasks().add({0, call.text(2), *task}); });
    if (!added)
        return tl::unexpected(added.error());
    call.answer(taskJson(*added), QStringLiteral("Task added:\n%1").arg(summary(*added)));
    return {};
}

Result<void> listTasks(const CommandCall &call)
{
    const auto project = call.openProject(1, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto all = (*project)->tasks().all();
    if (!all)
        return tl::unexpected(all.error());
    QJsonArray tasks;
    QStringList lines;
    for (const TaskRecord &task : *all) {
        tasks.append(taskJson(task));
        lines << summary(task);
    }
    call.answer({{QStringLiteral("tasks"), tasks}},
                lines.isEmpty() ? QStringLiteral("No task yet; add one with odograph task add.") : lines.join(u'\n'));
    return {};
}

Result<void> setTask(const CommandCall &call)
{
    const auto project = call.openProject(1, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto trial = (*project)->trials().find(call.text(2));
    if (!trial)
        return tl::unexpected(trial.error());
    const auto task = (*project)->tasks().find(call.text(3));
    if (!task)
        return tl::unexpected(task.error());
    if (auto set = (*project)->change("give " + trial->name + " the task " + task->name,
                                      [&] { return (*project)->trials().setTask(trial->id, task->name); });
        !set)
        return set;
    const QString trialName = QString::fromStdString(trial->name), taskName = QString::fromStdString(task->name);
    call.answer({{QStringLiteral("trial"), trialName}, {QStringLiteral("task"), taskName}},
                QStringLiteral("Trial %1 has the task %2; measure it with: odograph track %3 %1 --again")
                    .arg(trialName, taskName, call.positional(1)));
    return {};
}

} // namespace

Result<void> runTask(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("task"),
                      QStringLiteral("add P.odo NAME task.json | list P.odo | set P.odo TRIAL NAME [--json]"), 2, 4, {}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const QString verb = call.positional(0);
    const auto count = call.positionals().size();
    if (verb == QStringLiteral("add") && count == 4)
        return addTask(call);
    if (verb == QStringLiteral("list") && count == 2)
        return listTasks(call);
    if (verb == QStringLiteral("set") && count == 4)
        return setTask(call);
    return call.wrongCall(QStringLiteral("give add P.odo NAME task.json, list P.odo, or set P.odo TRIAL NAME"));
}

} // namespace odo
