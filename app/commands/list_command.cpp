// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/json_answers.h"
#include "core/project/repositories.h"

namespace odo {

Result<void> runList(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("list"), QStringLiteral("P.odo [--json]"), 1, 1, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto title = (*project)->title();
    if (!title)
        return tl::unexpected(title.error());
    const auto all = (*project)->trials().all();
    if (!all)
        return tl::unexpected(all.error());
    QJsonArray trials;
    QStringList lines(QString::fromStdString(*title));
    for (const TrialRecord &trial : *all) {
        QJsonArray robots;
        for (const std::string &robot : trial.robotNames)
            robots.append(QString::fromStdString(robot));
        trials.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(trial.name)},
                                  {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
                                  {QStringLiteral("task"), QString::fromStdString(trial.task)},
                                  {QStringLiteral("date"), dateText(trial.date)},
                                  {QStringLiteral("robots"), robots},
                                  {QStringLiteral("duration_s"), trial.durationS},
                                  {QStringLiteral("views"), trial.viewCount}});
        lines << QStringLiteral("  %1  %2  %3  %4 s  %5")
                     .arg(QString::fromStdString(trial.name), -24)
                     .arg(QString::fromStdString(trial.teamName), -16)
                     .arg(dateText(trial.date))
                     .arg(trial.durationS, 0, 'f', 2)
                     .arg(counted(trial.viewCount, QStringLiteral("view")));
    }
    call.answer({{QStringLiteral("title"), QString::fromStdString(*title)}, {QStringLiteral("trials"), trials}},
                lines.join(u'\n'));
    return {};
}

} // namespace odo
