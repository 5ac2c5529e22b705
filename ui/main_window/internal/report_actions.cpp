// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/report_actions.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/export_job.h"
#include "ui/compare/compare_page.h"
#include "ui/main_window/project_pages.h"
#include "ui/main_window/workspace.h"
#include "ui/models/results.h"
#include "ui/report/certificate_report.h"
#include "ui/report/report_dialog.h"
#include "ui/report/report_output.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QDir>
#include <QInputDialog>
#include <QPrintDialog>
#include <QPrinter>
#include <QStandardPaths>

namespace odo {

namespace {

const QString ending = QStringLiteral("pdf");

ReportSubject subjectOfTrial(const std::string &trial)
{
    const QString name = QString::fromStdString(trial);
    return {ReportActions::tr("The trial %1").arg(name), name, {trial}, {}, false};
}

} // namespace

ReportActions::ReportActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window),
      m_report(new QAction(themeIcon(QStringLiteral("print")), tr("&Report…"), this)),
      m_certificate(new QAction(tr("C&ertificate of this set-up…"), this))
{
    nameCommands({{m_report, "report"}, {m_certificate, "certificate"}});
    m_certificate->setEnabled(false);
    connect(m_certificate, &QAction::triggered, this, &ReportActions::askCertificate);
    m_report->setShortcut(QKeySequence::Print);
    m_report->setEnabled(false);
    connect(m_report, &QAction::triggered, this, qOverload<>(&ReportActions::ask));
}

ReportActions::~ReportActions() = default;

void ReportActions::setPages(ProjectPages *pages)
{
    m_pages = pages;
    m_dialog.reset(); // it reads the project
    m_report->setEnabled(pages != nullptr);
    m_certificate->setEnabled(pages != nullptr);
}

/// What is on screen first.
QList<ReportSubject> ReportActions::shownSubjects() const
{
    QList<ReportSubject> subjects;
    if (const TrialScenePtr scene = m_pages->scene())
        subjects << subjectOfTrial(scene->trial.name);
    if (m_pages->mode() == ProjectPages::Mode::Compare)
        if (const ComparisonScenePtr scene = m_pages->compare().scene()) {
            const QString words =
                tr("The comparison of %1 and %2")
                    .arg(QString::fromStdString(scene->name(0)), QString::fromStdString(scene->name(1)));
            subjects.prepend({words, words, {}, scene->settings, false});
        }
    const ReportSubject ofClass{tr("A class"), {}, {}, {}, true};
    const bool hasClasses =
        !m_workspace.project()->classes().all().value_or(std::vector<ClassRecord>()).empty();
    if (hasClasses && m_pages->mode() == ProjectPages::Mode::History)
        subjects.prepend(ofClass);
    else if (hasClasses)
        subjects << ofClass;
    return subjects;
}

ReportChoices ReportActions::choices() const
{
    Project &project = *m_workspace.project();
    ReportChoices choices;
    for (const ClassRecord &each : project.classes().all().value_or(std::vector<ClassRecord>()))
        choices.classes << QString::fromStdString(each.name);
    for (const TaskRecord &task : project.tasks().current().value_or(std::vector<TaskRecord>()))
        choices.tasks << QString::fromStdString(task.name);
    if (const auto scorings = project.tasks().scorings(); scorings && !scorings->empty())
        choices.metricNames.emplace_back(scoreMetric);
    for (std::string &name :
         informativeMetricNames(project.analyses().metricNames().value_or(std::vector<std::string>())))
        choices.metricNames.push_back(std::move(name));
    return choices;
}

void ReportActions::ask()
{
    ask(shownSubjects());
}

void ReportActions::askTrials(const QStringList &trials)
{
    if (trials.size() == 1)
        return ask({subjectOfTrial(trials.front().toStdString())});
    ReportSubject subject{
        tr("%n trial(s), a page each", "", int(trials.size())), tr("Trials"), {}, {}, false};
    for (const QString &trial : trials)
        subject.trials.push_back(trial.toStdString());
    ask({subject});
}

