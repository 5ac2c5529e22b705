// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_watch.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace odo {

V4l2Watch::V4l2Watch()
    : m_wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), m_nodes(inotify_init1(IN_CLOEXEC | IN_NONBLOCK))
{
    // A node may be used only once its owner was set.
    inotify_add_watch(m_nodes, "/dev", IN_CREATE | IN_ATTRIB | IN_MOVED_TO);
}

V4l2Watch::~V4l2Watch()
{
    close(m_nodes);
    close(m_wake);
}

void V4l2Watch::stop()
{
    m_stopped = true;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written =
        ::write(m_wake, &one, sizeof one); // fails only when it is awake already
}

void V4l2Watch::forgetChanges() const
{
    std::array<char, 4096> events{};
    while (read(m_nodes, events.data(), events.size()) > 0) {
    }
}

bool V4l2Watch::wait(int camera, std::chrono::steady_clock::time_point until)
{
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
    std::array<pollfd, 2> waiting{{{m_wake, POLLIN, 0}, {camera < 0 ? m_nodes : camera, POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), static_cast<int>(std::max<std::int64_t>(left, 0)));
    if (camera >= 0)
        return (waiting[1].revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
    forgetChanges();
    return true;
}

} // namespace odo
