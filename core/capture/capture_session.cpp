// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_session.h"

#include "core/base/percentile.h"
#include "core/base/steady_now.h"
#include "core/capture/clock_map.h"
#include "core/capture/internal/view_capture.h"
#include "core/capture/synchroniser.h"

#include <algorithm>
#include <chrono>
#include <span>

namespace odo {

namespace {

using namespace std::chrono_literals;

// ClockMap remembers 30 s: what it knows 15 s later has a frame in its middle.
constexpr Nanoseconds lookAhead = 15s, knotEach = 10s, shortestStep = 1us;

/// The clock as it was known around a device time.
struct Knot
{
    Nanoseconds device;
    ClockFit fit;
};

/// Frames between which the camera's clock was not reset.
using Stretch = std::span<const RawTime>;

/// Feeds a clock map with such a run of frames, the readings among them as they came.
std::vector<Knot> knotsOf(Stretch frames, std::span<const ClockReading> readings)
{
    std::vector<Knot> knots;
    ClockMap clock;
    ClockFit newest;
    Nanoseconds next = frames.front().device + lookAhead;
    for (const RawTime &frame : frames) {
        while (!readings.empty() && readings.front().after <= frame.arrival) {
            clock.addLatch(readings.front().device, readings.front().before, readings.front().after);
            readings = readings.subspan(1);
        }
        clock.addArrival(frame.device, frame.arrival);
        newest = clock.fit().value_or(newest);
        if (frame.device >= next + lookAhead) {
            knots.push_back({next, newest});
            next += knotEach;
        }
    }
    knots.push_back({std::max(next, frames.back().device - lookAhead), newest});
    return knots;
}

/// Interpolates between two knots, so that no frame's time jumps.
Nanoseconds hostTime(const std::vector<Knot> &knots, Nanoseconds device)
{
    const auto after =
        std::ranges::find_if(knots, [device](const Knot &knot) { return knot.device >= device; });
    if (after == knots.begin())
        return knots.front().fit.hostTime(device);
    if (after == knots.end())
        return knots.back().fit.hostTime(device);
    const auto before = after - 1;
    const double share = toSeconds(device - before->device) / toSeconds(after->device - before->device);
    const Nanoseconds from = before->fit.hostTime(device), to = after->fit.hostTime(device);
    return from + fromSeconds(share * toSeconds(to - from));
}

/// Whether no clock that just goes on can show both: the steps of the two clocks differ, whatever moment of
/// each round trip the camera's was read at.
bool isSetBetween(const ClockReading &a, const ClockReading &b)
{
    const Nanoseconds step = b.device - a.device;
    const Nanoseconds bound = largestClockJump + fromSeconds(fastestClockRate * std::abs(toSeconds(step)));
    return (b.before - a.after) - step > bound || step - (b.after - a.before) > bound;
}

/// The first frame on the new scale, where the clock was reset between two readings: that whose step
/// from the one before is least like the usual one, of those between the readings. Arrivals do not show it:
/// earlier frames may be late by seconds.
std::size_t firstOnNewScale(Stretch frames, const ClockReading &before, const ClockReading &after)
{
    const auto [from, to] = std::minmax(before.device, after.device);
    std::vector<Nanoseconds> steps;
    for (std::size_t i = 1; i < frames.size(); ++i)
        steps.push_back(frames[i].device - frames[i - 1].device);
    const Nanoseconds usual = steps.empty() ? 0ns : upperMedian(steps);
    std::size_t first = frames.front().device > to ? 0 : frames.size();
    Nanoseconds oddest{-1};
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const Nanoseconds odd = std::chrono::abs(steps[i - 1] - usual);
        if (frames[i].device >= from && frames[i - 1].device <= to && odd > oddest) {
            oddest = odd;
            first = i;
        }
    }
    return first;
}

/// How many frames and readings come before the next reset of the camera's clock.
struct StretchSize
{
    std::size_t frames, readings;
};

StretchSize nextStretch(Stretch frames, std::span<const ClockReading> readings)
{
    const auto back = std::ranges::adjacent_find(
        frames, [](const RawTime &a, const RawTime &b) { return b.device < a.device; });
    const auto backwards =
        back == frames.end() ? frames.size() : static_cast<std::size_t>(back - frames.begin()) + 1;
    const auto set = std::ranges::adjacent_find(readings, isSetBetween);
    if (set != readings.end()) {
        const auto count = static_cast<std::size_t>(set - readings.begin()) + 1;
        if (set[1].device < set->device && backwards < frames.size())
            return {backwards, count};
        const std::size_t first = firstOnNewScale(frames.first(backwards), set[0], set[1]);
        if (first < backwards || backwards == frames.size())
            return {first, count};
    }
    const auto later = std::ranges::find_if(readings, [&](const ClockReading &reading) {
        return backwards < frames.size() && reading.after > frames[backwards - 1].arrival;
    });
    return {backwards, static_cast<std::size_t>(later - readings.begin())};
}

void deriveStretch(Stretch frames, std::span<const ClockReading> readings, DerivedTimes &into)
{
    const std::vector<Knot> knots = knotsOf(frames, readings);
    for (const Knot &knot : knots)
        into.sigmaS = std::max(into.sigmaS, knot.fit.sigmaS);
    for (const RawTime &frame : frames) {
        Nanoseconds taken = hostTime(knots, frame.device);
        if (!into.taken.empty())
            taken = std::max(taken, into.taken.back() + shortestStep);
        into.taken.push_back(taken);
    }
}

} // namespace

