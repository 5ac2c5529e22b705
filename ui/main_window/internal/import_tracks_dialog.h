// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/import/import_tracks_job.h"
#include "ui/main_window/internal/import_dialogs.h"

#include <QDialog>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QGridLayout;
class QLineEdit;
class QPushButton;

namespace odo {

class PathField;
class TrackPreview;
class TrackReadingForm;

/// Asks what belongs to a trial whose robots another program has tracked: its name, team and task, the file
/// of each robot, and what the files do not say; shows how they are read before they are.
class ImportTracksDialog : public QDialog
{
    Q_OBJECT
public:
    struct Offer
    {
        QString name; ///< a free one
        QStringList teams, robots, tasks;
        QStringList teamsShown = {}; ///< what each team is shown as; empty: by their names
    };
    explicit ImportTracksDialog(const Offer &offer, QWidget *parent = nullptr);
    ImportTracksSettings settings() const;
    /// A file for the first row that waits for one, or a row of its own.
    void addTrack(const QString &file);
    /// Whether a file can be one of tracks, by its name.
    static bool isTrackFile(const QString &file);

private:
    struct TrackRow
    {
        QComboBox *robot;
        PathField *file;
    };
    QWidget *makeTracks();
    void addRow();
    void orderTabs();
    void updateButtons();
    void updatePreview();

    QStringList m_knownRobots;
    QLineEdit *m_name;
    TeamBox *m_team;
    QComboBox *m_task;
    QGridLayout *m_grid;
    std::vector<TrackRow> m_tracks;
    QPushButton *m_addRobot;
    TrackReadingForm *m_reading;
    TrackPreview *m_preview;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
