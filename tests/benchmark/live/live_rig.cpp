// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/live/live_rig.h"

#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "tests/benchmark/cpu_clock.h"
#include "tests/support/said_error.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/running_cameras.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QEventLoop>

#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace odo::test {

namespace {

constexpr int healthMs = 500, eachMs = 5000, longestStartMs = 60000, longestEndMs = 120000;
const QSize windowSize(1600, 1000);

double processCpuS()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double residentMb()
{
    std::ifstream file("/proc/self/statm");
    double size = 0, resident = 0;
    file >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Runs the event loop until it is true; false when it took longer.
bool waitUntil(const std::function<bool()> &isTrue, int longestMs)
{
    QElapsedTimer since;
    since.start();
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (isTrue() || since.elapsed() > longestMs)
            loop.quit();
    });
    look.start(10);
    loop.exec();
    return isTrue();
}

} // namespace

bool WatchedApplication::notify(QObject *receiver, QEvent *event)
{
    if (m_isInside || receiver->thread() != thread())
        return QApplication::notify(receiver, event);
    m_isInside = true;
    const double beginS = threadCpuS();
    const bool taken = QApplication::notify(receiver, event);
    m_longestMs = std::max(m_longestMs, 1000 * (threadCpuS() - beginS));
    m_isInside = false;
    return taken;
}

LiveRig::LiveRig(Project &project, RunningCameras::Open open, const std::array<std::string, 2> &uris,
                 LiveWindow window)
    : m_project(project), m_window(window), m_cameras(std::move(open)), m_board({}),
      m_recorder(project.file())
{
    connect(&m_recorder, &RunRecorder::gaveUp, this,
            [this](const QString &, const Error &error) { m_failure = error; });
    connect(&m_recorder, &RunRecorder::failed, this, [this](const Error &error) { m_failure = error; });
    connect(&m_cameras, &RunningCameras::frameReady, &m_board, &LiveBoard::setImage);
    if (window == LiveWindow::Shown)
        connect(&m_board, &LiveBoard::shownSizeChanged, this,
                [this](std::size_t view, const QSize &pixels) { m_cameras.setShownSize(view, pixels); });
    connect(&m_cameras, &RunningCameras::moved, this, &LiveRig::takeMoment);
    connect(&m_health, &QTimer::timeout, this, [this] {
        if (m_cameras.session())
            m_board.setHealth(m_cameras.session()->health(), m_cameras.cameras(),
                              m_cameras.tracker()->statistics(), {});
    });
    m_board.findChild<LiveMap *>()->installEventFilter(this);
    const auto wanted = wantedCameras(project, {{"A", uris[0]}, {"B", uris[1]}});
    const auto robots = project.robots().all();
    if (!wanted || !robots) {
        m_failure = wanted ? robots.error() : wanted.error();
        return;
    }
    if (const auto following = m_cameras.follow(*robots); !following)
        m_failure = following.error();
    m_cameras.start(*wanted);
    m_board.setCameras(m_cameras);
    m_board.setRobots(*robots);
    if (const auto floor = liveScene(project, *wanted, std::nullopt))
        m_board.setFloor(*floor);
    m_board.resize(windowSize);
    m_board.setVisible(window == LiveWindow::Shown);
    m_health.start(healthMs);
}

Result<void> LiveRig::waitForCameras()
{
    const auto deliver = [this] {
        if (m_failure)
            return true;
        if (!m_cameras.session())
            return false;
        const CaptureHealth health = m_cameras.session()->health();
        return std::ranges::all_of(health.views, [](const ViewHealth &view) {
            return view.state == ViewHealth::State::Delivering && view.delivered > 60;
        });
    };
    const bool all = waitUntil(deliver, longestStartMs);
    if (m_failure)
        return tl::unexpected(*m_failure);
    if (!all)
        return test::saidFailure(ErrorCode::Unavailable, "the cameras", "no pictures within a minute",
                                 "see their own words");
    return {};
}

