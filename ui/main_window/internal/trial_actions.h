// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/import/clip_groups.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trials/trial_range.h"
#include "ui/main_window/internal/done_work.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/models/background_task.h"

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace odo {

class Workspace;

/// What can be done with trials: import, edit, track, export, and add the robots they need. Owns the actions,
/// asks, and starts the jobs.
class TrialActions : public QObject
{
    Q_OBJECT
public:
    TrialActions(Workspace &workspace, QWidget &window);
    void fillMenu(QMenu &menu);
    /// The trial that Track, Synchronise, Export and Export video mean; empty: none.
    void setCurrentTrial(const QString &name);
    /// Of the time line; what of the trial can be exported alone.
    void setSelection(const std::optional<TimeSpan> &selection) { m_selection = selection; }
    /// The trials that Edit means.
    void setChosenTrials(const QStringList &names);
    /// For lists of trials, too.
    QAction *editAction() const { return m_edit; }
    /// videos: dropped ones; those of several runs are offered as a lesson.
    void askImport(const QStringList &videos = {});
    /// Of tracks that another program measured.
    void askImportTracks(const QStringList &files = {});
    void askTrack(const QString &trial);
    /// How its views are to be synchronised.
    void askSynchronise(const QString &trial);
    /// Edits them, as they are stored now.
    void askEdit(const QStringList &trials);
    /// Asks for a new robot; false: none was added.
    bool askRobot();
    /// Stores a manual override of a sample and reanalyses the trial.
    void manualOverride(const OverrideRequest &word);
    void setRange(const QString &trial, const RangeChoice &range);
    /// Stores where a person says that a robot is, and tracks the trial again.
    void pointOut(const QString &trial, const RobotPointer &pointer);
    /// Stores points by hand and what is not visible, and reanalyses the observations corrected by them.
    void correctByHand(const QString &trial, const GuidanceEdit &edit);

Q_SIGNALS:
    void failed(const odo::Error &error);
    void done(const odo::DoneWork &work);
    void robotAdded();
    void editRequested(const QStringList &trials); ///< to be edited, once all is stored
    void trialsEdited();
    void trialImported(const QString &name);
    void lessonChosen(const std::vector<odo::ImportSettings> &trials); ///< to be imported
    void trialTracked(const QString &name);

private:
    void askTrial(const QStringList &videos);
    void askLesson(std::vector<ClipGroup> groups);
    ImportTrialDialog::Offer offer() const;
    void askExport();
    void askVideo();
    void updateActions();
    void showFailure(const Result<void> &result);
    bool mayChange(const Message &what);
    void startTracking(const QString &trial, TrackSettings settings);
    /// Of either way of importing.
    template <class ImportJob>
    void startImport(const std::shared_ptr<ImportJob> &job, const std::string &trial);

    Workspace &m_workspace;
    QWidget &m_window;
    QString m_trial;
    QStringList m_chosen;
    std::optional<TimeSpan> m_selection;
    BackgroundTask m_clipSearch; ///< which of the dropped clips belong together
    QAction *m_import, *m_importTracks, *m_edit, *m_track, *m_synchronise, *m_export, *m_video, *m_addRobot;
};

} // namespace odo
