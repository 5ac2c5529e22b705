// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/models/comparison_scene.h"

#include <QWidget>
#include <optional>

class QStackedWidget;

namespace odo {

class CompareColumn;
class CompareDesk;
class Project;
class ProjectReader;
class RunChooser;
class Timeline;
class TimelineBar;

/// Compare: two or more runs at the same points of one path, their videos synchronised, each with the ghost
/// of the other. What it shows is read on a thread of its own. The gates of the sectors belong to the
/// comparison on screen: a task is not changed once it is stored, so that dragging them changes nothing that
/// was measured. The project must outlive the page.
class ComparePage : public QWidget
{
    Q_OBJECT
public:
    explicit ComparePage(Project &project, QWidget *parent = nullptr);
    ~ComparePage() override;

    /// Compares these trials; for a single one another that was tracked is found, of the same task if there
    /// is one.
    void showTrials(const QStringList &trials);
    /// As showTrials, unless a comparison was chosen already.
    void suggestTrial(const QString &trial);
    /// Reads the project: the list of runs, and what is on screen. Call it once the signals are connected,
    /// and after every change.
    void refresh();
    /// What is on screen; null where nothing can be compared.
    ComparisonScenePtr scene() const { return m_scene; }
    Timeline &timeline() const { return *m_timeline; }
    RunChooser &chooser() const { return *m_chooser; }
    CompareDesk &desk() const { return *m_desk; }
    /// All is loaded, and every image that belongs to the present time is on screen, or is not available.
    bool isSettled() const;

Q_SIGNALS:
    void importRequested();
    void failed(const odo::Error &error);
    void settled();

protected:
    bool event(QEvent *event) override;

private:
    struct Reading;
    struct Request;
    static Result<Reading> readRuns(Project &project, Request request);
    void load();
    void take(Result<Reading> reading);
    void adopt(ComparisonScenePtr scene);
    void showNone(const QString &headline, const QString &why, bool mayImport);
    void showSettled();

    ProjectReader *m_reader;
    ComparisonScenePtr m_scene;
    std::vector<CompareSettings::Run> m_runs; ///< that are compared, or are to be
    std::optional<double> m_originM;          ///< by distance: the path length that a position counts from
    std::vector<double> m_handTimesS;         ///< the moments that a shift by hand is counted from
    bool m_isListStale = false, m_wantsPartner = false;
    Timeline *m_timeline;
    RunChooser *m_chooser;
    CompareDesk *m_desk;
    TimelineBar *m_timelineBar;
    CompareColumn *m_column;
    QStackedWidget *m_stack;
};

} // namespace odo
