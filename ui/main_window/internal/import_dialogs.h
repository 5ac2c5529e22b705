// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/import/import_trial_job.h"
#include "ui/models/background_task.h"
#include "ui/models/number_text.h"

#include <QComboBox>
#include <QDialog>
#include <QWidget>
#include <filesystem>
#include <string>
#include <vector>

class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace odo {

class BadgeLabel;
class CheckList;
class PathField;
class ViewSteps;

/// "Trial 3": the first one from the number of trials on that is not taken.
QString freeTrialName(const QStringList &taken);

/// A team that is there, or the name of a new one; empty: none.
class TeamBox : public QComboBox
{
    Q_OBJECT
public:
    /// shown: what each is shown as; empty: by their names.
    TeamBox(const QStringList &teams, const QStringList &shown, QWidget *parent = nullptr);
    std::string team() const;
};

/// Asks what belongs to a trial: its name, team, task and robots, the video of each camera, and how to
/// synchronise each with the first. Of a video that says nothing of its frames' times it asks the rate.
class ImportTrialDialog : public QDialog
{
    Q_OBJECT
public:
    struct OfferedCamera
    {
        QString name;
        Badge badge; ///< how well it is registered
    };
    struct Offer
    {
        QString name; ///< a free one
        QStringList teams, robots;
        std::vector<OfferedCamera> cameras;
        QStringList teamsShown = {};         ///< what each team is shown as; empty: by their names
        QList<QStringList> teamsRobots = {}; ///< that belong to each team, ticked when it is chosen
        QStringList tasks = {};
    };
    explicit ImportTrialDialog(const Offer &offer, QWidget *parent = nullptr);
    ImportSettings settings() const;
    /// One more row; file may be empty.
    void addVideo(const QString &camera, const QString &file);
    /// A row for each; files that look like the chapters of one recording (chapterGroups) share theirs.
    void addVideos(const QStringList &files);

private:
    struct VideoRow
    {
        QComboBox *camera;
        BadgeLabel *badge;
        PathField *file;
        std::filesystem::path lookedInto = {}; ///< for its times
        bool hasNoTimes = false;

        bool lacksTimes() const;
    };
    QWidget *makeVideos();
    QWidget *makeRate();
    void orderTabs();
    void proposeRobots(int team);
    void updateButtons();
    void findMissingTimes();
    void requireRate();

    Badge badgeOf(const QString &camera) const;

    std::vector<OfferedCamera> m_cameras;
    QList<QStringList> m_teamsRobots;
    QLineEdit *m_name;
    TeamBox *m_team;
    QComboBox *m_task;
    CheckList *m_robots;
    QGridLayout *m_videoGrid;
    std::vector<VideoRow> m_videos;
    QPushButton *m_addView;
    ViewSteps *m_steps;
    QCheckBox *m_givenRate;
    QDoubleSpinBox *m_rate;
    QLabel *m_rateReason; ///< why it must be given; hidden where it need not
    QDialogButtonBox *m_buttons;
    BackgroundTask m_look; ///< into a file; last, so that it ends first
};

class ElidedLabel;

/// One row for each view but the first: how to synchronise it with the first, and the time offset if set by
/// hand.
class ViewSteps : public QWidget
{
    Q_OBJECT
public:
    explicit ViewSteps(QWidget *parent = nullptr);
    /// One view more; nothing is asked of the first one.
    void addView();
    /// The views' cameras as they are called now, in order.
    void setCameras(const QStringList &cameras);
    /// Offers, too, to leave each view as it is.
    void offerToKeep();
    /// Chooses how to synchronise a view, counted from 0.
    void setStep(std::size_t view, const ViewStep &step);
    /// What was chosen for a view, counted from 0; that of the first one is of no use.
    ViewStep step(std::size_t view) const;
    /// All that takes the focus, in order.
    QList<QWidget *> fields() const;

Q_SIGNALS:
    void changed(std::size_t view); ///< what is chosen for it

private:
    struct Row
    {
        ElidedLabel *camera;
        QComboBox *how;
        QDoubleSpinBox *later;
    };
    QGridLayout *m_grid;
    std::size_t m_views = 0;
    std::vector<Row> m_rows;
};

} // namespace odo
