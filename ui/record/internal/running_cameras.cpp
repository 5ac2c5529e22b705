// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/running_cameras.h"

#include "core/base/shortage.h"
#include "core/capture/camera_source.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/workflow/job.h"
#include "core/workflow/record/record_trial.h"
#include "core/workflow/trial_sources.h"
#include "ui/record/internal/camera_choice.h"
#include "ui/views/image/image_overlay.h"

#include <algorithm>

namespace odo {

RunningCameras::RunningCameras(Open open, QObject *parent) : QObject(parent), m_open(std::move(open))
{
    if (auto painter = startThread({}, [this] { showFrames(); })) // else start() reports it
        m_painter = std::move(*painter);
    m_worker.moveToThread(&m_thread);
    m_thread.start();
}

RunningCameras::~RunningCameras()
{
    stop();
    m_toShow.close();
    if (m_painter.joinable())
        m_painter.join();
    m_thread.quit(); // what was asked for before is done first
    m_thread.wait();
}

void RunningCameras::onWorker(std::function<void()> work)
{
    callLater(&m_worker, std::move(work));
}

void RunningCameras::start(std::vector<WantedCamera> cameras)
{
    stop();
    if (!m_painter.joinable() || !m_thread.isRunning()) {
        callLater(this, [this] { Q_EMIT failed(noThread(ODO_TEXT("ui.cameras", "the cameras"))); });
        return;
    }
    m_cameras = std::move(cameras);
    m_cameras.resize(std::min(m_cameras.size(), mostViews));
    m_opening = true;
    onWorker([this, wanted = m_cameras, generation = m_generation] {
        const auto opened = std::make_shared<Sources>(openAll(wanted));
        callLater(this, [this, generation, opened] { adopt(generation, opened); });
    });
}

RunningCameras::Sources RunningCameras::openAll(const std::vector<WantedCamera> &cameras) const
{
    Sources sources;
    for (const WantedCamera &camera : cameras) {
        auto source = m_open(camera.uri);
        if (source)
            sources.push_back(std::move(*source));
        else
            sources.push_back(awaitCamera(camera.uri, source.error(),
                                          [open = m_open, uri = camera.uri] { return open(uri); }));
    }
    return sources;
}

void RunningCameras::adopt(quint64 generation, const std::shared_ptr<Sources> &opened)
{
    if (generation != m_generation) {
        onWorker([opened] { opened->clear(); }); // closing a camera may take its time
        return;
    }
    m_opening = false;
    for (std::size_t v = 0; v < m_cameras.size(); ++v) {
        const CameraDescription &is = (*opened)[v]->description();
        if (!m_cameras[v].floorView)
            continue;
        const Intrinsics &intrinsics = m_cameras[v].floorView->camera().intrinsics();
        if (is.widthPx > 0 && (is.widthPx != intrinsics.widthPx || is.heightPx != intrinsics.heightPx))
            m_cameras[v].floorView.reset();
    }
    m_session = std::make_shared<CaptureSession>(std::move(*opened));
    const Result<void> following = follow(std::move(m_robots));
    Q_EMIT started();
    if (!following)
        Q_EMIT failed(following.error());
}

Result<void> RunningCameras::follow(std::vector<RobotRecord> robots)
{
    m_robots = std::move(robots);
    if (!m_session)
        return {};
    ++m_generation; // what is on its way was seen of other robots
    m_session->showRobots(appearancesOf(m_robots));
    m_tracker.reset();
    m_broadcast.reset();
    Result<void> sending;
    if (m_target && !m_robots.empty()) {
        auto broadcast = LiveBroadcast::create(*m_target, m_robots);
        if (broadcast)
            m_broadcast = std::move(*broadcast);
        else
            sending = tl::unexpected(broadcast.error());
    }
    std::vector<LiveView> views;
    m_floors.clear(); // no tracker runs
    for (const WantedCamera &camera : m_cameras) {
        views.push_back({camera.name, camera.floorView});
        m_floors.emplace_back();
        if (camera.floorView && camera.area)
            m_floors.back().emplace(*camera.floorView, *camera.area);
    }
    const auto subscribe = [this] {
        std::vector<LiveTracker::Feed> feeds;
        for (std::size_t v = 0; v < m_cameras.size(); ++v)
            feeds.push_back(m_session->subscribeFrames(v, 2));
        return feeds;
    };
    const LiveTracker::Listener listener{
        [this, generation = m_generation](const LiveSight &sight) { takeSight(sight, generation); },
        [this, generation = m_generation, broadcast = m_broadcast.get()](const LiveMoment &moment) {
            if (broadcast)
                broadcast->take(moment);
            callLater(this, [this, generation, moment] {
                if (generation == m_generation)
                    Q_EMIT moved(moment);
            });
        }};
    auto tracker = LiveTracker::create(views, m_robots, subscribe(), listener);
    if (tracker) {
        m_tracker = std::move(*tracker);
        return sending;
    }
    if (auto imageAreas =
            LiveTracker::create(views, {}, subscribe(), listener)) // they are shown all the same
        m_tracker = std::move(*imageAreas);
    return tl::unexpected(tracker.error());
}

/// The tracker's threads, one at a time.
void RunningCameras::takeSight(const LiveSight &sight, quint64 generation)
{
    const TimedFrame &timed = sight.timedFrame;
    if (m_pace[sight.view].takes(timed.taken) && !m_isPending[sight.view].exchange(true))
        m_toShow.pushOrDrop(sight);
    auto &floor = m_floors[sight.view];
    if (!floor || !m_watchesFloor)
        return;
    const auto seen = floor->add(timed.captured.frame, timed.taken);
    if (!seen)
        return;
    callLater(this, [this, generation, seen = *seen] {
        if (generation == m_generation)
            Q_EMIT floorSeen(seen);
    });
}

void RunningCameras::stop()
{
    ++m_generation;
    m_opening = false;
    m_tracker.reset();
    m_broadcast.reset();
    m_pace = {};
    if (m_session)
        onWorker([session = std::move(m_session)]() mutable { session.reset(); });
    m_session.reset();
}

void RunningCameras::setShownSize(std::size_t view, const QSize &pixels)
{
    if (view < mostViews)
        m_shownSize[view] = qint64(pixels.width()) << 32 | pixels.height();
}

/// The painter's thread.
void RunningCameras::showFrames()
{
    while (const auto sight = m_toShow.pop()) {
        const Frame &frame = sight->timedFrame.captured.frame;
        const qint64 shown = m_shownSize[sight->view];
        const QSize taken(frame.format.width, frame.format.height);
        const QSize size = taken.scaled(int(shown >> 32), int(shown & 0xffffffff), Qt::KeepAspectRatio);
        if (size.isEmpty()) { // nobody looks
            m_isPending[sight->view] = false;
            continue;
        }
        LiveFrame live{sight->view, toImage(toScreen(frame, size.width(), size.height())), taken,
                       sight->observations};
        callLater(this, [this, live] { deliver(live); });
    }
}

void RunningCameras::deliver(const LiveFrame &live)
{
    m_isPending[live.view] = false;
    if (m_session && live.view < m_cameras.size())
        Q_EMIT frameReady(live);
}

ChosenCameras::ChosenCameras(Project &project, CameraAccess access, QObject *parent)
    : QObject(parent), m_project(project), m_connected(std::move(access.list), this),
      m_running(std::move(access.open))
{
    connect(&m_connected, &LiveCameras::changed, this, [this] {
        if (m_wanted && !isPreparing() && !session())
            restart();
    });
}

void ChosenCameras::want()
{
    m_wanted = true;
    if (!session() && !m_running.isOpening())
        m_connected.poll();
}

void ChosenCameras::stop()
{
    m_wanted = false;
    m_running.stop();
}

std::vector<ChosenCamera> ChosenCameras::proposed(const std::vector<CameraRecord> &cameras) const
{
    return proposeCameras(cameras, m_connected.cameras(), rememberedCameras());
}

void ChosenCameras::restart()
{
    const auto cameras = m_project.cameras().all();
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    if (std::ranges::all_of(m_chosen, [](const ChosenCamera &camera) { return camera.second.empty(); }))
        m_chosen = proposed(*cameras);
    auto wanted = wantedCameras(m_project, m_chosen);
    if (!wanted) {
        Q_EMIT failed(wanted.error());
        return;
    }
    if (wanted->empty()) {
        Q_EMIT noneConnected();
        return;
    }
    m_running.start(std::move(*wanted));
    Q_EMIT starting();
}

/// Of the cameras that it knows; one that can only be read goes by what this machine remembers.
void ChosenCameras::keepInProject()
{
    for (const auto &[name, uri] : m_chosen) {
        const auto camera = m_project.cameras().find(name);
        if (!camera || camera->deviceUri == uri)
            continue;
        if (const auto kept = m_project.note(
                ODO_TEXT("ui.connect_camera", "connect camera %1")(Named::camera(name)),
                [&, device = uri] { return m_project.cameras().setDevice(camera->id, device); });
            !kept && kept.error().code != ErrorCode::ReadOnly)
            Q_EMIT failed(kept.error());
    }
}

void ChosenCameras::choose(QWidget *parent)
{
    std::vector<ChosenCamera> now = m_chosen;
    if (now.empty())
        now = proposed(m_project.cameras().all().value_or(std::vector<CameraRecord>()));
    CameraChoiceDialog dialog(now, m_connected, parent);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_chosen = dialog.cameras();
    rememberCameras(m_chosen);
    keepInProject();
    restart();
}

namespace {

/// nullopt: the project does not know the camera, or it is not registered.
Result<std::optional<RegistrationRecord>> registrationOf(Project &project, const std::string &camera)
{
    const auto record = project.cameras().find(camera);
    if (!record)
        return std::nullopt;
    return project.cameras().currentRegistration(record->id);
}

} // namespace

Result<std::vector<WantedCamera>> wantedCameras(Project &project, const std::vector<ChosenCamera> &chosen)
{
    std::vector<WantedCamera> wanted;
    for (const auto &[name, uri] : chosen) {
        if (uri.empty())
            continue;
        WantedCamera camera{name, uri, std::nullopt, {}};
        const auto registration = ODO_TRY(registrationOf(project, name));
        if (registration) {
            auto view = ODO_TRY(floorViewOf(project, *registration));
            const Intrinsics &intrinsics = view.camera().intrinsics();
            camera.registeredPx = {intrinsics.widthPx, intrinsics.heightPx};
            camera.floorView = std::move(view);
            camera.area = watchedArea(ODO_TRY(project.layouts().get(registration->layout)).layout);
        }
        wanted.push_back(std::move(camera));
    }
    return wanted;
}

Result<TrialScenePtr> liveScene(Project &project, const std::vector<WantedCamera> &cameras,
                                const std::optional<Task> &task)
{
    auto scene = std::make_shared<TrialScene>();
    scene->task = task;
    for (const WantedCamera &camera : cameras) {
        SceneView view;
        view.camera = camera.name;
        view.floorView = camera.floorView;
        scene->views.push_back(std::move(view));
        if (!camera.floorView || scene->layout)
            continue;
        const auto registration = registrationOf(project, camera.name);
        if (!registration || !*registration)
            continue;
        auto layout = ODO_TRY(project.layouts().get((*registration)->layout));
        scene->layout = std::move(layout.layout);
    }
    return scene;
}

} // namespace odo
