// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tracking/painter.h"

#include <algorithm>
#include <random>

namespace odo::test {

/// A grey floor whose grain stays the same.
inline Painter texturedFloor(const FrameFormat &format)
{
    Painter floor(format);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(0, format.width), y(0, format.height), size(3, 12),
        shade(-14, 14);
    for (int i = 0; i < format.width * format.height / 60; ++i) {
        const Eigen::Vector2d low(x(random), y(random)),
            high = low + Eigen::Vector2d(size(random), size(random));
        const auto code = [&](int base, double by) {
            return static_cast<std::uint8_t>(std::clamp(base + by, 0.0, 255.0));
        };
        const double by = shade(random);
        floor.rectangle(low, high, {code(150, by), code(146, by), code(138, by)});
    }
    return floor;
}

} // namespace odo::test
