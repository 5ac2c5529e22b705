// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/camera_lists.h"
#include "ui/models/trial_scene.h"
#include "ui/record/internal/camera_choice.h"
#include "ui/record/internal/running_cameras.h"

namespace odo {

class Project;

/// Where cameras come from; tests bring their own. Both are called on threads of their own.
struct CameraAccess
{
    RunningCameras::Open open = openCamera;
    LiveCameras::List list = listCameras;
};

/// Which connected devices are the cameras of a project, and that these run while they are wanted: the ones
/// that were chosen, or what is proposed until something is. Uses the project on its own thread; it must
/// outlive this.
class ChosenCameras : public QObject
{
    Q_OBJECT
public:
    ChosenCameras(Project &project, CameraAccess access, QObject *parent = nullptr);

    RunningCameras &running() { return m_running; }
    const std::vector<WantedCamera> &cameras() const { return m_running.cameras(); }
    const std::shared_ptr<CaptureSession> &session() const { return m_running.session(); }
    LiveTracker *tracker() const { return m_running.tracker(); }
    /// They are being looked for, or opened.
    bool isPreparing() const { return m_running.isOpening() || m_connected.isLooking(); }

    /// They are to run from now on: looks for what is connected, unless they do.
    void want();
    /// Looks again for what is connected.
    void look() { m_connected.look(); }
    /// Others may have them.
    void stop();
    /// Opens them anew: a registration may be another one.
    void restart();
    /// Asks which device is which camera.
    void choose(QWidget *parent);

Q_SIGNALS:
    /// They are being opened; RunningCameras tells what becomes of it.
    void starting();
    void noneConnected();
    void failed(const odo::Error &error);

private:
    void keepInProject();
    std::vector<ChosenCamera> proposed(const std::vector<CameraRecord> &cameras) const;

    Project &m_project;
    LiveCameras m_connected;
    RunningCameras m_running;
    std::vector<ChosenCamera> m_chosen;
    bool m_wanted = false;
};

/// The cameras that are used, each with its registration in force. Project's thread.
Result<std::vector<WantedCamera>> wantedCameras(Project &project, const std::vector<ChosenCamera> &chosen);

/// What is known of the floor before anything is recorded: the views, the layout of the first one that is
/// registered, and the task; no robots. Project's thread.
Result<TrialScenePtr> liveScene(Project &project, const std::vector<WantedCamera> &cameras,
                                const std::optional<Task> &task);

} // namespace odo
