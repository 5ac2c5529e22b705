// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"

#include <cstddef>
#include <optional>

namespace odo {

/// The last point at or before a time; -1 before the first one, and where the profile does not know.
std::ptrdiff_t pointIndexAt(const Profile &profile, Nanoseconds time);

/// Direction of motion at a point, radians; while it stands, the one it had last. nullopt: it never moved
/// before.
std::optional<double> drivenHeadingAt(const Profile &profile, std::ptrdiff_t index);

} // namespace odo