void LiveRig::takeMoment(const LiveMoment &moment)
{
    m_board.addMoment(moment);
    if (!m_measuring || !moment.position.sample.position)
        return;
    if (m_window == LiveWindow::Shown)
        m_unpainted.push_back(moment.position.sample.time);
    else
        m_measured.latenciesMs.push_back(1000 * toSeconds(steadyNow() - moment.position.sample.time));
}

/// The map's own painting comes first, so that it counts.
bool LiveRig::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Paint || m_unpainted.empty())
        return false;
    watched->removeEventFilter(this);
    watched->event(event);
    watched->installEventFilter(this);
    const Nanoseconds painted = steadyNow();
    for (const Nanoseconds taken : std::exchange(m_unpainted, {}))
        m_measured.latenciesMs.push_back(1000 * toSeconds(painted - taken));
    return true;
}

Result<LiveMeasurement> LiveRig::record(double seconds, const std::function<void()> &each)
{
    m_measured = {};
    NextRun run;
    run.trial = "live";
    run.robots = {m_project.robots().all()->front().name};
    const CaptureHealth before = m_cameras.session()->health();
    const LiveStatistics trackedBefore = m_cameras.tracker()->statistics();
    const Nanoseconds begin = steadyNow();
    m_recorder.begin(run, {"A", "B"}, m_cameras.session(), {begin, begin});
    m_cameras.tracker()->beginRun(begin);
    static_cast<WatchedApplication *>(qApp)->takeLongestMs();
    m_measuring = true;
    const double cpuS = processCpuS();
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, this, [&] {
        const double passedS = toSeconds(steadyNow() - begin);
        m_measured.memory.emplace_back(passedS, residentMb());
        if (passedS < seconds - 0.5e-3 * eachMs)
            each();
    });
    ticks.start(eachMs);
    waitUntil([&] { return m_failure || toSeconds(steadyNow() - begin) >= seconds; },
              static_cast<int>(1000 * seconds) + longestStartMs);
    m_measuring = false;
    m_measured.seconds = toSeconds(steadyNow() - begin);
    m_measured.cores = (processCpuS() - cpuS) / m_measured.seconds;
    m_measured.longestBusyMs = static_cast<WatchedApplication *>(qApp)->takeLongestMs();
    const LiveStatistics tracked = m_cameras.tracker()->statistics();
    const CaptureHealth after = m_cameras.session()->health();
    m_measured.positions = m_measured.latenciesMs.size();
    m_measured.notTracked = tracked.dropped - trackedBefore.dropped;
    m_recorder.end();
    waitUntil([this] { return !m_recorder.isEnding(); }, longestEndMs);
    if (m_failure)
        return tl::unexpected(*m_failure);
    for (std::size_t v = 0; v < m_measured.views.size(); ++v) {
        m_measured.views[v].lostOnWire = after.views[v].lostOnWire - before.views[v].lostOnWire;
        m_measured.views[v].lostByUs = after.views[v].lostByUs - before.views[v].lostByUs;
    }
    const auto read = readRecordings(run.trial, m_measured);
    return read ? Result<LiveMeasurement>(m_measured) : tl::unexpected(read.error());
}

Result<void> LiveRig::readRecordings(const std::string &trial, LiveMeasurement &measured) const
{
    const auto record = m_project.trials().find(trial);
    if (!record)
        return tl::unexpected(record.error());
    const auto recordings = m_project.trials().recordings(record->id);
    if (!recordings)
        return tl::unexpected(recordings.error());
    for (std::size_t v = 0; v < recordings->size() && v < measured.views.size(); ++v) {
        LiveViewStatistics &view = measured.views[v];
        const auto raw = m_project.trials().rawTimes((*recordings)[v].id);
        if (!raw)
            return tl::unexpected(raw.error());
        const std::filesystem::path file = m_project.resolve((*recordings)[v]);
        const auto reader = VideoReader::open(file);
        if (!reader)
            return tl::unexpected(reader.error());
        view.recorded = raw->frames.size();
        view.played = (*reader)->info().frameTimes.size();
        if (!raw->frames.empty())
            view.spanned = raw->frames.back().sequence - raw->frames.front().sequence + 1;
        measured.bytes += std::filesystem::file_size(file);
    }
    return {};
}

} // namespace odo::test
