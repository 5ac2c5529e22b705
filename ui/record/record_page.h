// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/record/live_tracking.h"
#include "core/workflow/record/run_control.h"
#include "ui/record/internal/running_cameras.h"

#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

class QAction;
class QStackedWidget;

namespace odo {

/// Whether, and to where, live positions are sent on the network, as the settings have it. GUI thread.
struct SentPositions
{
    bool isOn = false;
    BroadcastTarget target;
    bool operator==(const SentPositions &) const = default;

    static SentPositions chosen();
    void choose() const;
    /// nullopt: they are not sent.
    std::optional<BroadcastTarget> wanted() const { return isOn ? std::optional(target) : std::nullopt; }
};

/// The names of this machine's network interfaces, the loopback first.
QStringList networkInterfaces();

class EmptyState;
class HealthWatch;
class LiveBoard;
class PresentSource;
class Project;
class RunCard;
class RunPresentation;
class RunRecorder;
class RunResultCard;
class RunResults;
class StartCard;
class WarningBar;

/// Record: the cameras live, where the robots are, who is up, one big button, and what the run gave. The
/// cameras run while the page is shown or something is recorded. Uses the project on its own thread. The
/// project must outlive the page; a recording that goes on is completed by the destructor.
class RecordPage : public QWidget
{
    Q_OBJECT
public:
    RecordPage(Project &project, bool readOnly, CameraAccess access = {}, QWidget *parent = nullptr);
    ~RecordPage() override;

    /// Rereads teams, tasks, robots and registrations; what is being recorded goes on.
    void refresh();
    bool isRecording() const;
    /// Ends what is recorded, or about to be, and waits until the trial is complete in the project.
    void finishRecording();
    /// The target of live positions may have changed; during a run it stays as it was.
    void followNetwork();
    /// For menus: record or stop, cameras, set-up doctor.
    QList<QAction *> actions() const { return m_actions; }
    /// The run that is going on, or has just ended, for a presentation. Goes with the page.
    PresentSource &presentation() const;

Q_SIGNALS:
    /// The project has a new trial, or new metrics of one. The words contain the warnings.
    void changed(const QString &words, const std::vector<odo::Message> &warnings);
    void warned(const QString &words); ///< what the page says of cameras and disk just now
    void failed(const odo::Error &error);
    void trialChosen(const QString &trial);
    void testbedRequested();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QWidget *makeColumn();
    void makeActions();
    void connectAll();
    void connectCameras();
    void showCameras();
    void chooseCameras();
    void examine();
    void showFloor();
    void followRobots();
    void takeMoment(const LiveMoment &moment);
    void prepare();
    void press();
    void obey(const std::optional<RunOrder> &order);
    void begin(const RunOrder &order);
    void keepBefore();
    void end();
    void takeRecorded(const QString &trial, const std::vector<Message> &warnings);
    void takeGivenUp(const QString &trial, const Error &error);
    void tick();
    void checkHealth();
    void showStart();

    Project &m_project;
    ChosenCameras m_cameras;
    RunControl m_control;
    RunRecorder *m_recorder;
    SentPositions m_sent;           ///< as was chosen when robots began to be followed
    Nanoseconds m_followedSince{0}; ///< the robots that are chosen now
    bool m_isLineUpRead = false, m_isByPseudonym = false;
    int m_ticks = 0;
    QTimer m_timer;

    QList<QAction *> m_actions;
    WarningBar *m_warningBar;
    LiveBoard *m_board;
    std::unique_ptr<HealthWatch> m_health;
    StartCard *m_start;
    RunCard *m_run;
    RunResultCard *m_result;
    RunResults *m_results;
    RunPresentation *m_presentation;
    EmptyState *m_empty;
    QStackedWidget *m_stack;
};

} // namespace odo
