// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_options.h"

#include "app/command_call.h"
#include "core/project/repositories.h"
#include "ui/main_window/language.h"
#include "ui/report/report_settings.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {

namespace {

/// Protects the recordings that are not in the media folder, where nothing may be written anyway.
Result<void> protectRecordings(Project &project, InputFiles &files)
{
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    const std::string media = project.mediaFolder().string() + '/';
    for (const RecordingRecord &recording : recordings)
        if (const auto file = project.resolve(recording); !file.string().starts_with(media))
            files.add(file);
    return {};
}

} // namespace

QCommandLineOption forceOption()
{
    return {option::force, QStringLiteral("Replace a file of another kind, too.")};
}

QList<QCommandLineOption> outputOptions(const QString &description)
{
    return {{{QStringLiteral("o"), option::output}, description, QStringLiteral("FILE")}, forceOption()};
}

Result<OutputTarget> outputOf(const CommandCall &call, const std::string &file, std::optional<FileKind> kind,
                              Project *project)
{
    const OutputTarget target(file,
                              call.isSet(option::force) ? Existing::ReplaceAny : Existing::ReplaceSameKind);
    if (project && identityOf(target.file))
        ODO_TRY(protectRecordings(*project, call.recordings()));
    return checkOutput(target, kind).map([&](const OutputPlace &) { return target; });
}

namespace {

QStringList codes()
{
    QStringList codes;
    for (const Language &each : languages())
        codes << each.code;
    return codes;
}

} // namespace

QCommandLineOption languageOption()
{
    return {option::language,
            QStringLiteral("Of the words and numbers: %1.").arg(codes().join(QStringLiteral(", "))),
            QStringLiteral("CODE"), QStringLiteral("en")};
}

Result<void> applyLanguage(const CommandCall &call)
{
    const QString code = QString::fromStdString(call.value(option::language));
    if (!codes().contains(code))
        return call.wrongCall(ODO_TEXT("app.language_is_one_of", "--language is one of %1")(
            codes().join(QStringLiteral(", ")).toStdString()));
    installLanguage(*qApp, code);
    return {};
}

QList<QCommandLineOption> reportOptionSyntax()
{
    return {{option::paper, QStringLiteral("a4 or letter."), QStringLiteral("PAPER"), QStringLiteral("a4")},
            {option::school, QStringLiteral("The name at the head of each page."), QStringLiteral("TEXT")},
            {option::logo, QStringLiteral("A picture at the head of each page (PNG, JPEG, SVG)."),
             QStringLiteral("FILE")},
            {option::remark, QStringLiteral("A line at the foot of each page."), QStringLiteral("TEXT")},
            {option::method,
             QStringLiteral(
                 "A second page for each trial: how its figures were computed, and what was measured.")},
            languageOption()};
}

Result<ReportOptions> readReportOptions(const CommandCall &call)
{
    ReportOptions options;
    const QString wanted = QString::fromStdString(call.value(option::paper));
    options.paper = paperFromWord(wanted);
    if (paperWord(options.paper) != wanted)
        return call.wrongCall(ODO_TEXT("app.report_paper_is", "--paper is a4 or letter"));
    options.letterhead.school = QString::fromStdString(call.value(option::school));
    options.letterhead.remark = QString::fromStdString(call.value(option::remark));
    options.withMethod = call.isSet(option::method);
    ODO_TRY(applyLanguage(call));
    if (call.isSet(option::logo)) {
        auto picture = ODO_TRY(readLogo(call.value(option::logo)));
        options.letterhead.logo = std::move(picture);
    }
    return options;
}

} // namespace odo
