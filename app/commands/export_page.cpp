// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/export_page.h"

#include "app/answers.h"
#include "app/command_output.h"
#include "core/base/shortage.h"
#include "core/files/output_file.h"
#include "ui/report/html_page.h"

namespace odo {

Result<void> exportPage(const CommandCall &call, const QString &file)
{
    if (call.isSet(option::columns))
        return call.wrongCall(ODO_TEXT("app.columns_are_of_csv", "--columns goes with --format csv"));
    ODO_TRY(applyLanguage(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto output =
        ODO_TRY(CommandOutput::of(call, file, FileKind::Html, project.get(), QStringLiteral(".html")));
    HtmlPageSettings settings;
    for (const QString &trial : call.positionals().mid(1))
        settings.trials.push_back(trial.toStdString());
    settings.robot = call.value(option::robot);
    settings.language = QString::fromStdString(call.value(option::language));
    const CancelScope scope(&call.control().cancel);
    const auto page =
        ODO_TRY(orShortage(cannotDoThis(), [&] { return htmlPage(*project, settings, call.control()); }));
    ODO_TRY(writeOutput(output.target(), page));
    return output.finish(call,
                         {{QStringLiteral("file"), file},
                          {QStringLiteral("format"), QStringLiteral("html")},
                          {QStringLiteral("bytes"), qint64(page.size())}},
                         QStringLiteral("Wrote %1.").arg(file));
}

} // namespace odo
