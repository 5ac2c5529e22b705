// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/models/trial_scene.h"

#include <QWidget>

class QStackedWidget;

namespace odo {

class EmptyState;
class Project;
class ReviewColumn;
class ReviewDesk;
class Timeline;
class TimelineBar;
class TrialChooser;

/// Review: one trial, all its views, its map and curves under one time line, its figures at the right.
/// Uses the project on its own thread. The project must outlive the page.
class ReviewPage : public QWidget
{
    Q_OBJECT
public:
    explicit ReviewPage(Project &project, QWidget *parent = nullptr);
    ~ReviewPage() override;

    /// Shows a trial by its name; what was shown stays when it fails.
    Result<void> showTrial(const QString &name);
    /// Reads the project: the list of trials, and the one that is shown. Call it once the signals are
    /// connected, and after every change.
    void refresh();
    /// The trial on screen; null when the project has none.
    TrialScenePtr scene() const { return m_scene; }
    Timeline &timeline() const { return *m_timeline; }
    TrialChooser &chooser() const { return *m_chooser; }
    ReviewDesk &desk() const { return *m_desk; }
    /// Every picture that belongs to the present time is on screen, or cannot be had.
    bool isSettled() const;

Q_SIGNALS:
    void trialShown();
    void importRequested();
    void trackRequested(const QString &trial);
    void failed(const odo::Error &error);
    void settled();

protected:
    bool event(QEvent *event) override;

private:
    void adopt(TrialScenePtr scene);
    void showSettled();

    Project &m_project;
    TrialScenePtr m_scene;
    Timeline *m_timeline;
    TrialChooser *m_chooser;
    ReviewDesk *m_desk;
    TimelineBar *m_timelineBar;
    ReviewColumn *m_column;
    EmptyState *m_empty;
    QStackedWidget *m_stack;
};

} // namespace odo
