// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "core/capture/capture_session.h"
#include "core/capture/setup_checks.h"
#include "core/workflow/record/live_tracking.h"
#include "ui/models/background_task.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/fact_list.h"

#include <QDialog>
#include <QFrame>
#include <QList>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace odo {

class ChosenCameras;
class LiveBoard;
class Project;
class WarningBar;

/// Checks the cameras and the disk, shows their health on the board and problems in the bar, and knows
/// whether a run can be recorded. All must outlive it. GUI thread.
class HealthWatch
{
public:
    HealthWatch(const Project &project, bool readOnly, ChosenCameras &cameras, LiveBoard &board,
                WarningBar &warning);

    /// Once more; nothing while no camera runs.
    void poll();
    /// Before anything is known of the cameras.
    void watchNone() { showWarning({}); }
    /// Losses are counted from now on, as a run begins: the cameras run.
    void countFromNow();
    /// Losses are counted from their opening, as cameras are opened.
    void countFromOpening() { m_before = {}; }
    /// What keeps a run from being recorded, in words; empty: nothing.
    QString blocked() const;
    /// The remaining recording time, in words.
    const QString &remainingTime() const { return m_remainingTime; }
    /// By the last look nothing more can be recorded: the disk has ended, or every camera.
    bool hasEnded() const { return m_hasEnded; }

private:
    void showWarning(const CaptureHealth &health);

    const Project &m_project;
    const bool m_readOnly;
    ChosenCameras &m_cameras;
    LiveBoard &m_board;
    WarningBar &m_warning;
    QString m_remainingTime;
    CaptureHealth m_before; ///< losses are counted since then
    bool m_anyDelivers = false, m_hasEnded = false;
};

/// A sentence across the page while a problem lasts, with a button that leads to its fix. Hidden without
/// words.
class WarningBar : public QFrame
{
    Q_OBJECT
public:
    explicit WarningBar(QWidget *parent = nullptr);
    /// button: its words; empty: none.
    void setWords(const QString &words, const QString &button = {});
    QString words() const;

Q_SIGNALS:
    void warned(const QString &words); ///< it came up with these, without a button
    void clicked();

private:
    QLabel *m_words;
    QPushButton *m_button;
};

class FactList;
class RunningCameras;

/// The set-up doctor: what makes cameras lose frames or measure wrongly on this machine, each with advice.
class DoctorDialog : public QDialog
{
    Q_OBJECT
public:
    /// cameras: those that run, if any do; must outlive it.
    explicit DoctorDialog(const RunningCameras &cameras, QWidget *parent = nullptr);

private:
    void examine();
    void show(const std::vector<SetupFinding> &findings);

    const RunningCameras &m_cameras;
    FactList *m_facts;
    QLabel *m_words;
    QPushButton *m_again = nullptr;
    BackgroundTask m_task;
};

/// Where a robot is, as a line says it.
struct SeenRobot
{
    std::string name;
    std::optional<LivePosition> now; ///< empty: not seen just now
};

/// How cameras, step, map and disk do, and where the robots are, a line each. Losses are those since
/// `before`.
QList<Fact> healthFacts(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                        const LiveStatistics &live, const std::vector<SeenRobot> &robots = {},
                        const CaptureHealth &before = {});

/// What a person must know now, in a sentence; the worst first; empty: all is well.
QString warningWords(const CaptureHealth &health, const std::vector<WantedCamera> &cameras);
/// That a camera cannot locate robots; empty if all can.
QString unregisteredWords(const std::vector<WantedCamera> &cameras);

} // namespace odo
