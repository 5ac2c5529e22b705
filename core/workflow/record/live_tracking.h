// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/base/platform/datagram_socket.h"
#include "core/capture/synchroniser.h"
#include "core/exchange/ssl_vision.h"
#include "core/project/records.h"
#include "core/tracking/background.h"
#include "core/tracking/robot_tracker.h"
#include "core/trajectory/live_track.h"
#include "core/workflow/track/view_tracking.h"

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace odo {

/// A view's frame with what the tracker saw in it: an observation a robot, stamped with when the frame was
/// taken by this machine's steady clock.
struct LiveSight
{
    std::size_t view = 0;
    TimedFrame timedFrame;
    std::vector<Observation> observations;
};

/// A robot's position, and how long after its frames were taken it was known.
struct LiveMoment
{
    std::size_t robot = 0;
    LivePosition position; ///< its time is by this machine's steady clock
    double latencyS = 0;
};

/// How live tracking keeps up.
struct LiveStatistics
{
    std::uint64_t tracked = 0,
                  dropped = 0; ///< frames of all views; dropped: tracking was too slow for them
    double latencyMedianS = 0,
           latencyP99S = 0; ///< of the last ten seconds' positions, from exposure; 0 of none
};
/// "the map is 38 ms behind, none skipped"; empty while nothing has been placed.
Message liveWords(const LiveStatistics &statistics);

/// What live tracking has seen of a robot in a run: enough for the ordinary analysis.
struct LiveRun
{
    RobotRecord robot;
    std::vector<ViewTrack> views; ///< registered ones; times since the run's beginning
};
/// The run's metrics by the ordinary analysis, from the live tracks: valid until the recording itself has
/// been tracked, without lost frames. Errors: those of analyse(). Any thread.
Result<TaskAnalysis> analyseRun(const LiveRun &run, const AnalysisOptions &options,
                                const std::optional<TaskRecord> &task);

/// Tracks robots in live views while they drive: a thread a view, which takes its frames from a queue that
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

    /// One feed a view. Without robots the frames are only passed on. Errors: those of ColourTracker::create.
    static Result<std::unique_ptr<LiveTracker>> create(const std::vector<LiveView> &views,
                                                       const std::vector<RobotRecord> &robots,
                                                       std::vector<Feed> feeds, Listener listener);
    /// Closes the feeds and waits.
    ~LiveTracker();
    LiveTracker(const LiveTracker &) = delete;
    LiveTracker &operator=(const LiveTracker &) = delete;

    LiveStatistics statistics() const;
    /// A run started at this time of the steady clock, up to 33 seconds ago: what is seen from then on is
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
    void locate(LiveSight sight);
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

/// Where live positions are sent to. By default they do not leave this computer.
struct BroadcastTarget
{
    std::string address = "224.5.23.2"; ///< IPv4, a multicast group or one machine
    std::uint16_t port = 10006;
    std::string interface = "lo"; ///< by its name; of a multicast group
    bool operator==(const BroadcastTarget &) const = default;
};
/// Reads "ADDRESS:PORT", "ADDRESS" or nothing (the default); the interface stays that of `target`.
/// InvalidInput for anything else.
Result<BroadcastTarget> parseBroadcastTarget(const std::string &text, BroadcastTarget target = {});
/// Whether an IPv4 address is that of a multicast group (224.0.0.0 to 239.255.255.255).
bool isMulticastGroup(const std::string &address);

/// Which robots are sent as yellow and which as blue: a colour whose hue is nearer to yellow's than to blue's
/// (from 330° over red, yellow and green to 150°), or none (grey), is yellow. Ids count the robots of each
/// from 0, in their order.
struct SslNumber
{
    bool isYellow = true;
    std::uint32_t id = 0;
};
std::vector<SslNumber> sslNumbers(const std::vector<RobotRecord> &robots);

/// Sends what a LiveTracker finds as SSL-Vision packets, one for each moment at which robots are known. A
/// thread of its own sends; whoever gives it moments never waits: where the network is too slow the oldest
/// are dropped.
class LiveBroadcast
{
public:
    /// InvalidInput for an invalid address, port or interface; Io if no socket can be opened.
    static Result<std::unique_ptr<LiveBroadcast>> create(const BroadcastTarget &target,
                                                         const std::vector<RobotRecord> &robots);
    /// Sends what waits, and ends.
    ~LiveBroadcast();
    LiveBroadcast(const LiveBroadcast &) = delete;
    LiveBroadcast &operator=(const LiveBroadcast &) = delete;

    /// Never waits; from one thread at a time, as a LiveTracker's listener is called.
    void take(const LiveMoment &moment);

    struct BroadcastStatistics
    {
        /// packets; failed: the network refused them; dropped: moments of a robot
        std::uint64_t sent = 0, failed = 0, dropped = 0;
    };
    BroadcastStatistics statistics() const;

private:
    LiveBroadcast(DatagramSocket socket, std::uint32_t address, const BroadcastTarget &target,
                  const std::vector<RobotRecord> &robots);
    void sendAll();
    void addTo(SslFrame &frame, const LiveMoment &moment);
    void send(SslFrame &frame, Nanoseconds captured);

    const DatagramSocket m_socket;
    const std::uint32_t m_address;
    const BroadcastTarget m_target;
    const std::vector<RobotRecord> m_robots;
    const std::vector<SslNumber> m_numbers;
    std::vector<std::optional<double>> m_yaws; ///< of each robot, as it drove last; the thread's own
    std::uint32_t m_frame = 0;
    std::atomic<std::uint64_t> m_sent{0}, m_failed{0};
    BoundedQueue<LiveMoment> m_moments;
    std::thread m_thread;
};

} // namespace odo
