// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/synchroniser.h"
#include "core/project/records.h"
#include "core/tracking/background.h"
#include "core/tracking/robot_tracker.h"
#include "core/trajectory/live_track.h"
#include "core/workflow/track/task_analysis.h"

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace odo {

/// A view's picture with what the tracker saw in it: an observation a robot, stamped with when the picture
/// was taken by this machine's steady clock.
struct LiveSight
{
    std::size_t view = 0;
    TimedFrame picture;
    std::vector<Observation> observations;
};

/// A robot's place, and how long after the pictures that show it were taken it was known.
struct LiveMoment
{
    std::size_t robot = 0;
    LivePosition position; ///< its time is by this machine's steady clock
    double latencyS = 0;
};

/// How live tracking keeps up.
struct LiveFigures
{
    std::uint64_t tracked = 0,
                  dropped = 0; ///< pictures of all views; dropped: tracking was too slow for them
    double latencyMedianS = 0,
           latencyP99S = 0; ///< of the last ten seconds' positions, from exposure; 0 of none
};
/// "the map is 38 ms behind, none skipped"; empty while nothing has been placed.
Message liveWords(const LiveFigures &figures);

/// What live tracking has seen of a robot in a run: enough for the ordinary analysis.
struct LiveRun
{
    RobotRecord robot;
    std::vector<ViewTrack> views; ///< registered ones; times since the run's beginning
};
/// The run's figures by the ordinary analysis, from what was seen live: they stand until the recording itself
/// has been tracked, which misses no picture. Errors: those of analyse(). Any thread.
Result<TaskAnalysis> analyseRun(const LiveRun &run, const AnalysisOptions &options,
                                const std::optional<TaskRecord> &task);

/// Tracks robots in live views while they drive: a thread a view, which takes its pictures from a queue that
/// drops the oldest one where tracking is too slow. A recording does not come this way, so that it loses
/// nothing.
class LiveTracker
{
public:
    using Feed = std::shared_ptr<BoundedQueue<TimedFrame>>;
    /// Called on the views' threads, one at a time; must be quick.
    struct Listener
    {
        std::function<void(const LiveSight &)> sight;
        std::function<void(const LiveMoment &)> moment;
    };

    /// One feed a view. Without robots the pictures are only passed on. Errors: those of
    /// ColourTracker::create.
    static Result<std::unique_ptr<LiveTracker>> create(const std::vector<LiveView> &views,
                                                       const std::vector<RobotRecord> &robots,
                                                       std::vector<Feed> feeds, Listener listener);
    /// Closes the feeds and waits.
    ~LiveTracker();
    LiveTracker(const LiveTracker &) = delete;
    LiveTracker &operator=(const LiveTracker &) = delete;

    LiveFigures figures() const;
    /// A run has begun at this time of the steady clock, up to ten seconds ago: what is seen from then on is
    /// kept.
    void beginRun(Nanoseconds from);
    /// What was seen since then, a run for each robot. Nothing is kept any more.
    std::vector<LiveRun> endRun();

private:
    struct View
    {
        LiveView view;
        Feed feed;
        std::unique_ptr<RobotTracker> tracker;     ///< of the view's thread
        std::optional<LiveBackground> background;  ///< likewise; where a robot of any look is followed
        std::vector<std::deque<Observation>> kept; ///< of each robot
        std::thread thread;
    };
    LiveTracker(const std::vector<LiveView> &views, const std::vector<RobotRecord> &robots,
                Listener listener);
    void follow(std::size_t view);
    void place(LiveSight sight);
    void keep(std::size_t view, const LiveSight &sight);

    const std::vector<RobotRecord> m_robots;
    const Listener m_listener;
    std::vector<View> m_views;

    mutable std::mutex m_mutex;      ///< guards what follows, and the views' kept observations
    std::vector<LiveTrack> m_tracks; ///< of each robot
    std::optional<Nanoseconds> m_runFrom;
    std::uint64_t m_tracked = 0;
    std::deque<std::pair<Nanoseconds, double>> m_latencies; ///< when, and how long in seconds
};

} // namespace odo