void ReportActions::ask(QList<ReportSubject> subjects)
{
    if (subjects.isEmpty()) {
        Q_EMIT failed(fail(ErrorCode::NotFound, reportSubject(),
                           ODO_TEXT("ui.no_trial_yet", "the project has no trial yet"),
                           ODO_TEXT("ui.import_or_record_first", "import or record one first"))
                          .value());
        return;
    }
    m_dialog = std::make_unique<ReportDialog>(m_workspace.project()->file(), std::move(subjects), choices(),
                                              &m_window);
    connect(m_dialog.get(), &ReportDialog::letterheadRequested, this, [this] {
        Q_EMIT letterheadRequested();
        m_dialog->refresh();
    });
    connect(m_dialog.get(), &ReportDialog::saveRequested, this, &ReportActions::save);
    connect(m_dialog.get(), &ReportDialog::printRequested, this, &ReportActions::print);
    m_dialog->exec();
    m_dialog->preview().clear();
}

void ReportActions::save()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString name = QString::fromStdString(fileNameOf(m_dialog->proposedName().toStdString()));
    const auto chosen =
        askOutput(m_dialog.get(), tr("Save the report"), folder.filePath(name + u'.' + ending),
                  {{tr("PDF files (*.pdf)"), ending, FileKind::Pdf}});
    if (chosen)
        write(*chosen);
}

void ReportActions::write(const ChosenOutput &output)
{
    start(std::make_unique<PdfFile>(output.target, m_dialog->proposedName()),
          {tr("Report saved as %1.").arg(QDir::toNativeSeparators(output.file)), {}, output.file});
}

void ReportActions::print()
{
    auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(m_dialog->proposedName());
    QPrintDialog question(printer.get(), m_dialog.get());
    if (question.exec() != QDialog::Accepted)
        return;
    // not by Qt, which would write over anything; it has asked
    if (const QString file = printer->outputFileName(); !file.isEmpty())
        return write({{pathOf(file), Existing::ReplaceAny}, file});
    const QString words = tr("Report sent to printer %1.").arg(printer->printerName());
    start(std::make_unique<PrintedPages>(std::move(printer)), words);
}

/// The window is free again; its status line has the progress, and how to cancel.
void ReportActions::start(std::unique_ptr<PageOutput> output, const DoneWork &work)
{
    auto job = std::make_shared<ReportJob>(m_dialog->maker(), std::move(output));
    m_dialog->accept();
    startJob(std::move(job), ODO_TEXT("ui.making_report", "Creating the report"), work);
}

void ReportActions::startJob(std::shared_ptr<ReportJob> job, const Message &words, const DoneWork &work)
{
    const auto started = m_workspace.start(std::move(job), words, [this, work] { Q_EMIT done(work); });
    if (!started)
        Q_EMIT failed(started.error());
}

/// Which run, then where to; the simulation goes on beside the window.
void ReportActions::askCertificate()
{
    QStringList runs(tr("Over the floor that the cameras see"));
    for (const TaskRecord &task :
         m_workspace.project()->tasks().current().value_or(std::vector<TaskRecord>()))
        runs << QString::fromStdString(task.name);
    int chosenRun = 0;
    if (runs.size() > 1) {
        QInputDialog question(&m_window);
        question.setWindowTitle(m_certificate->iconText());
        question.setLabelText(tr("The simulated run:"));
        question.setComboBoxItems(runs);
        if (question.exec() != QDialog::Accepted)
            return;
        chosenRun = int(std::max<qsizetype>(0, runs.indexOf(question.textValue())));
    }
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const auto chosen =
        askOutput(&m_window, tr("Save the certificate"), folder.filePath(tr("Certificate") + u'.' + ending),
                  {{tr("PDF files (*.pdf)"), ending, FileKind::Pdf}});
    if (!chosen)
        return;
    CertificateSettings settings;
    if (chosenRun > 0)
        settings.task = runs.at(chosenRun).toStdString();
    auto maker = reportBy(storedReportSettings(), [settings](const ReportOptions &options) {
        return certificateReport(settings, options);
    });
    startJob(std::make_shared<ReportJob>(std::move(maker),
                                         std::make_unique<PdfFile>(chosen->target, tr("Certificate"))),
             ODO_TEXT("ui.making_certificate", "Simulating the set-up"),
             {tr("Certificate saved as %1.").arg(QDir::toNativeSeparators(chosen->file)), {}, chosen->file});
}

} // namespace odo
