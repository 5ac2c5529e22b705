// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_session.h"

#include "core/base/steady_now.h"
#include "core/capture/internal/view_capture.h"
#include "core/capture/synchroniser.h"

#include <algorithm>
#include <chrono>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds longestWait = 150ms;
constexpr auto longestEnd = 1s;
constexpr Nanoseconds shortestPause = 100ms, sleepToldFor = 10s;
constexpr double usualFramesPerSecond = 30;

/// Half an interval of the slowest camera: two that run free are never further apart.
Nanoseconds toleranceOf(const std::vector<std::unique_ptr<CameraSource>> &cameras)
{
    double slowest = usualFramesPerSecond;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const double rate = cameras[i]->description().framesPerSecond;
        if (rate > 0)
            slowest = i == 0 ? rate : std::min(slowest, rate);
    }
    return fromSeconds(0.5 / slowest);
}

} // namespace

CaptureSession::CaptureSession(std::vector<std::unique_ptr<CameraSource>> cameras, CaptureSettings settings)
    : m_tolerance(toleranceOf(cameras)), m_disk(std::move(settings.disk)),
      m_pairing(
          std::make_shared<FramePairing>(Synchroniser::Settings{cameras.size(), m_tolerance, longestWait}))
{
    for (std::size_t view = 0; view < cameras.size(); ++view)
        m_views.push_back(
            std::make_shared<ViewCapture>(std::move(cameras[view]), view, settings.preRoll, m_pairing));
    for (const auto &view : m_views)
        view->start();
}

CaptureSession::~CaptureSession()
{
    if (isRecording())
        stopRecording();
    for (const auto &view : m_views) // all at once, before the first is waited for
        view->stop();
    const auto deadline = std::chrono::steady_clock::now() + longestEnd;
    for (const auto &view : m_views)
        view->join(deadline);
}

const CameraDescription &CaptureSession::description(std::size_t view) const
{
    return m_views[view]->description();
}

void CaptureSession::showRobots(const std::vector<RobotAppearance> &robots)
{
    for (const auto &view : m_views)
        view->showRobots(robots);
}

Result<std::vector<CameraControl>> CaptureSession::controls(std::size_t view) const
{
    return m_views[view]->controls();
}

std::shared_ptr<FrameFeed> CaptureSession::subscribeFrames(std::size_t view, std::size_t capacity)
{
    return m_views[view]->subscribe(capacity);
}

CaptureHealth CaptureSession::health() const
{
    const Nanoseconds now = steadyNow();
    CaptureHealth health;
    for (const auto &view : m_views)
        health.views.push_back(view->health(now));
    health.pairs = m_pairing->health(now);
    const std::lock_guard lock(m_mutex);
    health.sleep = sleep(now);
    health.disk.recording = !m_writers.empty();
    double shares = 0; // of what is left, that the views write a second
    for (std::size_t view = 0; view < m_writers.size(); ++view) {
        const ViewWriter::State state = m_writers[view]->state(now);
        health.views[view].lostByUs += state.withoutRoom;
        health.disk.recordedS =
            view == 0 ? state.recordedS : std::min(health.disk.recordedS, state.recordedS);
        health.disk.bytes += state.bytes;
        health.disk.waiting = std::max(health.disk.waiting, state.waiting);
        if (state.secondsLeft)
            shares += 1 / std::max(*state.secondsLeft, 1e-3);
        if (state.problem && !health.disk.ended)
            health.disk.trouble = Trouble{*state.problem, now};
        else if (state.slow && !health.disk.trouble)
            health.disk.trouble = state.slow;
        health.disk.ended |= state.problem.has_value();
    }
    if (shares > 0)
        health.disk.secondsLeft = 1 / shares;
    return health;
}

/// It is found out by who looks first; the mutex is held.
std::optional<Trouble> CaptureSession::sleep(Nanoseconds now) const
{
    const Nanoseconds slept = machineSlept() - m_slept;
    if (slept >= shortestPause) {
        m_slept += slept;
        m_sleep = Trouble{machineSleptError(slept), now};
    }
    if (m_writers.empty() && m_sleep && now - m_sleep->since > sleepToldFor)
        m_sleep.reset();
    return m_sleep;
}

std::optional<double> CaptureSession::secondsOfRoom(const std::filesystem::path &folder) const
{
    double bytesPerSecond = 0;
    for (const auto &view : m_views)
        bytesPerSecond += view->bytesPerSecond();
    const std::optional<DiskRoom> room = m_disk.room(folder);
    if (!room || bytesPerSecond <= 0)
        return std::nullopt;
    return static_cast<double>(m_disk.left(*room)) / bytesPerSecond;
}

void CaptureSession::startRecording(const std::vector<std::filesystem::path> &files, Nanoseconds preRoll)
{
    const std::lock_guard lock(m_mutex);
    m_slept = machineSlept();
    m_sleep.reset();
    for (std::size_t view = 0; view < m_views.size(); ++view) {
        const double rate = description(view).framesPerSecond; // 0 of one that is still waited for
        m_writers.push_back(
            std::make_shared<ViewWriter>(files[view], rate > 0 ? rate : usualFramesPerSecond, m_disk));
        m_views[view]->startWriting(m_writers.back(), preRoll);
    }
}

bool CaptureSession::isRecording() const
{
    const std::lock_guard lock(m_mutex);
    return !m_writers.empty();
}

RecordedTimes CaptureSession::takeWritten(std::size_t view)
{
    const std::lock_guard lock(m_mutex);
    return m_writers.empty() ? RecordedTimes{} : m_writers[view]->takeWritten();
}

RecordingOutcome CaptureSession::stopRecording()
{
    std::vector<std::future<void>> handedOver;
    for (const auto &view : m_views)
        handedOver.push_back(view->stopWriting());
    for (const std::future<void> &done : handedOver)
        done.wait();
    RecordingOutcome outcome;
    for (std::size_t view = 0; view < m_views.size();
         ++view) { // m_writers is changed by nobody else meanwhile
        if (const auto end = m_views[view]->end())
            m_writers[view]->fail(*end);
        outcome.views.push_back(m_writers[view]->finish());
    }
    {
        const std::lock_guard lock(m_mutex);
        m_writers.clear();
    }
    std::vector<std::vector<Nanoseconds>> taken;
    for (const ViewRecording &view : outcome.views)
        taken.push_back(view.taken);
    outcome.pairs = pairFigures(taken, m_tolerance);
    return outcome;
}

} // namespace odo
