// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QStatusBar>

class QLabel;

namespace odo {

class JobIndicator;
class Workspace;

/// The foot of the window: whether all is saved, by what the trial on screen was analysed, the job that runs,
/// and the units. GUI thread.
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

private:
    QLabel *m_saved, *m_analysis, *m_units;
    JobIndicator *m_job;
};

} // namespace odo
