// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/run_control.h"
#include "ui/models/live_cameras.h"
#include "ui/record/camera_choice.h"
#include "ui/record/running_cameras.h"

#include <QTimer>
#include <QWidget>
#include <optional>

class QAction;
class QStackedWidget;

namespace odo {

class EmptyState;
class LiveBoard;
class Project;
class RunCard;
class RunMeasuring;
class RunRecorder;
class RunResultCard;
class StartCard;
class TroubleBar;

/// Where cameras come from; tests bring their own. Both are called on threads of their own.
struct CameraAccess
{
    RunningCameras::Open open = openCamera;
    LiveCameras::List list = listCameras;
};

/// Record: the cameras live, where the robots are, who is up, one big button, and what the run gave. The
/// cameras run while the page is shown or something is recorded. Uses the project on its own thread. The
/// project must outlive the page; a recording that goes on is completed by the destructor.
class RecordPage : public QWidget
{
    Q_OBJECT
public:
    RecordPage(Project &project, bool readOnly, CameraAccess access = {}, QWidget *parent = nullptr);
    ~RecordPage() override;

    /// Reads teams, tasks, robots and registrations anew; what is being recorded goes on.
    void refresh();
    bool isRecording() const;
    /// For menus: record or stop, cameras, set-up doctor.
    QList<QAction *> actions() const { return m_actions; }

Q_SIGNALS:
    void changed(const QString &words); ///< the project has a new trial, or new figures of one
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
    void startCameras();
    void showCameras();
    void useChoice(const std::vector<ChosenCamera> &chosen);
    void chooseCameras();
    void examine();
    void showFloor();
    void followRobots();
    void takeMoment(const LiveMoment &moment);
    void press();
    void obey(const std::optional<RunOrder> &order);
    void begin(Nanoseconds from);
    void end();
    void takeRecorded(const QString &trial, const QStringList &warnings);
    void tick();
    void showHealth();
    void showStart();
    void showTrouble(const CaptureHealth &health);

    Project &m_project;
    const bool m_readOnly;
    LiveCameras m_connected;
    RunningCameras m_cameras;
    RunControl m_control;
    RunRecorder *m_recorder;
    RunMeasuring *m_measuring;
    std::vector<ChosenCamera> m_chosen;
    std::optional<Error> m_cameraFailure;
    QString m_room;
    std::vector<std::string> m_seen; ///< robots that were seen in the run
    CaptureHealth m_before;          ///< losses are counted since then: of the run, or of the cameras
    bool m_isLineUpRead = false;
    int m_ticks = 0;
    QTimer m_timer, m_retry;

    QList<QAction *> m_actions;
    TroubleBar *m_troubleBar;
    LiveBoard *m_board;
    StartCard *m_start;
    RunCard *m_run;
    RunResultCard *m_result;
    EmptyState *m_empty;
    QStackedWidget *m_stack;
};

} // namespace odo