DerivedTimes deriveTimes(const RecordedTimes &times)
{
    DerivedTimes derived;
    Stretch left(times.frames);
    std::span<const ClockReading> readings(times.readings);
    while (!left.empty()) {
        const StretchSize size = nextStretch(left, readings);
        if (size.frames > 0)
            deriveStretch(left.first(size.frames), readings.first(size.readings), derived);
        left = left.subspan(size.frames);
        readings = readings.subspan(size.readings);
    }
    return derived;
}

Message reconnectDisk()
{
    return ODO_TEXT("capture.put_disk_back", "reconnect its disk, or move its folder back");
}

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds longestWait = 150ms;
constexpr auto longestEnd = 1s;
constexpr Nanoseconds shortestPause = 100ms, sleepReportedFor = 10s;
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
      m_preRollBytesOfView(settings.preRollBytes / cameras.size()),
      m_pairing(
          std::make_shared<FramePairing>(Synchroniser::Settings{cameras.size(), m_tolerance, longestWait}))
{
    for (std::size_t view = 0; view < cameras.size(); ++view)
        m_views.push_back(std::make_shared<ViewCapture>(
            std::move(cameras[view]), view, KeptFrames{settings.preRoll, m_preRollBytesOfView}, m_pairing));
    for (const auto &view : m_views)
        view->start();
}

CaptureSession::~CaptureSession()
{
    if (isRecording())
        stopRecording();
    for (const auto &view : m_views) // all at once, before waiting for the first
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
        health.views[view].lostByUs += state.droppedWhenFull;
        health.disk.recordedS =
            view == 0 ? state.recordedS : std::min(health.disk.recordedS, state.recordedS);
        health.disk.bytes += state.bytes;
        health.disk.waiting = std::max(health.disk.waiting, state.waiting);
        if (state.secondsLeft)
            shares += 1 / std::max(*state.secondsLeft, 1e-3);
        if (state.problem && !health.disk.ended)
            health.disk.warning = RecordingWarning{*state.problem, now};
        else if (state.slow && !health.disk.warning)
            health.disk.warning = state.slow;
        health.disk.ended |= state.problem.has_value();
    }
    if (shares > 0)
        health.disk.secondsLeft = 1 / shares;
    return health;
}

/// It is found out by who looks first; the mutex is held.
std::optional<RecordingWarning> CaptureSession::sleep(Nanoseconds now) const
{
    const Nanoseconds slept = machineSlept() - m_slept;
    if (slept >= shortestPause) {
        m_slept += slept;
        m_sleep = RecordingWarning{machineSleptError(slept), now};
    }
    if (m_writers.empty() && m_sleep && now - m_sleep->since > sleepReportedFor)
        m_sleep.reset();
    return m_sleep;
}

std::optional<double> CaptureSession::remainingSeconds(const std::filesystem::path &folder) const
{
    double bytesPerSecond = 0;
    for (const auto &view : m_views)
        bytesPerSecond += view->bytesPerSecond();
    const std::optional<DiskCapacity> space = m_disk.space(folder);
    if (!space || bytesPerSecond <= 0)
        return std::nullopt;
    return static_cast<double>(m_disk.left(*space)) / bytesPerSecond;
}

void CaptureSession::setPreRoll(Nanoseconds preRoll)
{
    for (const auto &view : m_views)
        view->keepFor(preRoll);
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
    outcome.pairs = pairStatistics(taken, m_tolerance);
    return outcome;
}

} // namespace odo
