// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/view_capture.h"

#include "core/base/percentile.h"
#include "core/base/shortage.h"
#include "core/base/steady_now.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds rateOver = 2s, longestSilence = 1s, longestStart = 3s;
constexpr double framesMissed = 5;
constexpr Nanoseconds paceKnownFrom = 1500ms, shortestSleep = 100ms;
constexpr double slowShare = 0.75; // of the rate; with a pause of half a second in two it has not got slow

} // namespace

ViewCapture::ViewCapture(std::unique_ptr<CameraSource> camera, std::size_t view, KeptFrames kept,
                         std::shared_ptr<FramePairing> pairing)
    : m_camera(std::move(camera)), m_view(view), m_pairing(std::move(pairing)),
      m_coder(description().uri, kept), m_slept(machineSlept())
{
}

ViewCapture::~ViewCapture() = default;

void ViewCapture::start()
{
    m_begun = steadyNow();
    if (auto started = m_coder.start(); !started)
        return cannotRun(started.error());
    std::promise<void> ended;
    m_takerEnded = ended.get_future();
    auto taker = startThread(cameraAtAddress(description().uri),
                             [self = shared_from_this(), ended = std::move(ended)]() mutable {
                                 self->takeFrames();
                                 ended.set_value();
                             });
    if (!taker)
        return cannotRun(taker.error());
    m_taker = std::move(*taker);
}

/// Without its threads the view has ended before it began; the others go on.
void ViewCapture::cannotRun(Error error)
{
    error.code = ErrorCode::Io; // it is not tried again
    interrupted(error);
}

void ViewCapture::stop()
{
    {
        const std::lock_guard lock(m_mutex);
        m_holdWanted = false;
    }
    settleAutomatics();
    m_camera->stop();
}

void ViewCapture::join(std::chrono::steady_clock::time_point deadline)
{
    const bool hangs = m_taker.joinable() && m_takerEnded.wait_until(deadline) == std::future_status::timeout;
    m_coder.end();
    if (hangs)
        m_taker.detach();
    else if (m_taker.joinable())
        m_taker.join();
    const std::lock_guard lock(m_mutex);
    for (const auto &feed : m_feeds)
        feed->close();
    m_feeds.clear();
    m_health.state = ViewHealth::State::Ended;
}

void ViewCapture::takeFrames()
{
    for (;;) {
        settleAutomatics();
        auto captured = orShortage([this] { return cameraAtAddress(description().uri); },
                                   [this] { return m_camera->next(); });
        if (captured) {
            take(std::move(*captured));
            continue;
        }
        if (captured.error().code == ErrorCode::Cancelled)
            return;
        interrupted(captured.error());
        if (captured.error().code != ErrorCode::Unavailable)
            return;
    }
}

void ViewCapture::interrupted(const Error &error)
{
    const std::lock_guard lock(m_mutex);
    m_health.state =
        error.code == ErrorCode::Unavailable ? ViewHealth::State::Waiting : ViewHealth::State::Ended;
    if (!m_health.warning)
        m_health.warning = RecordingWarning{error, steadyNow()};
    m_health.warning->error = error; // the cause may be known better by now
    m_interruption = error;
    m_health.slow.reset();
    m_pace.clear();
}

/// Holds them while a recording goes on, and gives them back after it. Camera calls may take their time, so
/// that none is made under the lock.
void ViewCapture::settleAutomatics()
{
    bool hold = false;
    {
        const std::lock_guard lock(m_mutex);
        if (m_held == m_holdWanted)
            return;
        m_held = hold = m_holdWanted;
        if (!hold) {
            m_health.automaticsHeld.reset();
            m_health.notHeld.clear();
        }
    }
    if (!hold)
        return m_camera->releaseAutomatics();
    std::vector<Message> notHeld = m_camera->holdAutomatics();
    const std::lock_guard lock(m_mutex);
    m_health.automaticsHeld = notHeld.empty();
    m_health.notHeld = std::move(notHeld);
}

void ViewCapture::take(CapturedFrame captured)
{
    const Nanoseconds now = steadyNow();
    TimedFrame timed{std::move(captured), {}};
    {
        const std::lock_guard lock(m_mutex);
        noteSleep(timed.captured);
        timed.taken = note(timed.captured, now);
        m_lostBefore += timed.captured.lostHere;
        if (m_coder.offer({timed.captured, timed.taken, m_interruption, m_lostBefore})) {
            m_interruption.reset();
            m_lostBefore = 0;
        } else {
            ++m_lostBefore;
            ++m_health.lostByUs;
        }
        giveOut(timed);
    }
    m_pairing->add(m_view, std::move(timed), now);
}

/// Frames that arrived before it slept may be taken only now; then the gap is yet to come. How long it
/// slept a machine knows to a second at best, so what was known of the camera's clock no longer holds.
/// The mutex is held.
void ViewCapture::noteSleep(const CapturedFrame &captured)
{
    const Nanoseconds slept = machineSlept() - m_slept;
    m_slept += slept;
    m_sleep += slept;
    const RawTime raw{captured.sequence, captured.frame.time, captured.hostTime};
    const RawTime last = std::exchange(m_last, raw).value_or(raw);
    if (m_sleep < shortestSleep ||
        std::max(raw.device - last.device, raw.arrival - last.arrival) < m_sleep / 2)
        return;
    m_clock = {};
    m_pace.clear();
    m_interruption = machineSleptError(std::exchange(m_sleep, Nanoseconds(0)));
}

