// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_options.h"

#include "app/command_call.h"
#include "app/language_option.h"
#include "ui/report/logo.h"

namespace odo {

namespace {

const QString paper = QStringLiteral("paper"), school = QStringLiteral("school"), logo = QStringLiteral("logo"),
              remark = QStringLiteral("remark"), method = QStringLiteral("method");

} // namespace

QList<QCommandLineOption> reportOptionSyntax()
{
    return {{paper, QStringLiteral("a4 or letter."), QStringLiteral("PAPER"), QStringLiteral("a4")},
            {school, QStringLiteral("The name at the head of each page."), QStringLiteral("TEXT")},
            {logo, QStringLiteral("A picture at the head of each page (PNG, JPEG, SVG)."), QStringLiteral("FILE")},
            {remark, QStringLiteral("A line at the foot of each page."), QStringLiteral("TEXT")},
            {method, QStringLiteral("A second page for each trial: how its figures were computed, and what was measured.")},
            languageOption()};
}

Result<ReportOptions> readReportOptions(const CommandCall &call)
{
    ReportOptions options;
    const QString wanted = QString::fromStdString(call.value(paper));
    options.paper = paperFromWord(wanted);
    if (paperWord(options.paper) != wanted)
        return call.wrongCall(QStringLiteral("--paper is a4 or letter"));
    options.letterhead.school = QString::fromStdString(call.value(school));
    options.letterhead.remark = QString::fromStdString(call.value(remark));
    options.withMethod = call.isSet(method);
    if (auto applied = applyLanguage(call); !applied)
        return tl::unexpected(applied.error());
    if (call.isSet(logo)) {
        auto picture = readLogo(call.value(logo));
        if (!picture)
            return tl::unexpected(picture.error());
        options.letterhead.logo = std::move(*picture);
    }
    return options;
}

} // namespace odo
