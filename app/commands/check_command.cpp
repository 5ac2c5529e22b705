// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/check_repairs.h"
#include "app/commands/commands.h"

#include <QJsonArray>

namespace odo {

Result<void> runCheck(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("check"), QStringLiteral("P.odo [--find FOLDER] [--adopt] [--remove-strays] [--json]"), 1, 1, repairOptions()}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const bool repairs = asksForRepairs(call);
    const auto project = call.openProject(0, repairs ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto repaired = repairs ? repairMedia(call, **project) : MediaRepairs();
    if (!repaired)
        return tl::unexpected(repaired.error());
    const auto problems = (*project)->check(true);
    if (!problems)
        return tl::unexpected(problems.error());
    QJsonArray list;
    QStringList lines = repaired->lines;
    QJsonObject json = repaired->json;
    for (const ProjectProblem &problem : *problems) {
        list.append(QJsonObject{{QStringLiteral("what"), QString::fromStdString(problem.what)},
                                {QStringLiteral("where"), QString::fromStdString(problem.where)},
                                {QStringLiteral("advice"), QString::fromStdString(problem.advice)}});
        lines << QString::fromStdString(problem.where + ": " + problem.what + "; " + problem.advice);
    }
    if (problems->empty())
        lines << QStringLiteral("All is well.");
    json.insert(QStringLiteral("ok"), problems->empty());
    json.insert(QStringLiteral("problems"), list);
    call.answer(json, lines.join(u'\n'));
    if (!problems->empty())
        return fail(ErrorCode::InvalidInput, "check of '" + call.text(0) + "'",
                    std::to_string(problems->size()) + " problems found", "follow the advice given with each");
    return {};
}

} // namespace odo
