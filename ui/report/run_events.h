// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <QString>
#include <vector>

namespace odo {

/// Something of a run that a report names: its number stands on the map, on the charts and in a list.
struct RunEvent
{
    enum class Kind { Motion, Gate, TopSpeed, Spike };
    Kind kind = Kind::Motion;
    int number = 0; ///< from 1
    Nanoseconds time{0};
    Nanoseconds until{0};     ///< of spikes in a row the last one's; else as time
    Eigen::Vector2d position; ///< on the floor
    QString words;
};

/// Start and end of the motion, the gates passed, the top speed, and the spikes (those in a row as one), in
/// the order of time. Where that is more than `most`, spikes are left out first, those of the fewest samples
/// before others, then gates.
std::vector<RunEvent> runEvents(const Profile &profile, std::size_t most);

} // namespace odo
