// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/check_repairs.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "core/project/repositories.h"

#include <QJsonArray>

namespace odo {

namespace {

/// What was repaired before the check was stopped stays repaired.
tl::unexpected<Error> stopped(Error error, bool repairs)
{
    if (repairs && error.code == ErrorCode::Cancelled)
        error.advice = "what was repaired until then is kept";
    return tl::unexpected(std::move(error));
}

} // namespace

Result<void> runCheck(const QStringList &arguments, const CancelToken &cancel)
{
    const QString quick = QStringLiteral("quick");
    QList<QCommandLineOption> options = repairOptions();
    options.prepend({quick, QStringLiteral("leave out the content of the recordings, and metrics that their digests prove")});
    CommandCall call({QStringLiteral("check"), QStringLiteral("P.odo [--quick] [--find FOLDER] [--adopt] [--remove-strays] [--json]"), 1, 1, options}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const bool repairs = asksForRepairs(call);
    const auto project = call.openProject(0, repairs ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto repaired = repairs ? repairMedia(call, **project) : MediaRepairs();
    if (!repaired)
        return stopped(repaired.error(), repairs);
    const auto problems = (*project)->check(!call.isSet(quick), call.control());
    if (!problems)
        return stopped(problems.error(), repairs);
    const auto unproved = (*project)->analyses().countWithoutDigest();
    if (!unproved)
        return tl::unexpected(unproved.error());
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
    if (*unproved > 0)
        lines << QStringLiteral("Analyses without a digest: %1. Each was made by an older Odograph, or its digest was removed. Analysing a trial again adds one.").arg(*unproved);
    json.insert(QStringLiteral("ok"), problems->empty());
    json.insert(QStringLiteral("problems"), list);
    json.insert(QStringLiteral("without_digest"), qint64(*unproved));
    call.answer(json, lines.join(u'\n'));
    if (!problems->empty())
        return fail(ErrorCode::InvalidInput, "check of '" + call.text(0) + "'",
                    counted(problems->size(), QStringLiteral("problem")).toStdString() + " found", "follow the advice given with each");
    return {};
}

} // namespace odo
