// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/workflow/record/live_tracking.h"
#include "core/workflow/record/record_trial.h"
#include "core/workflow/record/run_control.h"

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

namespace odo {

/// What is followed while a trial is recorded without a window, and why.
struct Followed
{
    std::vector<LiveView> views;
    std::vector<RobotRecord> robots;
    std::vector<std::optional<FloorArea>> areas; ///< of each view, where motion on the floor counts
    std::unique_ptr<LiveBroadcast> broadcast;    ///< to which their positions are sent
    bool isNeeded() const { return !views.empty(); }
};

/// Reads it, before a camera is opened. robots: those of the trial, an error only where they are needed. On
/// the project's thread. Errors: Undetermined where no camera is registered; InvalidInput and NotFound for a
/// start or an end that the task does not have; those of LiveBroadcast::create.
Result<Followed> readFollowed(Project &project, const Result<std::vector<RobotRecord>> &robots,
                              const RecordSettings &settings);

/// Follows the robots and the floor in running cameras, and sends the positions. Ends before the session
/// does.
class LiveFollowing
{
public:
    /// Nothing is followed where nothing needs it.
    static Result<std::unique_ptr<LiveFollowing>> begin(Followed followed, CaptureSession &session);

    /// Gives a run what was seen since, and the time. What is to be done now, if anything.
    std::optional<RunOrder> advance(RunControl &control);

private:
    using Seen = std::variant<LiveMoment, MotionSight>;
    explicit LiveFollowing(Followed followed);
    void take(const LiveSight &sight);
    void add(Seen seen);

    Followed m_followed;
    std::vector<std::optional<FloorMotion>> m_floors; ///< of each view; the tracker's threads, one at a time
    std::mutex m_mutex;                               ///< guards what follows
    std::deque<Seen> m_seen;
    std::unique_ptr<LiveTracker> m_tracker; ///< last, so that it ends first
};

} // namespace odo
