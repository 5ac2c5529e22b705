// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QFrame>
#include <QStatusBar>
#include <QWidget>

class QAction;
class QActionGroup;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace odo {

/// The dark bar on the left: one button a mode, icon and word, exclusive. Modes are numbered in the order of
/// adding, from 0, and reached by Ctrl+0, Ctrl+1, ...
class ModeBar : public QFrame
{
    Q_OBJECT
public:
    explicit ModeBar(QWidget *parent = nullptr);
    void addMode(const QString &icon, const QString &name);
    void setCurrent(int mode);
    /// False while there is nothing that the modes could show.
    void setModesEnabled(bool enabled);
    /// The actions, for a menu.
    QList<QAction *> modeActions() const;

Q_SIGNALS:
    /// A person chose it; setCurrent emits nothing.
    void chosen(int mode);

private:
    QActionGroup *m_group;
    QVBoxLayout *m_layout;
};

class JobIndicator;
class Workspace;

/// The foot of the window: whether all is saved and sent to the school's hub, by what the trial on screen was
/// analysed, the job that runs, and the units. GUI thread.
class StatusLine : public QStatusBar
{
    Q_OBJECT
public:
    explicit StatusLine(QWidget *parent = nullptr);
    JobIndicator &job() const { return *m_job; }
    /// trial: that on screen in Review; null: none.
    void showState(const Workspace &workspace, const TrialScenePtr &trial);
    /// Those in force.
    void showUnits();
    /// How the school's hub is; empty: the project has none.
    void showHub(const QString &words);

Q_SIGNALS:
    void hubRequested(); ///< more about it

private:
    QLabel *m_saved, *m_analysis, *m_units;
    QToolButton *m_hub;
    JobIndicator *m_job;
};

class ElidedLabel;

/// The job that runs, in the status bar: what it does, how far it is, and a button that stops it. Hidden when
/// none runs.
class JobIndicator : public QWidget
{
    Q_OBJECT
public:
    explicit JobIndicator(QWidget *parent = nullptr);
    void begin(const QString &text);
    void setProgress(double fraction, const QString &text);
    void end();
    QString text() const;

Q_SIGNALS:
    void cancelRequested();

private:
    ElidedLabel *m_text;
    QProgressBar *m_bar;
    QPushButton *m_cancel;
};

class Project;

/// "Year 9 robotics — Trial 1, Team Falcon — Odograph". project, trial: null where none is open or on screen.
QString windowTitleOf(const Project *project, const TrialScenePtr &trial);

} // namespace odo
