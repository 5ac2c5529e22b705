// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "core/capture/synchroniser.h"

#include <deque>
#include <mutex>
#include <vector>

namespace odo {

/// Pairs the pictures of live cameras, and watches how well the views are in step. Any thread.
class FramePairing
{
public:
    explicit FramePairing(Synchroniser::Settings settings);

    void add(std::size_t view, TimedFrame frame, Nanoseconds now);
    PairHealth health(Nanoseconds now) const;

private:
    struct PairError
    {
        Nanoseconds at;
        double errorS;
    };

    const Nanoseconds m_tolerance;
    mutable std::mutex m_mutex; ///< guards what follows
    Synchroniser m_synchroniser;
    std::deque<PairError> m_recent;
    std::uint64_t m_pairs = 0, m_unpaired = 0;
};

/// How the pictures of several views pair, by when they were taken; each view's in order.
PairFigures pairFigures(const std::vector<std::vector<Nanoseconds>> &takenOfViews, Nanoseconds tolerance);

} // namespace odo
