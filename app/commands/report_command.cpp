// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/report_options.h"
#include "ui/report/pdf_file.h"
#include "ui/report/report_job.h"

#include <QCoreApplication>

namespace odo {

namespace {

const QString output = QStringLiteral("output"), ofClass = QStringLiteral("class"), task = QStringLiteral("task"),
              figure = QStringLiteral("figure"), teams = QStringLiteral("teams");

QList<QCommandLineOption> reportSyntax()
{
    return QList<QCommandLineOption>{
               {{QStringLiteral("o"), output}, QStringLiteral("The PDF file to write."), QStringLiteral("FILE")},
               {ofClass, QStringLiteral("The ranking of this class, before the trials."), QStringLiteral("CLASS")},
               {task, QStringLiteral("In which task; without it, the one that most of its trials have."), QStringLiteral("TASK")},
               {figure, QStringLiteral("By which figure; without it, the score, or else what tells most."), QStringLiteral("NAME")},
               {teams, QStringLiteral("A page for each team of the class, too.")}} +
           reportOptionSyntax();
}

} // namespace

Result<void> runReport(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("report"), QStringLiteral("P.odo [TRIAL]... -o report.pdf [--class CLASS]"), 1, -1, reportSyntax()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(output))
        return call.wrongCall(QStringLiteral("-o is missing"));
    const bool hasTrials = call.positionals().size() > 1;
    if (!hasTrials && !call.isSet(ofClass))
        return call.wrongCall(QStringLiteral("name a trial, or a class with --class"));
    if (!call.isSet(ofClass))
        for (const QString &needsClass : {task, figure, teams})
            if (call.isSet(needsClass))
                return call.wrongCall(QStringLiteral("--%1 needs --class").arg(needsClass));
    const auto options = readReportOptions(call);
    if (!options)
        return tl::unexpected(options.error());
    const auto project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    std::vector<ReportMaker> makers;
    if (call.isSet(ofClass))
        makers.push_back(classReport({call.value(ofClass), call.value(task), call.value(figure), call.isSet(teams)}, *options));
    if (hasTrials) {
        std::vector<std::string> trials;
        for (const QString &trial : call.positionals().mid(1))
            trials.push_back(trial.toStdString());
        makers.push_back(trialReports(std::move(trials), *options));
    }
    ReportJob job(inTurn(std::move(makers)), std::make_unique<PdfFile>(call.value(output), QStringLiteral("Odograph report")));
    if (auto made = runToEnd(job, **project, call.control()); !made)
        return made;
    const QString file = QString::fromStdString(call.value(output));
    call.answer({{QStringLiteral("report"), file}, {QStringLiteral("pages"), job.pageCount()}},
                QStringLiteral("Wrote %1, %2 pages.").arg(file).arg(job.pageCount()));
    return {};
}

} // namespace odo
