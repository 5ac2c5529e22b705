// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/history_actions.h"

#include "core/exchange/file_name.h"
#include "core/project/project.h"
#include "core/workflow/empty_bin.h"
#include "core/workflow/export_job.h"
#include "core/workflow/import_roster.h"
#include "core/workflow/reprocess_job.h"
#include "ui/history/changes_dialog.h"
#include "ui/main_window/trial_batch.h"
#include "ui/main_window/video_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/views/command_names.h"
#include "ui/views/path_field.h"
#include "ui/views/theme.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QStandardPaths>

namespace odo {

HistoryActions::HistoryActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window), m_batch(new TrialBatch(workspace, this)),
      m_roster(new QAction(themeIcon(QStringLiteral("import")), tr("Import &roster…"), this)),
      m_changes(new QAction(tr("&Changes of the project…"), this))
{
    nameCommands({{m_roster, "importRoster"}, {m_changes, "changes"}});
    connect(m_roster, &QAction::triggered, this, &HistoryActions::askRoster);
    connect(m_changes, &QAction::triggered, this, &HistoryActions::showChanges);
    connect(m_batch, &TrialBatch::ended, this, &HistoryActions::tellEnd);
    connect(&m_workspace, &Workspace::opened, this, &HistoryActions::updateActions);
    updateActions();
}

void HistoryActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_roster, m_changes});
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
        &m_window, tr("Import a roster: a table with the columns class and team, perhaps pseudonym"),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), tr("CSV tables (*.csv)"));
    if (file.isEmpty())
        return;
    const Result<RosterOutcome> outcome = importRoster(*m_workspace.project(), pathOf(file));
    if (outcome)
        Q_EMIT changed(tr("The roster is imported. Teams that are new: %1, changed: %2, as before: %3.")
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
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, tr("Export %n trial(s): choose a folder", "", static_cast<int>(trials.size())),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    if (folder.isEmpty())
        return;
    m_doneWords = tr("Exported trials: %1 of %2.");
    const auto make = [path = pathOf(folder)](const std::string &trial) {
        return std::make_shared<ExportJob>(trial, path, CsvStyle::Analysis);
    };
    if (const Result<void> started = m_batch->start(trials, {tr("Exporting %1 (%2 of %3)"), make, {}});
        !started)
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
    m_doneWords = tr("Videos made: %1 of %2.");
    const auto make = [path = pathOf(folder), settings = dialog.settings()](const std::string &trial) {
        AnnotatedVideoSettings own = settings;
        own.target = {path / (fileNameOf(trial) + ".mp4"), Existing::Refuse};
        return std::make_shared<AnnotatedVideoJob>(trial, own);
    };
    if (const Result<void> started = m_batch->start(trials, {tr("Making the video of %1 (%2 of %3)"), make, {}});
        !started)
        Q_EMIT failed(started.error());
}

void HistoryActions::reprocessTrials(const QStringList &trials)
{
    m_doneWords = tr("Trials measured again: %1 of %2.");
    const auto make = [](const std::string &trial) { return std::make_shared<ReprocessJob>(trial); };
    const auto keep = [](Project &project, Job &job) {
        return static_cast<ReprocessJob &>(job).keep(project);
    };
    if (const Result<void> started =
            m_batch->start(trials, {tr("Measuring %1 again (%2 of %3)"), make, keep});
        !started)
        Q_EMIT failed(started.error());
}

void HistoryActions::emptyBin(const BinContent &content)
{
    const auto job = std::make_shared<EmptyBinJob>(content);
    const Result<void> started = m_workspace.start(job, tr("Emptying the bin"), [this, job] {
        QString words = job->removedCount() == job->wantedCount()
                            ? tr("%n trial(s) removed for good.", "", job->removedCount())
                            : tr("%1 of %n trial(s) removed for good; the rest is still there.", "", job->wantedCount())
                                  .arg(job->removedCount());
        for (const std::string &file : job->left())
            words += u' ' + tr("%1 could not be deleted; delete it by hand.").arg(QString::fromStdString(file));
        Q_EMIT changed(words);
    });
    if (!started)
        Q_EMIT failed(started.error());
}

void HistoryActions::tellEnd(int done, int all, const QStringList &failures)
{
    const QString words = m_doneWords.arg(done).arg(all);
    if (failures.isEmpty()) {
        Q_EMIT changed(words);
        return;
    }
    constexpr qsizetype most = 3;
    QStringList told = failures.mid(0, most);
    if (failures.size() > most)
        told << tr("and %1 more").arg(failures.size() - most);
    Q_EMIT changed({});
    Q_EMIT failed({ErrorCode::InvalidInput, words.chopped(1).toStdString(),
                   told.join(QStringLiteral("; ")).toStdString(),
                   tr("mend what stands there, and choose these trials again").toStdString()});
}

} // namespace odo
