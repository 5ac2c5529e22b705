// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/live_tracking.h"

#include "core/base/percentile.h"
#include "core/base/shortage.h"
#include "core/base/steady_now.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/view_tracking.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds keptBeforeARun = 33s, latencyWindow = 10s;

/// Registered at another frame size, its positions would be silently wrong.
bool fits(const LiveView &view, const FrameFormat &format)
{
    const Intrinsics &intrinsics = view.floorView->camera().intrinsics();
    return intrinsics.widthPx == format.width && intrinsics.heightPx == format.height;
}

} // namespace

Message liveWords(const LiveStatistics &statistics)
{
    if (statistics.latencyMedianS <= 0)
        return {};
    const MessageArgument behind = quantity(std::round(1e3 * statistics.latencyMedianS), 0, "ms");
    return statistics.dropped == 0
               ? ODO_TEXT("workflow.map_behind", "the map is %1 behind, no frame skipped")(behind)
               : ODO_TEXT("workflow.map_behind_and_skipping",
                          "the map is %1 behind, %2 frames skipped")(behind, statistics.dropped);
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
    while (auto timedFrame = own.feed->pop()) {
        LiveSight sight{view, std::move(*timedFrame), {}};
        Frame &frame = sight.timedFrame.captured.frame;
        frame.time = sight.timedFrame.taken; // all views use one clock
        if (own.background) {
            if (auto newer = own.background->add(frame))
                own.tracker->setBackground(std::move(*newer));
        }
        if (own.tracker)
            sight.observations = own.tracker->track(frame);
        locate(std::move(sight));
    }
}

