// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/class_actions.h"

#include "core/exchange/file_name.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/workflow/export_job.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/import/teams.h"
#include "core/workflow/job.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/track/reanalysis.h"
#include "ui/history/classes_dialog.h"
#include "ui/main_window/internal/export_dialog.h"
#include "ui/main_window/internal/robots_dialog.h"
#include "ui/main_window/internal/trial_export.h"
#include "ui/main_window/workspace.h"
#include "ui/models/project_changes.h"
#include "ui/models/shown_message.h"
#include "ui/scoreboard/scoreboard_dialog.h"
#include "ui/testbed/tasks/tasks_dialog.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QStandardPaths>
#include <QTableView>
#include <QVBoxLayout>
#include <QWidget>
#include <ranges>
#include <utility>
#include <vector>

namespace odo {

/// Read-only list of the changes of the project with their times.
class ChangesDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ChangesDialog(std::vector<ChangeEntry> changes, QWidget *parent = nullptr);
};

ChangesDialog::ChangesDialog(std::vector<ChangeEntry> changes, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Project changes"));
    auto *intro = new QLabel(
        changes.empty() ? tr("No changes yet.")
                        : tr("All changes made in this window and on the command line, newest first. The "
                             "list includes recordings, imports and tracking, but you cannot undo them."));
    intro->setWordWrap(true);
    auto *model = new ChangeModel(std::move(changes), this);
    auto *search = new QLineEdit;
    search->setPlaceholderText(tr("Search the changes…"));
    search->setAccessibleName(tr("Search the changes"));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, model, &ChangeModel::setText);
    auto *table = new QTableView;
    table->setModel(model);
    table->setAccessibleName(tr("Changes"));
    showAsList(*table);
    table->horizontalHeader()->setResizeContentsPrecision(0);
    table->horizontalHeader()->setStretchLastSection(true);
    table->resizeColumnsToContents();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addWidget(search);
    layout->addWidget(table, 1);
    layout->addWidget(buttons);
    resize(720, 480);
}

ClassActions::ClassActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window), m_tasks(new QAction(tr("&Tasks…"), this)),
      m_classes(new QAction(tr("C&lasses and teams…"), this)), m_robots(new QAction(tr("R&obots…"), this)),
      m_standings(new QAction(themeIcon(QStringLiteral("history")), tr("Show &standings…"), this))
{
    connect(m_tasks, &QAction::triggered, this, &ClassActions::showTasks);
    connect(m_classes, &QAction::triggered, this, &ClassActions::showClasses);
    connect(m_robots, &QAction::triggered, this, &ClassActions::showRobots);
    connect(m_standings, &QAction::triggered, this, &ClassActions::showStandings);
    connect(&m_workspace, &Workspace::opened, this, &ClassActions::updateActions);
    connect(&m_workspace, &Workspace::aboutToClose, this, [this] { delete m_scoreboard; }); // it reads there
    nameCommands(
        {{m_tasks, "tasks"}, {m_classes, "classes"}, {m_robots, "robots"}, {m_standings, "standings"}});
    updateActions();
}

void ClassActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_tasks, m_classes, m_robots});
}

void ClassActions::updateActions()
{
    for (QAction *action : {m_tasks, m_classes, m_robots, m_standings})
        action->setEnabled(m_workspace.project() != nullptr);
}

void ClassActions::showTasks()
{
    TasksDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &TasksDialog::changed, this, &ClassActions::changed);
    QStringList again;
    connect(&dialog, &TasksDialog::reprocessRequested, this,
            [&again](const QStringList &trials) { again = trials; });
    dialog.exec();
    if (!again.isEmpty())
        Q_EMIT reprocessRequested(again);
}

void ClassActions::showClasses()
{
    ClassesDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &ClassesDialog::changed, this, &ClassActions::changed);
    bool roster = false;
    connect(&dialog, &ClassesDialog::rosterRequested, this, [&roster] { roster = true; });
    dialog.exec();
    if (roster)
        Q_EMIT rosterRequested();
}

void ClassActions::showRobots()
{
    RobotsDialog dialog(*m_workspace.project(), m_workspace.isReadOnly(), &m_window);
    connect(&dialog, &RobotsDialog::changed, this, &ClassActions::changed);
    dialog.exec();
}

void ClassActions::showStandings()
{
    if (!m_scoreboard)
        m_scoreboard = new ScoreboardDialog(*m_workspace.project(), &m_window);
    m_scoreboard->show();
    m_scoreboard->raise();
    m_scoreboard->activateWindow();
}

