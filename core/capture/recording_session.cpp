// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording_session.h"

#include <algorithm>
#include <chrono>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds longestWait = 150ms;
constexpr double usualFramesPerSecond = 30;

/// Half an interval of the slowest camera: two that run free are never further apart.
Nanoseconds toleranceOf(const std::vector<std::unique_ptr<ViewRecorder>> &views)
{
    double slowest = usualFramesPerSecond;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double rate = views[i]->description().framesPerSecond;
        if (rate > 0)
            slowest = i == 0 ? rate : std::min(slowest, rate);
    }
    return fromSeconds(0.5 / slowest);
}

} // namespace

RecordingSession::RecordingSession(std::vector<RecordedCamera> cameras)
{
    for (std::size_t view = 0; view < cameras.size(); ++view)
        m_views.push_back(std::make_unique<ViewRecorder>(
            std::move(cameras[view].source), std::move(cameras[view].file),
            [this, view](TimedFrame frame) { pair(view, std::move(frame)); }));
    m_synchroniser.emplace(Synchroniser::Settings{m_views.size(), toleranceOf(m_views), longestWait});
    for (const auto &view : m_views)
        view->start();
}

RecordingSession::~RecordingSession() = default;

void RecordingSession::pair(std::size_t view, TimedFrame frame)
{
    const std::lock_guard lock(m_mutex);
    m_synchroniser->add(view, std::move(frame));
    m_synchroniser->take(std::chrono::steady_clock::now().time_since_epoch());
}

std::uint64_t RecordingSession::frames() const
{
    std::uint64_t fewest = m_views.front()->frames();
    for (const auto &view : m_views)
        fewest = std::min(fewest, view->frames());
    return fewest;
}

bool RecordingSession::hasEnded() const
{
    return std::any_of(m_views.begin(), m_views.end(), [](const auto &view) { return view->hasEnded(); });
}

RecordingOutcome RecordingSession::finish()
{
    for (const auto &view : m_views) // all at once, before the first waits for the disk
        view->stop();
    RecordingOutcome outcome;
    for (const auto &view : m_views)
        outcome.views.push_back(view->finish());
    m_views.clear();
    m_synchroniser->takeRest();
    outcome.pairs = m_synchroniser->figures();
    return outcome;
}

} // namespace odo
