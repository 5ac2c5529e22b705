// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/capture/capture_session.h"
#include "core/workflow/record/floor_motion.h"
#include "core/workflow/record/live_tracking.h"
#include "ui/models/camera_lists.h"
#include "ui/models/trial_scene.h"
#include "ui/record/internal/camera_choice.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QThread>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace odo {

/// Which of a view's frames the screen gets: of a camera of up to 40 a second all, of a faster one every
/// second, third, ... so that the steps between them stay even. (Each is recorded and tracked.) Not
/// thread-safe.
class ScreenPace
{
public:
    /// taken: by this machine's steady clock; increasing.
    bool takes(Nanoseconds taken)
    {
        if (m_last && taken - *m_last < shortestStep)
            return false;
        m_last = taken;
        return true;
    }

private:
    static constexpr Nanoseconds shortestStep = std::chrono::milliseconds(24); // every second at 60 a second
    std::optional<Nanoseconds> m_last;
};

/// A camera that is to run, by the name it has in the project.
struct WantedCamera
{
    std::string name, uri;
    std::optional<FloorView> floorView; ///< empty: not registered, or for frames of another size
    QSize registeredPx = {};            ///< the size of its frames when it was registered; empty: it is not
    std::optional<FloorArea> area = {}; ///< of the floor, where motion counts
};

/// A view's frame at the size it is shown in, with what was seen in it.
struct LiveFrame
{
    std::size_t view = 0;
    QImage image;
    QSize takenPx;                         ///< of the frame as taken
    std::vector<Observation> observations; ///< of each robot
};

/// Cameras that run for the screen: opened, watched, tracked. Whatever may take long (opening, ending,
/// scaling frames) is done on threads of its own; the screen gets as many frames as it takes. GUI thread.
/// The destructor ends all and waits.
class RunningCameras : public QObject
{
    Q_OBJECT
public:
    using Open = std::function<Result<std::unique_ptr<CameraSource>>(const std::string &)>;
    static constexpr std::size_t mostViews = 8;

    /// open: called on a thread of its own.
    explicit RunningCameras(Open open = openCamera, QObject *parent = nullptr);
    ~RunningCameras() override;

    /// Ends those that run and opens these, one after the other; started() follows. One that cannot be opened
    /// runs all the same, without frames, until it can.
    void start(std::vector<WantedCamera> cameras);
    /// Follows these robots from now on, and when others are started; simulated cameras show them. The Error
    /// is ColourTracker's; then none is followed. Or it is LiveBroadcast's; then they are followed, but not
    /// sent.
    Result<void> follow(std::vector<RobotRecord> robots);
    /// Where the positions of the robots followed next are sent; nullopt: nowhere.
    void setTarget(std::optional<BroadcastTarget> target) { m_target = std::move(target); }
    /// How sending goes; nullopt: nothing is sent.
    std::optional<LiveBroadcast::BroadcastStatistics> sentStatistics() const
    {
        return m_broadcast ? std::optional(m_broadcast->statistics()) : std::nullopt;
    }
    /// Whether motion on the floor is looked for from now on: floorSeen().
    void watchFloor(bool on) { m_watchesFloor = on; }
    void stop();

    bool isOpening() const { return m_opening; }
    const std::vector<WantedCamera> &cameras() const { return m_cameras; }
    /// Null unless running. It may be kept beyond stop(), to bring a recording to its end.
    const std::shared_ptr<CaptureSession> &session() const { return m_session; }
    LiveTracker *tracker() const { return m_tracker.get(); }
    /// How large a view is shown, in device pixels.
    void setShownSize(std::size_t view, const QSize &pixels);

Q_SIGNALS:
    void started();
    void failed(const odo::Error &error); ///< of follow()
    void frameReady(const odo::LiveFrame &live);
    void moved(const odo::LiveMoment &moment);
    void floorSeen(const odo::MotionSight &sight);

private:
    using Sources = std::vector<std::unique_ptr<CameraSource>>;
    Sources openAll(const std::vector<WantedCamera> &cameras) const;
    void adopt(quint64 generation, const std::shared_ptr<Sources> &opened);
    void onWorker(std::function<void()> work);
    void takeSight(const LiveSight &sight, quint64 generation);
    void showFrames();
    void deliver(const LiveFrame &live);

    const Open m_open;
    QThread m_thread;
    QObject m_worker; ///< lives on m_thread
    std::vector<WantedCamera> m_cameras;
    std::vector<RobotRecord> m_robots;
    std::shared_ptr<CaptureSession> m_session;
    std::optional<BroadcastTarget> m_target;
    std::unique_ptr<LiveBroadcast> m_broadcast; ///< outlives the tracker, which gives it its moments
    std::unique_ptr<LiveTracker> m_tracker;
    quint64 m_generation = 0; ///< answers to an older one are not wanted
    bool m_opening = false;
    std::atomic<bool> m_watchesFloor = false;
    std::vector<std::optional<FloorMotion>> m_floors; ///< of each view; of the tracker's threads

    BoundedQueue<LiveSight> m_toShow{mostViews};
    std::array<ScreenPace, mostViews> m_pace; ///< of the tracker's threads, one at a time
    std::array<std::atomic<bool>, mostViews>
        m_isPending{}; ///< a frame of the view that the screen has not got yet
    std::array<std::atomic<qint64>, mostViews> m_shownSize{}; ///< width << 32 | height
    std::thread m_painter;
};

class Project;

/// Where cameras come from; tests bring their own. Both are called on threads of their own.
struct CameraAccess
{
    RunningCameras::Open open = openCamera;
    LiveCameras::List list = listCameras;
};

/// Assigns connected devices to the cameras of a project, and runs these while they are needed: the chosen
/// ones, or those proposed until a choice is made. Uses the project on its own thread; it must outlive this.
class ChosenCameras : public QObject
{
    Q_OBJECT
public:
    ChosenCameras(Project &project, CameraAccess access, QObject *parent = nullptr);

    RunningCameras &running() { return m_running; }
    const std::vector<WantedCamera> &cameras() const { return m_running.cameras(); }
    const std::shared_ptr<CaptureSession> &session() const { return m_running.session(); }
    LiveTracker *tracker() const { return m_running.tracker(); }
    /// A search for them, or their opening, goes on.
    bool isPreparing() const { return m_running.isOpening() || m_connected.isSearching(); }

    /// Lets them run from now on: searches for connected ones unless they run already.
    void want();
    /// Searches again for connected cameras.
    void poll() { m_connected.poll(); }
    /// Others may have them.
    void stop();
    /// Reopens them: a registration may have changed.
    void restart();
    /// Asks which device is which camera.
    void choose(QWidget *parent);

Q_SIGNALS:
    /// They are being opened; RunningCameras reports the outcome.
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