HistoryActions::HistoryActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window), m_batch(new TrialBatch(workspace, this)),
      m_roster(new QAction(themeIcon(QStringLiteral("import")), tr("Import &roster…"), this)),
      m_changes(new QAction(tr("Show project &changes…"), this))
{
    nameCommands({{m_roster, "importRoster"}, {m_changes, "changes"}});
    connect(m_roster, &QAction::triggered, this, &HistoryActions::askRoster);
    connect(m_changes, &QAction::triggered, this, &HistoryActions::showChanges);
    connect(m_batch, &TrialBatch::ended, this, &HistoryActions::tellEnd);
    connect(&m_workspace, &Workspace::opened, this, &HistoryActions::updateActions);
    updateActions();
}

bool HistoryActions::isRunning() const
{
    return m_batch->isRunning();
}

void HistoryActions::updateActions()
{
    m_changes->setEnabled(m_workspace.project() != nullptr);
    m_roster->setEnabled(m_workspace.project() != nullptr && !m_workspace.isReadOnly());
}

void HistoryActions::askRoster()
{
    const QString file = QFileDialog::getOpenFileName(
        &m_window, tr("Import a roster: a table with the columns class, team and optionally pseudonym"),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), tr("CSV tables (*.csv)"));
    if (file.isEmpty())
        return;
    const Result<RosterOutcome> outcome = importRoster(*m_workspace.project(), pathOf(file));
    if (outcome)
        Q_EMIT changed(tr("Roster imported. New teams: %1, changed: %2, unchanged: %3.")
                           .arg(outcome->added)
                           .arg(outcome->changed)
                           .arg(outcome->unchanged));
    else
        Q_EMIT failed(outcome.error());
}

void HistoryActions::showChanges()
{
    Result<std::vector<ChangeEntry>> changes = m_workspace.project()->changes();
    if (!changes) {
        Q_EMIT failed(changes.error());
        return;
    }
    ChangesDialog(std::move(*changes), &m_window).exec();
}

