// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/capture_health.h"
#include "core/capture/synchroniser.h"

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace odo {

/// Pairs the pictures of live cameras, gives the sets to who asked for them, and watches how well the views
/// are in step. Any thread.
class FramePairing
{
public:
    explicit FramePairing(Synchroniser::Settings settings);

    void add(std::size_t view, TimedFrame frame, Nanoseconds now);
    std::shared_ptr<BoundedQueue<FrameSet>> subscribe(std::size_t capacity);
    PairHealth health(Nanoseconds now) const;
    /// Gives out nothing more.
    void close();

private:
    struct PairError
    {
        Nanoseconds at;
        double errorS;
    };
    void giveOut(FrameSet set);

    const Nanoseconds m_tolerance;
    mutable std::mutex m_mutex; ///< guards what follows
    Synchroniser m_synchroniser;
    std::vector<std::shared_ptr<BoundedQueue<FrameSet>>> m_feeds;
    std::deque<PairError> m_recent;
    std::uint64_t m_pairs = 0, m_unpaired = 0;
    bool m_closed = false;
};

/// How the pictures of several views pair, by when they were taken; each view's in order.
PairFigures pairFigures(const std::vector<std::vector<Nanoseconds>> &takenOfViews, Nanoseconds tolerance);

} // namespace odo