void LiveTracker::locate(LiveSight sight)
{
    const std::lock_guard lock(m_mutex);
    ++m_tracked;
    const LiveView &view = m_views[sight.view].view;
    const bool placed = view.floorView && fits(view, sight.timedFrame.captured.frame.format);
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

LiveStatistics LiveTracker::statistics() const
{
    const std::lock_guard lock(m_mutex);
    LiveStatistics statistics{m_tracked, 0, 0, 0};
    for (const View &view : m_views)
        statistics.dropped += view.feed->dropped();
    std::vector<double> latencies;
    for (const auto &[when, latencyS] : m_latencies)
        latencies.push_back(latencyS);
    statistics.latencyMedianS = percentile(latencies, 50);
    statistics.latencyP99S = percentile(std::move(latencies), 99);
    return statistics;
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

namespace {

constexpr std::size_t momentsAhead = 64;
constexpr double measuredConfidence = 1, predictedConfidence = 0.5;
constexpr double slowestWithHeading = 3; // standard deviations of the speed

std::string shown(const BroadcastTarget &target)
{
    return target.address + ":" + std::to_string(target.port);
}

Message addressSubject(const std::string &address)
{
    return ODO_TEXT("workflow.address_of_live_positions", "address '%1' of live positions")(address);
}

Message livePositionsTo(const BroadcastTarget &target)
{
    return ODO_TEXT("workflow.live_positions_to", "live positions to %1")(shown(target));
}

/// 0 at red, 120 at green; nullopt of a grey.
std::optional<double> hueOf(RgbColour colour)
{
    const double r = colour.red, g = colour.green, b = colour.blue;
    const double most = std::max({r, g, b}), spread = most - std::min({r, g, b});
    if (spread <= 0)
        return std::nullopt;
    const double sixths = most == r   ? std::fmod((g - b) / spread + 6, 6)
                          : most == g ? (b - r) / spread + 2
                                      : (r - g) / spread + 4;
    return 60 * sixths;
}

Result<std::uint32_t> addressOf(const BroadcastTarget &target)
{
    const auto address = ipv4Address(target.address);
    if (!address || target.port == 0)
        return fail(ErrorCode::InvalidInput, addressSubject(shown(target)),
                    ODO_TEXT("workflow.no_address_with_port", "it is not an IPv4 address with a port"),
                    ODO_TEXT("workflow.write_address", "write it like 224.5.23.2:10006"));
    return *address;
}

Result<void> setMulticast(const DatagramSocket &socket, const BroadcastTarget &target)
{
    const std::error_code problem = socket.sendMulticastBy(target.interface);
    if (problem == std::errc::no_such_device)
        return fail(ErrorCode::InvalidInput,
                    ODO_TEXT("workflow.interface_of_live_positions",
                             "interface '%1' of live positions")(target.interface),
                    ODO_TEXT("workflow.no_such_interface", "this computer has no interface of that name"),
                    ODO_TEXT("workflow.choose_interface",
                             "choose one that `ip link` lists, or lo to stay on this computer"));
    if (problem)
        return fail(
            ErrorCode::Io, livePositionsTo(target),
            ODO_TEXT("workflow.no_multicast", "interface '%1' does not support multicast")(target.interface),
            chooseAnotherOne());
    return {};
}

} // namespace

Result<BroadcastTarget> parseBroadcastTarget(const std::string &text, BroadcastTarget target)
{
    const std::size_t colon = text.find(':');
    if (!text.empty())
        target.address = text.substr(0, colon);
    if (colon != std::string::npos) {
        const char *begin = text.data() + colon + 1, *end = text.data() + text.size();
        const auto [stop, problem] = std::from_chars(begin, end, target.port);
        if (problem != std::errc() || stop != end)
            target.port = 0;
    }
    if (const auto address = addressOf(target); !address) {
        Error error = address.error();
        error.what = addressSubject(text);
        return tl::unexpected(error);
    }
    return target;
}

bool isMulticastGroup(const std::string &address)
{
    constexpr std::uint32_t prefixMask = 0xf0000000, groupPrefix = 0xe0000000;
    const auto parsed = ipv4Address(address);
    return parsed && (*parsed & prefixMask) == groupPrefix;
}

std::vector<SslNumber> sslNumbers(const std::vector<RobotRecord> &robots)
{
    std::vector<SslNumber> numbers;
    std::uint32_t yellow = 0, blue = 0;
    for (const RobotRecord &robot : robots) {
        const auto hue = robot.colour ? hueOf(*robot.colour) : std::nullopt;
        const bool isBlue = hue && *hue > 150 && *hue < 330;
        numbers.push_back({!isBlue, isBlue ? blue++ : yellow++});
    }
    return numbers;
}

Result<std::unique_ptr<LiveBroadcast>> LiveBroadcast::create(const BroadcastTarget &target,
                                                             const std::vector<RobotRecord> &robots)
{
    const auto address = ODO_TRY(addressOf(target));
    auto socket = DatagramSocket::open();
    if (!socket)
        return fail(ErrorCode::Io, livePositionsTo(target),
                    ODO_TEXT("workflow.no_socket", "the system could not open a socket"),
                    closeOtherPrograms());
    if (isMulticastGroup(target.address))
        ODO_TRY(setMulticast(*socket, target));
    std::unique_ptr<LiveBroadcast> broadcast(new LiveBroadcast(std::move(*socket), address, target, robots));
    auto thread = startThread(livePositionsTo(target), [&live = *broadcast] { live.sendAll(); });
    if (!thread)
        return tl::unexpected(thread.error());
    broadcast->m_thread = std::move(*thread);
    return broadcast;
}

LiveBroadcast::LiveBroadcast(DatagramSocket socket, std::uint32_t address, const BroadcastTarget &target,
                             const std::vector<RobotRecord> &robots)
    : m_socket(std::move(socket)), m_address(address), m_target(target), m_robots(robots),
      m_numbers(sslNumbers(robots)), m_yaws(robots.size()), m_moments(momentsAhead)
{
}

LiveBroadcast::~LiveBroadcast()
{
    m_moments.close();
    if (m_thread.joinable())
        m_thread.join();
}

void LiveBroadcast::take(const LiveMoment &moment)
{
    m_moments.pushOrDrop(moment);
}

LiveBroadcast::BroadcastStatistics LiveBroadcast::statistics() const
{
    return {m_sent, m_failed, m_moments.dropped()};
}

/// All robots of one moment go into one packet: a tracker tells them one after the other, the last one last.
void LiveBroadcast::sendAll()
{
    SslFrame frame;
    Nanoseconds at{0};
    while (const auto moment = m_moments.pop()) {
        if (moment->position.sample.time != at && !frame.robots.empty())
            send(frame, at); // the last one of the moment before was dropped
        at = moment->position.sample.time;
        addTo(frame, *moment);
        if (moment->robot + 1 == m_robots.size() && !frame.robots.empty())
            send(frame, at);
    }
    if (!frame.robots.empty())
        send(frame, at);
}

void LiveBroadcast::addTo(SslFrame &frame, const LiveMoment &moment)
{
    const ProfilePoint &point = moment.position.point;
    if (moment.robot >= m_robots.size() || !point.valid || !point.position.allFinite())
        return;
    auto &yaw = m_yaws[moment.robot];
    if (point.speedMps > slowestWithHeading * point.sigmaSpeedMps)
        yaw = std::atan2(point.velocity.y(), point.velocity.x());
    const bool isMeasured = moment.position.sample.position && !moment.position.isSpike;
    frame.robots.push_back({m_numbers[moment.robot].isYellow, m_numbers[moment.robot].id,
                            isMeasured ? measuredConfidence : predictedConfidence, point.position.x(),
                            point.position.y(), yaw, m_robots[moment.robot].heightM});
}

/// Empties the frame.
void LiveBroadcast::send(SslFrame &frame, Nanoseconds captured)
{
    const double nowS =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    frame.number = m_frame++;
    frame.sentS = nowS;
    frame.capturedS = nowS - toSeconds(steadyNow() - captured);
    ++(m_socket.send(sslVisionPacket(frame), m_address, m_target.port) ? m_sent : m_failed);
    frame.robots.clear();
}

} // namespace odo
