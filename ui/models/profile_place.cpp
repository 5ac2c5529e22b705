// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/profile_place.h"

#include <algorithm>
#include <cmath>

namespace odo {

std::ptrdiff_t pointIndexAt(const Profile &profile, Nanoseconds time)
{
    const auto after =
        std::upper_bound(profile.samples.begin(), profile.samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    const std::ptrdiff_t index = (after - profile.samples.begin()) - 1;
    return index >= 0 && profile.points[static_cast<std::size_t>(index)].valid ? index : -1;
}

std::optional<double> drivenHeadingAt(const Profile &profile, std::ptrdiff_t index)
{
    constexpr double standingMps = 0.05;
    for (; index >= 0; --index) {
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
        if (point.valid && point.speedMps > std::max(standingMps, 2 * point.sigmaSpeedMps))
            return std::atan2(point.velocity.y(), point.velocity.x());
    }
    return std::nullopt;
}

} // namespace odo
