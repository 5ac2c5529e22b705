// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>

namespace odo {

/// A queue between one or more producing and one or more consuming threads, with a fixed capacity and an end.
/// Every member may be called from any thread. A queue to the disk is filled with push (which waits) or
/// tryPush (which returns false when it is full), a queue to the screen with pushOrDrop (which never waits
/// and counts what it threw away).
template <class T>
class BoundedQueue
{
public:
    explicit BoundedQueue(std::size_t capacity) : m_capacity(capacity) {}

    /// Waits for room. False when the queue was closed: the value was not taken.
    bool push(T value)
    {
        std::unique_lock lock(m_mutex);
        m_spaceOrClosed.wait(lock, [this] { return m_closed || m_values.size() < m_capacity; });
        if (m_closed)
            return false;
        m_values.push_back(std::move(value));
        m_valueOrClosed.notify_one();
        return true;
    }

    /// Never waits. False when it is full or was closed: the value was not taken.
    bool tryPush(T value)
    {
        const std::lock_guard lock(m_mutex);
        if (m_closed || m_values.size() == m_capacity)
            return false;
        m_values.push_back(std::move(value));
        m_valueOrClosed.notify_one();
        return true;
    }

    /// Never waits: drops the oldest value when full, and counts it. False when the queue was closed.
    bool pushOrDrop(T value)
    {
        const std::lock_guard lock(m_mutex);
        if (m_closed)
            return false;
        if (m_values.size() == m_capacity) {
            m_values.pop_front();
            ++m_dropped;
        }
        m_values.push_back(std::move(value));
        m_valueOrClosed.notify_one();
        return true;
    }

    /// Waits for a value; nullopt once the queue is closed and empty.
    std::optional<T> pop()
    {
        std::unique_lock lock(m_mutex);
        m_valueOrClosed.wait(lock, [this] { return m_closed || !m_values.empty(); });
        if (m_values.empty())
            return std::nullopt;
        T value = std::move(m_values.front());
        m_values.pop_front();
        m_spaceOrClosed.notify_one();
        return value;
    }

    /// The end: no further value is taken, what is inside can still be popped, all who wait wake up.
    void close()
    {
        const std::lock_guard lock(m_mutex);
        m_closed = true;
        m_spaceOrClosed.notify_all();
        m_valueOrClosed.notify_all();
    }

    std::uint64_t dropped() const
    {
        const std::lock_guard lock(m_mutex);
        return m_dropped;
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_spaceOrClosed, m_valueOrClosed;
    std::deque<T> m_values;
    const std::size_t m_capacity;
    std::uint64_t m_dropped = 0;
    bool m_closed = false;
};

} // namespace odo
