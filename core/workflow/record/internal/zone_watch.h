// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"
#include "core/trajectory/live_track.h"

#include <optional>

namespace odo {

/// A robot's reference point has crossed the edge of a zone.
struct ZoneCrossing
{
    bool entered = false; ///< else it has left
    Nanoseconds time{0};  ///< on the edge, between two positions in proportion to their distance from it
};

/// Reports while a robot drives when it enters and leaves a zone. Noise is no crossing: it is within, or
/// without, once it is so by three standard deviations of its position and 5 mm at least. Not thread-safe.
class ZoneWatch
{
public:
    explicit ZoneWatch(Zone zone) : m_zone(std::move(zone)) {}

    /// The next position in order of time. The crossing that it makes certain, if it does.
    std::optional<ZoneCrossing> add(const LivePosition &position);
    /// Where it was before counts no more.
    void forget();

private:
    struct Distance
    {
        Nanoseconds time{0};
        double m = 0; ///< to the edge, positive within
    };
    Zone m_zone;
    std::optional<Distance> m_last;
    std::optional<bool> m_isInside;
    Nanoseconds m_onEdge{0}; ///< when it was there last
};

} // namespace odo
