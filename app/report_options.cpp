// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_options.h"

#include "app/command_call.h"
#include "app/language_option.h"
#include "app/option_names.h"
#include "ui/report/logo.h"

namespace odo {

QList<QCommandLineOption> reportOptionSyntax()
{
    return {{option::paper, QStringLiteral("a4 or letter."), QStringLiteral("PAPER"), QStringLiteral("a4")},
            {option::school, QStringLiteral("The name at the head of each page."), QStringLiteral("TEXT")},
            {option::logo, QStringLiteral("A picture at the head of each page (PNG, JPEG, SVG)."), QStringLiteral("FILE")},
            {option::remark, QStringLiteral("A line at the foot of each page."), QStringLiteral("TEXT")},
            {option::method, QStringLiteral("A second page for each trial: how its figures were computed, and what was measured.")},
            languageOption()};
}

Result<ReportOptions> readReportOptions(const CommandCall &call)
{
    ReportOptions options;
    const QString wanted = QString::fromStdString(call.value(option::paper));
    options.paper = paperFromWord(wanted);
    if (paperWord(options.paper) != wanted)
        return call.wrongCall(QStringLiteral("--paper is a4 or letter"));
    options.letterhead.school = QString::fromStdString(call.value(option::school));
    options.letterhead.remark = QString::fromStdString(call.value(option::remark));
    options.withMethod = call.isSet(option::method);
    if (auto applied = applyLanguage(call); !applied)
        return tl::unexpected(applied.error());
    if (call.isSet(option::logo)) {
        auto picture = readLogo(call.value(option::logo));
        if (!picture)
            return tl::unexpected(picture.error());
        options.letterhead.logo = std::move(*picture);
    }
    return options;
}

} // namespace odo
