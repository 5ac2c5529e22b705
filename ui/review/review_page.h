// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/workflow/trials/trial_range.h"
#include "ui/models/trial_scene.h"

#include <QStringList>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QStackedWidget;

namespace odo {

class EmptyState;
struct GuidanceEdit;
class GuidanceTool;
class Project;
class ProjectReader;
class RangeActions;
class ReviewColumn;
class ReviewDesk;
class RobotPointing;
class SpikeActions;
class Timeline;
class TimelineBar;
class TrialChooser;

/// Review: one trial, all its views, its map and curves under one time line, its metrics at the right. What
/// it shows is read on a thread of its own; a trial that another one was chosen instead of never appears. The
/// project must outlive the page.
class ReviewPage : public QWidget
{
    Q_OBJECT
public:
    explicit ReviewPage(Project &project, QWidget *parent = nullptr);
    ~ReviewPage() override;

    /// Begins to show a trial by its name; what was shown stays until it is read, or when that fails.
    /// NotFound with the names there are.
    Result<void> showTrial(const QString &name);
    /// The trial on screen, or the one that is to be; empty: none.
    QString trial() const;
    /// Reads the project: the list of trials, and the one that is shown. Call it once the signals are
    /// connected, and after every change.
    void refresh();
    /// The trial on screen; null before it is read, or when the project has none.
    TrialScenePtr scene() const { return m_scene; }
    Timeline &timeline() const { return *m_timeline; }
    TrialChooser &chooser() const { return *m_chooser; }
    SpikeActions &spikes() const { return *m_spikes; }
    /// What can be done with spikes, and that choose several.
    QList<QAction *> spikeActions() const;
    RobotPointing &pointing() const { return *m_pointing; }
    GuidanceTool &guidance() const { return *m_guidance; }
    RangeActions &range() const { return *m_range; }
    ReviewDesk &desk() const { return *m_desk; }
    /// The trial is read, and every image that belongs to the present time is on screen, or is not available.
    bool isSettled() const;

Q_SIGNALS:
    void trialShown();
    void importRequested();
    void trackRequested(const QString &trial);
    void rangeRequested(const QString &trial, const odo::RangeChoice &range);
    void changed(); ///< the project
    void failed(const odo::Error &error);
    void settled();

protected:
    bool event(QEvent *event) override;

private:
    struct Request;
    struct Reading;
    static Result<Reading> readTrial(Project &project, const Request &request);
    void load();
    void take(Result<Reading> reading);
    void adopt(TrialScenePtr scene);
    void judgeVerdict();
    void connectPointing();
    void pointAt(std::size_t view, const QPointF &pixel, const QPoint &global);
    void guide(const QString &trial, const GuidanceEdit &edit);
    void showSettled();

    Project &m_project;
    ProjectReader *m_reader;
    TrialScenePtr m_scene;
    QString m_chosen; ///< to be shown instead; empty: none
    bool m_isListStale = false;
    Timeline *m_timeline;
    SpikeActions *m_spikes;
    RobotPointing *m_pointing;
    GuidanceTool *m_guidance;
    RangeActions *m_range;
    QStackedWidget *m_stack;
    QWidget *m_content; ///< of a trial; what is in it is made there
    TrialChooser *m_chooser;
    ReviewDesk *m_desk;
    TimelineBar *m_timelineBar;
    ReviewColumn *m_column;
    EmptyState *m_empty;
};

class Card;
class FactList;
class RangeCard;
class ResultPanel;
class SpikeList;

/// The right column of Review: which trial, its metrics, its spikes, its facts; or, before it was tracked,
/// the way to get them. While a range is selected, its metrics replace the facts.
class ReviewColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: goes to the top.
    ReviewColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    void setScene(const TrialScenePtr &scene);
    RangeCard &range() const { return *m_range; }

    SpikeList &spikes() const { return *m_spikes; }

Q_SIGNALS:
    void trackRequested();
    /// A doubtful verdict is to be accepted, or that to be withdrawn.
    void verdictRequested();

private:
    Card *makeTrackCard();

    QLabel *m_whyTrack;
    Card *m_track;
    ResultPanel *m_result;
    SpikeList *m_spikes;
    RangeCard *m_range;
    Card *m_trial;
    FactList *m_facts;
};

/// Which trial is shown: a list of all, and the ones before and after. Owns the two actions, for menus.
class TrialChooser : public QWidget
{
    Q_OBJECT
public:
    explicit TrialChooser(QWidget *parent = nullptr);
    /// Names in the order of the list, and the words that each is shown by ("Trial 3 · Falcon"); as many.
    void setTrials(const QStringList &names, const QStringList &words);
    /// Emits nothing.
    void setCurrent(const QString &name);
    QAction *previousAction() const { return m_previous; }
    QAction *nextAction() const { return m_next; }

Q_SIGNALS:
    void chosen(const QString &name);

private:
    void step(int by);
    void updateActions();

    QComboBox *m_trials;
    QAction *m_previous;
    QAction *m_next;
};

} // namespace odo
