// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace odo {

class ScoreboardDialog;
class Workspace;

/// What a class has, and is set up once a year: its tasks, its teams, its robots; and its standings as a web
/// page. Owns the actions, and opens their dialogs.
class ClassActions : public QObject
{
    Q_OBJECT
public:
    ClassActions(Workspace &workspace, QWidget &window);
    void fillMenu(QMenu &menu);
    QAction *standings() const { return m_standings; }
    void showTasks();
    void showRobots();

Q_SIGNALS:
    void changed(); ///< the project
    void rosterRequested();
    void reprocessRequested(const QStringList &trials);

private:
    void showClasses();
    void showStandings();
    void updateActions();

    Workspace &m_workspace;
    QWidget &m_window;
    QAction *m_tasks, *m_classes, *m_robots, *m_standings;
    QPointer<ScoreboardDialog> m_scoreboard; ///< while it is open
};

struct BinContent;
struct ImportSettings;
class TrialBatch;

/// Actions on a class and on many trials at once: import a roster, show the changes, export, reanalyse. Owns
/// the actions, asks, and starts the jobs.
class HistoryActions : public QObject
{
    Q_OBJECT
public:
    HistoryActions(Workspace &workspace, QWidget &window);
    QAction *roster() const { return m_roster; }
    QAction *changes() const { return m_changes; }
    /// From a file that is asked for.
    void askRoster();
    /// Into a folder that is asked for.
    void exportTrials(const QStringList &trials);
    /// Their annotated videos, likewise; it asks how they are to look.
    void exportVideos(const QStringList &trials);
    /// With the registrations in force; the older analyses stay.
    void reprocessTrials(const QStringList &trials);
    /// New trials from videos, one after the other.
    void importTrials(const std::vector<ImportSettings> &trials);
    /// Removes trials for good, by a job.
    void emptyBin(const BinContent &content);
    /// Many trials are worked on: their pages need not follow each.
    bool isRunning() const;

Q_SIGNALS:
    /// The project is another one now.
    void changed(const odo::DoneWork &work);
    void failed(const odo::Error &error);

private:
    void showChanges();
    void updateActions();
    void tellEnd(int done, int all, const std::vector<odo::Error> &failures);

    Workspace &m_workspace;
    QWidget &m_window;
    TrialBatch *m_batch;
    QString m_folder;                         ///< that is written to; empty: none
    const MessageText *m_doneWords = nullptr; ///< "Exported trials: %1 of %2"
    std::vector<Message> m_remarks;           ///< on what was done
    QAction *m_roster, *m_changes;
};

class Job;
class Project;

/// The same work on many trials, one after the other, with progress and cancel where every job has them. If a
/// trial fails, the next one starts and the failure is reported at the end; a cancel keeps what is done. GUI
/// thread.
class TrialBatch : public QObject
{
    Q_OBJECT
public:
    /// What is done with one trial.
    struct Work
    {
        const MessageText *words = nullptr; ///< "Exporting %1 (%2 of %3)"
        std::function<std::shared_ptr<Job>(const std::string &trial)> make;
        std::function<Result<void>(Project &, Job &)> keep; ///< after each; may be empty
    };

    TrialBatch(Workspace &workspace, QObject *parent);
    bool isRunning() const { return !m_trials.isEmpty(); }
    /// Refused while another job runs.
    Result<void> start(const QStringList &trials, Work work);

Q_SIGNALS:
    /// done: of all; failures: empty when all went well.
    void ended(int done, int all, const std::vector<odo::Error> &failures);

private:
    Result<void> startNext();
    void end();
    void goOn(const Error *error);

    Workspace &m_workspace;
    Work m_work;
    QStringList m_trials; ///< empty: nothing runs
    std::shared_ptr<Job> m_job;
    qsizetype m_next = 0;
    int m_done = 0;
    std::vector<Error> m_failures;
};

} // namespace odo