/// By the camera's own clock and count, so that late or lost frames make no difference; the
/// mutex is held.
std::optional<RecordingWarning> ViewCapture::slowness(const CapturedFrame &captured, Nanoseconds now)
{
    const CameraDescription &camera = description();
    if (!comesByWire(camera.kind) || !(camera.framesPerSecond > 0))
        return std::nullopt;
    m_pace.push_back({captured.sequence, captured.frame.time});
    const Nanoseconds window = std::max(rateOver, fromSeconds(framesMissed / camera.framesPerSecond));
    while (m_pace[1 % m_pace.size()].time <= captured.frame.time - window)
        m_pace.pop_front();
    const Nanoseconds span = captured.frame.time - m_pace.front().time;
    if (span < paceKnownFrom)
        return m_health.slow;
    const double rate = static_cast<double>(captured.sequence - m_pace.front().sequence) / toSeconds(span);
    if (rate >= slowShare * camera.framesPerSecond)
        return std::nullopt;
    return RecordingWarning{slowCameraError(camera.uri, rate, camera.framesPerSecond),
                            m_health.slow ? m_health.slow->since : now};
}

/// When it was taken; the mutex is held.
Nanoseconds ViewCapture::note(const CapturedFrame &captured, Nanoseconds now)
{
    if (captured.clock)
        m_clock.addLatch(captured.clock->device, captured.clock->before, captured.clock->after);
    m_clock.addArrival(captured.frame.time, captured.hostTime);
    m_health.clock = m_clock.fit();
    const Nanoseconds taken = m_health.clock->hostTime(captured.frame.time);
    m_health.state = ViewHealth::State::Delivering;
    m_health.warning.reset();
    m_health.slow = slowness(captured, now);
    ++m_health.delivered;
    if (m_lastSequence && captured.sequence > *m_lastSequence + 1 + captured.lostHere)
        m_health.lostOnWire += captured.sequence - *m_lastSequence - 1 - captured.lostHere;
    m_health.lostByUs += captured.lostHere;
    m_lastSequence = captured.sequence;
    m_lastArrival = now;
    m_recent.push_back({now, toSeconds(now - taken)});
    while (m_recent.front().arrival < now - rateOver)
        m_recent.pop_front();
    return taken;
}

/// Who has closed his feed has had enough; the mutex is held.
void ViewCapture::giveOut(const TimedFrame &timed)
{
    std::erase_if(m_feeds, [&timed](const auto &feed) { return !feed->pushOrDrop(timed); });
}

std::shared_ptr<BoundedQueue<TimedFrame>> ViewCapture::subscribe(std::size_t capacity)
{
    auto feed = std::make_shared<BoundedQueue<TimedFrame>>(capacity);
    const std::lock_guard lock(m_mutex);
    m_feeds.push_back(feed);
    return feed;
}

/// Nothing comes and nobody says why: a camera, or its driver, that hangs.
std::optional<RecordingWarning> ViewCapture::silence(Nanoseconds now) const
{
    const bool began = m_health.delivered > 0;
    const double rate = std::max(1.0, description().framesPerSecond);
    const Nanoseconds allowed =
        std::max(began ? longestSilence : longestStart, fromSeconds(framesMissed / rate));
    const Nanoseconds last = (began ? m_lastArrival : m_begun) + (machineSlept() - m_slept);
    if (now - last <= allowed)
        return std::nullopt;
    return RecordingWarning{
        {ErrorCode::Unavailable, cameraAtAddress(description().uri),
         ODO_TEXT("capture.no_picture_for",
                  "no frame has arrived for %1")(quantity(std::floor(toSeconds(now - last)), 0, "s")),
         joined({ODO_TEXT("capture.look_at_cable", "check its cable"),
                 ODO_TEXT("capture.take_off_and_on", "unplug it and plug it in again if this continues")},
                Join::Semicolon)},
        last};
}

ViewHealth ViewCapture::health(Nanoseconds now) const
{
    ViewHealth health;
    std::vector<double> latenciesS;
    {
        const std::lock_guard lock(m_mutex);
        health = m_health;
        for (const Recent &recent : m_recent) {
            if (recent.arrival >= now - rateOver)
                latenciesS.push_back(recent.latencyS);
        }
        if (!health.warning && health.state != ViewHealth::State::Ended)
            health.warning = silence(now);
    }
    if (health.warning && health.state != ViewHealth::State::Ended)
        health.state = ViewHealth::State::Waiting;
    if (health.warning)
        health.slow.reset();
    const double overS = toSeconds(std::min(rateOver, std::max(now - m_begun, Nanoseconds(1ms))));
    health.framesPerSecond = static_cast<double>(latenciesS.size()) / overS;
    health.latencyS = percentile(std::move(latenciesS), 95);
    health.source = m_camera->counts();
    health.hasWire = comesByWire(description().kind);
    return health;
}

std::optional<Error> ViewCapture::end() const
{
    const std::lock_guard lock(m_mutex);
    if (m_health.state != ViewHealth::State::Ended || !m_health.warning)
        return std::nullopt;
    return m_health.warning->error;
}

void ViewCapture::startWriting(std::shared_ptr<ViewWriter> writer, Nanoseconds preRoll)
{
    {
        const std::lock_guard lock(m_mutex);
        m_holdWanted = true;
    }
    m_coder.startWriting(std::move(writer), steadyNow() - preRoll);
}

std::future<void> ViewCapture::stopWriting()
{
    std::uint64_t lostBefore = 0;
    {
        const std::lock_guard lock(m_mutex);
        lostBefore = std::exchange(m_lostBefore, 0);
        m_holdWanted = false;
    }
    return m_coder.stopWriting(lostBefore);
}

} // namespace odo
