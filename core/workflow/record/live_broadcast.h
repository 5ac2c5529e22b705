// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/exchange/ssl_vision.h"
#include "core/workflow/record/live_tracking.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace odo {

/// Where live positions are sent to. As it stands here they do not leave this machine.
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
    /// InvalidInput for an address, port or interface that there is not; Io where no socket is to be had.
    static Result<std::unique_ptr<LiveBroadcast>> create(const BroadcastTarget &target,
                                                         const std::vector<RobotRecord> &robots);
    /// Sends what waits, and ends.
    ~LiveBroadcast();
    LiveBroadcast(const LiveBroadcast &) = delete;
    LiveBroadcast &operator=(const LiveBroadcast &) = delete;

    /// Never waits; from one thread at a time, as a LiveTracker's listener is called.
    void take(const LiveMoment &moment);

    struct Figures
    {
        /// packets; failed: the network refused them; dropped: moments of a robot
        std::uint64_t sent = 0, failed = 0, dropped = 0;
    };
    Figures figures() const;

private:
    LiveBroadcast(int socket, const BroadcastTarget &target, const std::vector<RobotRecord> &robots);
    void sendAll();
    void addTo(SslFrame &frame, const LiveMoment &moment);
    void send(SslFrame &frame, Nanoseconds captured);

    const int m_socket;
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