void HistoryActions::exportTrials(const QStringList &trials)
{
    const auto count = static_cast<int>(trials.size());
    ExportDialog dialog({tr("Export %n trial(s)", "", count), {}, false, false, {}}, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, tr("Export %n trial(s): choose a folder", "", count),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    if (folder.isEmpty())
        return;
    m_doneWords = &ODO_TEXT("ui.exported_trials", "Exported trials: %1 of %2");
    const auto make = [path = pathOf(folder), how = dialog.settings()](const std::string &trial) {
        return std::make_shared<ExportJob>(trial, path, how);
    };
    const Result<void> started =
        m_batch->start(trials, {&ODO_TEXT("ui.exporting", "Exporting %1 (%2 of %3)"), make, {}});
    if (started)
        m_folder = folder;
    else
        Q_EMIT failed(started.error());
}

void HistoryActions::exportVideos(const QStringList &trials)
{
    const QString title = tr("Videos of %n trial(s)", "", static_cast<int>(trials.size()));
    VideoDialog dialog(title, isDark(m_window.palette()), &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, title, QStandardPaths::writableLocation(QStandardPaths::MoviesLocation));
    if (folder.isEmpty())
        return;
    m_doneWords = &ODO_TEXT("ui.videos_made", "Videos created: %1 of %2");
    const auto make = [path = pathOf(folder), settings = dialog.settings()](const std::string &trial) {
        AnnotatedVideoSettings own = settings;
        own.target = {path / (fileNameOf(trial) + ".mp4"), Existing::Refuse};
        return std::make_shared<AnnotatedVideoJob>(trial, own);
    };
    const Result<void> started = m_batch->start(
        trials, {&ODO_TEXT("ui.making_videos", "Creating the video of %1 (%2 of %3)"), make, {}});
    if (started)
        m_folder = folder;
    else
        Q_EMIT failed(started.error());
}

void HistoryActions::reprocessTrials(const QStringList &trials)
{
    m_doneWords = &ODO_TEXT("ui.trials_measured_again", "Trials reanalysed: %1 of %2");
    const auto make = [](const std::string &trial) { return std::make_shared<ReprocessJob>(trial); };
    const auto keep = [](Project &project, Job &job) {
        return static_cast<ReprocessJob &>(job).keep(project);
    };
    if (const Result<void> started = m_batch->start(
            trials, {&ODO_TEXT("ui.measuring_trials_again", "Reanalysing %1 (%2 of %3)"), make, keep});
        !started)
        Q_EMIT failed(started.error());
}

void HistoryActions::importTrials(const std::vector<ImportSettings> &trials)
{
    QStringList names;
    for (const ImportSettings &trial : trials)
        names << QString::fromStdString(trial.trial);
    const auto make = [trials](const std::string &trial) {
        return std::make_shared<ImportTrialJob>(*std::ranges::find(trials, trial, &ImportSettings::trial));
    };
    const auto keep = [this](Project &, Job &job) -> Result<void> {
        const auto &imported = static_cast<ImportTrialJob &>(job);
        for (const Message &warning : imported.warnings())
            m_remarks.push_back(joined({trialSubject(imported.trial().name), warning}, Join::Colon));
        return {};
    };
    const Result<void> started =
        m_batch->start(names, {&ODO_TEXT("ui.importing_trials", "Importing %1 (%2 of %3)"), make, keep});
    if (started)
        m_doneWords = &ODO_TEXT("ui.trials_imported", "Trials imported: %1 of %2");
    else
        Q_EMIT failed(started.error());
}

void HistoryActions::emptyBin(const BinContent &content)
{
    const auto job = std::make_shared<EmptyBinJob>(content);
    const Result<void> started =
        m_workspace.start(job, ODO_TEXT("ui.emptying_bin", "Emptying the bin"), [this, job] {
            QString words = job->removedCount() == job->wantedCount()
                                ? tr("%n trial(s) removed for good.", "", job->removedCount())
                                : tr("Removed %1 of %n trial(s) for good; the rest is still in the bin.", "",
                                     job->wantedCount())
                                      .arg(job->removedCount());
            for (const std::string &file : job->left())
                words += u' ' +
                         tr("%1 could not be deleted; delete it by hand.").arg(QString::fromStdString(file));
            Q_EMIT changed(words);
        });
    if (!started)
        Q_EMIT failed(started.error());
}

void HistoryActions::tellEnd(int done, int all, const std::vector<Error> &failures)
{
    const Message words = (*m_doneWords)(done, all);
    std::vector<Message> told = std::exchange(m_remarks, {});
    const QString folder = std::exchange(m_folder, {});
    if (failures.empty()) {
        QStringList sentences(fullSentence(shownWords(words)));
        for (const Message &remark : told)
            sentences << fullSentence(shownWords(remark));
        Q_EMIT changed({sentences.join(QLatin1Char(' ')), std::move(told), folder});
        return;
    }
    constexpr std::size_t most = 3;
    for (const Error &each : failures | std::views::take(most)) {
        told.push_back(joined({each.what, each.why}, Join::Colon));
        told.push_back(each.advice);
    }
    if (failures.size() > most)
        told.push_back(ODO_TEXT("ui.and_more", "and %1 more")(failures.size() - most));
    Q_EMIT changed(QString());
    Q_EMIT failed(
        {ErrorCode::InvalidInput, words, joined(std::move(told), Join::Semicolon),
         ODO_TEXT("ui.mend_and_choose_again", "correct the listed errors, then select these trials again")});
}

TrialBatch::TrialBatch(Workspace &workspace, QObject *parent) : QObject(parent), m_workspace(workspace)
{
    // Queued: the workspace is free for the next job when the signal of the last one is over.
    connect(
        &m_workspace, &Workspace::jobDone, this, [this] { goOn(nullptr); }, Qt::QueuedConnection);
    connect(
        &m_workspace, &Workspace::jobFailed, this, [this](const Error &error) { goOn(&error); },
        Qt::QueuedConnection);
    connect(&m_workspace, &Workspace::aboutToClose, this, [this] {
        m_trials.clear();
        m_job.reset();
    });
}

Result<void> TrialBatch::start(const QStringList &trials, Work work)
{
    if (m_workspace.isBusy() || isRunning())
        return fail(ErrorCode::InvalidInput, ODO_TEXT("ui.many_trials", "many trials"), anotherJobRuns(),
                    waitOrCancel());
    m_work = std::move(work);
    m_trials = trials;
    m_next = 0;
    m_done = 0;
    m_failures.clear();
    auto started = startNext();
    if (!started)
        m_trials.clear();
    return started;
}

Result<void> TrialBatch::startNext()
{
    const std::string trial = m_trials.at(m_next++).toStdString();
    m_job = m_work.make(trial);
    return m_workspace.start(m_job, (*m_work.words)(Named::trial(trial), m_next, m_trials.size()), nullptr);
}

void TrialBatch::goOn(const Error *error)
{
    if (!isRunning() || !m_job)
        return;
    const bool isCancelled = error && error->code == ErrorCode::Cancelled;
    if (error && !isCancelled) {
        m_failures.push_back(*error);
    } else if (!error) {
        const Result<void> kept = m_work.keep ? m_work.keep(*m_workspace.project(), *m_job) : Result<void>();
        if (kept)
            ++m_done;
        else
            m_failures.push_back(kept.error());
    }
    m_job.reset();
    if (isCancelled || m_next == m_trials.size())
        return end();
    if (const Result<void> started = startNext(); !started) {
        m_failures.push_back(started.error());
        end();
    }
}

void TrialBatch::end()
{
    const int all = static_cast<int>(m_trials.size());
    m_trials.clear();
    Q_EMIT ended(m_done, all, m_failures);
}

} // namespace odo

#include "class_actions.moc"
