// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <optional>

namespace odo {

/// What is known of how a robot looks.
struct RobotAppearance
{
    std::optional<RgbColour> colour = {}; ///< none: it may have any look
    std::optional<double> lengthM = {}, widthM = {}, heightM = {};
};

} // namespace odo
