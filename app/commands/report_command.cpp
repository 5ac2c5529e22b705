// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/option_names.h"
#include "app/output_option.h"
#include "app/report_options.h"
#include "ui/report/pdf_file.h"
#include "ui/report/report_job.h"

#include <QCoreApplication>

namespace odo {

namespace {

QList<QCommandLineOption> reportSyntax()
{
    return outputOptions(QStringLiteral("The PDF file to write.")) + QList<QCommandLineOption>{
               {option::ofClass, QStringLiteral("The ranking of this class, before the trials."), QStringLiteral("CLASS")},
               {option::task, QStringLiteral("In which task; without it, the one that most of its trials have."), QStringLiteral("TASK")},
               {option::figure, QStringLiteral("By which figure; without it, the score, or else what tells most."), QStringLiteral("NAME")},
               {option::teams, QStringLiteral("A page for each team of the class, too.")}} +
           reportOptionSyntax();
}

} // namespace

Result<void> runReport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("report"), QStringLiteral("P.odo [TRIAL]... -o report.pdf [--force] [--class CLASS]"), 1, -1, reportSyntax()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.wrongCall(QStringLiteral("-o is missing"));
    const bool hasTrials = call.positionals().size() > 1;
    if (!hasTrials && !call.isSet(option::ofClass))
        return call.wrongCall(QStringLiteral("name a trial, or a class with --class"));
    if (!call.isSet(option::ofClass))
        for (const QString &needsClass : {option::task, option::figure, option::teams})
            if (call.isSet(needsClass))
                return call.wrongCall(QStringLiteral("--%1 needs --class").arg(needsClass));
    const auto options = readReportOptions(call);
    if (!options)
        return tl::unexpected(options.error());
    const auto project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto target = outputOf(call, call.value(option::output), FileKind::Pdf, project->get());
    if (!target)
        return tl::unexpected(target.error());
    std::vector<ReportMaker> makers;
    if (call.isSet(option::ofClass))
        makers.push_back(classReport({call.value(option::ofClass), call.value(option::task), call.value(option::figure), call.isSet(option::teams)}, *options));
    if (hasTrials) {
        std::vector<std::string> trials;
        for (const QString &trial : call.positionals().mid(1))
            trials.push_back(trial.toStdString());
        makers.push_back(trialReports(std::move(trials), *options));
    }
    ReportJob job(inTurn(std::move(makers)), std::make_unique<PdfFile>(*target, QStringLiteral("Odograph report")));
    if (auto made = runToEnd(job, **project, call.control()); !made)
        return made;
    const QString file = QString::fromStdString(call.value(option::output));
    call.answer({{QStringLiteral("report"), file}, {QStringLiteral("pages"), job.pageCount()}},
                QStringLiteral("Wrote %1, %2.").arg(file, counted(job.pageCount(), QStringLiteral("page"))));
    return {};
}

} // namespace odo
