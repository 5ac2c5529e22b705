// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/pace.h"

namespace odo {

bool Pace::waitUntil(Nanoseconds time)
{
    std::unique_lock lock(m_mutex);
    if (!m_start)
        m_start = std::chrono::steady_clock::now() - time;
    if (m_kind == Kind::RealTime)
        m_wake.wait_until(lock, *m_start + time, [this] { return m_stopped; });
    return !m_stopped;
}

Nanoseconds Pace::lateness(Nanoseconds time) const
{
    return m_kind == Kind::RealTime ? std::chrono::steady_clock::now() - (*m_start + time) : Nanoseconds(0);
}

void Pace::stop()
{
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    m_wake.notify_all();
}

} // namespace odo
