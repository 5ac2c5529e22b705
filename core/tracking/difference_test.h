// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace odo {

/// When a pixel differs from its background: by at least one of these steps, and by more than this sum of squares in units of the noise.
inline constexpr float differsInSigmas2 = 20;
inline constexpr float leastLumaStep = 6, leastChromaStep = 3.5F; ///< code values

inline float squared(float value)
{
    return value * value;
}

} // namespace odo
