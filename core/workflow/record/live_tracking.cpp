// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/live_tracking.h"

#include "core/base/percentile.h"
#include "core/base/shortage.h"
#include "core/base/steady_now.h"
#include "core/workflow/track/view_tracking.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds keptBeforeARun = 10s, latencyWindow = 10s;

/// Registered at another picture size, it would be placed wrongly in silence.
bool fits(const LiveView &view, const FrameFormat &format)
{
    const Intrinsics &lens = view.floorView->camera().intrinsics();
    return lens.widthPx == format.width && lens.heightPx == format.height;
}

} // namespace

Message liveWords(const LiveFigures &figures)
{
    if (figures.latencyMedianS <= 0)
        return {};
    const MessageArgument behind = quantity(std::round(1e3 * figures.latencyMedianS), 0, "ms");
    return figures.dropped == 0
               ? ODO_TEXT("workflow.map_behind", "the map is %1 behind, none skipped")(behind)
               : ODO_TEXT("workflow.map_behind_and_skipping",
                          "the map is %1 behind, %2 skipped")(behind, figures.dropped);
}

Result<TaskAnalysis> analyseRun(const LiveRun &run, const AnalysisOptions &options,
                                const std::optional<TaskRecord> &task)
{
    return analyseByTask(
        [&](const AnalysisOptions &by) { return analyse(run.views, shapeOf(run.robot), by); }, options, task);
}

LiveTracker::LiveTracker(const std::vector<LiveView> &views, const std::vector<RobotRecord> &robots,
                         Listener listener)
    : m_robots(robots), m_listener(std::move(listener)), m_views(views.size())
{
    for (std::size_t v = 0; v < views.size(); ++v) {
        m_views[v].view = views[v];
        m_views[v].kept.resize(robots.size());
    }
    for (const RobotRecord &robot : robots)
        m_tracks.emplace_back(views, shapeOf(robot));
}

Result<std::unique_ptr<LiveTracker>> LiveTracker::create(const std::vector<LiveView> &views,
                                                         const std::vector<RobotRecord> &robots,
                                                         std::vector<Feed> feeds, Listener listener)
{
    std::unique_ptr<LiveTracker> live(new LiveTracker(views, robots, std::move(listener)));
    std::vector<TrackTarget> targets;
    for (const RobotRecord &robot : robots)
        targets.push_back({robot.name, robot.colour});
    for (View &view : live->m_views) {
        if (targets.empty())
            break;
        if (needsBackground(targets))
            view.background.emplace();
        auto tracker = ODO_TRY(RobotTracker::create(targets, {}, view.view.floorView));
        view.tracker = std::move(tracker);
    }
    for (std::size_t v = 0; v < live->m_views.size(); ++v) {
        live->m_views[v].feed = std::move(feeds[v]);
        auto thread = startThread(ODO_TEXT("workflow.live_tracking", "live tracking"),
                                  [&live = *live, v] { live.follow(v); });
        if (!thread)
            return tl::unexpected(thread.error());
        live->m_views[v].thread = std::move(*thread);
    }
    return live;
}

LiveTracker::~LiveTracker()
{
    for (View &view : m_views) {
        if (view.feed)
            view.feed->close();
    }
    for (View &view : m_views) {
        if (view.thread.joinable())
            view.thread.join();
    }
}

void LiveTracker::follow(std::size_t view)
{
    View &own = m_views[view];
    while (auto picture = own.feed->pop()) {
        LiveSight sight{view, std::move(*picture), {}};
        Frame &frame = sight.picture.captured.frame;
        frame.time = sight.picture.taken; // all views are told by one clock
        if (own.background) {
            if (auto newer = own.background->add(frame))
                own.tracker->setBackground(std::move(*newer));
        }
        if (own.tracker)
            sight.observations = own.tracker->track(frame);
        place(std::move(sight));
    }
}

void LiveTracker::place(LiveSight sight)
{
    const std::lock_guard lock(m_mutex);
    ++m_tracked;
    const LiveView &view = m_views[sight.view].view;
    const bool placed = view.floorView && fits(view, sight.picture.captured.frame.format);
    if (placed)
        keep(sight.view, sight);
    for (std::size_t r = 0; placed && r < sight.observations.size(); ++r) {
        auto position = m_tracks[r].add(sight.view, sight.observations[r]);
        if (!position)
            continue;
        const Nanoseconds known = steadyNow();
        const double latencyS = toSeconds(known - position->sample.time);
        const LiveMoment moment{r, std::move(*position), latencyS};
        if (moment.position.sample.position)
            m_latencies.emplace_back(known, moment.latencyS);
        while (!m_latencies.empty() && m_latencies.front().first < known - latencyWindow)
            m_latencies.pop_front();
        if (m_listener.moment)
            m_listener.moment(moment);
    }
    if (m_listener.sight)
        m_listener.sight(sight);
}

void LiveTracker::keep(std::size_t view, const LiveSight &sight)
{
    for (std::size_t r = 0; r < sight.observations.size(); ++r) {
        auto &kept = m_views[view].kept[r];
        kept.push_back(sight.observations[r]);
        const Nanoseconds oldest = m_runFrom.value_or(kept.back().time - keptBeforeARun);
        while (!kept.empty() && kept.front().time < oldest)
            kept.pop_front();
    }
}

LiveFigures LiveTracker::figures() const
{
    const std::lock_guard lock(m_mutex);
    LiveFigures figures{m_tracked, 0, 0, 0};
    for (const View &view : m_views)
        figures.dropped += view.feed->dropped();
    std::vector<double> latencies;
    for (const auto &[when, latencyS] : m_latencies)
        latencies.push_back(latencyS);
    figures.latencyMedianS = percentile(latencies, 50);
    figures.latencyP99S = percentile(std::move(latencies), 99);
    return figures;
}

void LiveTracker::beginRun(Nanoseconds from)
{
    const std::lock_guard lock(m_mutex);
    m_runFrom = from;
}

std::vector<LiveRun> LiveTracker::endRun()
{
    const std::lock_guard lock(m_mutex);
    const Nanoseconds from = m_runFrom.value_or(Nanoseconds{0});
    m_runFrom.reset();
    std::vector<LiveRun> runs;
    for (std::size_t r = 0; r < m_robots.size(); ++r) {
        runs.push_back({m_robots[r], {}});
        for (View &view : m_views) {
            ViewTrack track{view.view.camera, view.view.floorView, Nanoseconds{0}, {}};
            for (Observation observation : view.kept[r]) {
                observation.time -= from;
                observation.frame = static_cast<std::int64_t>(track.observations.size());
                if (observation.time >= Nanoseconds{0})
                    track.observations.push_back(observation);
            }
            view.kept[r].clear();
            if (!track.observations.empty())
                runs.back().views.push_back(std::move(track));
        }
    }
    return runs;
}

} // namespace odo
