// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_project.h"

namespace odo::test {

/// One demand on the accuracy and what was measured; of all scenes together, or the worst scene's.
struct BarResult
{
    QString metric;
    double value = 0;
    double atLeast = 0, atMost = 0;
    QString where; ///< the scene that gave the value, where it is the worst one's

    bool isMet() const { return value >= atLeast && value <= atMost; }
};

/// Holds the measured scenes against what is demanded; a figure that no scene has is left out. Position,
/// velocity and acceleration: of every scene by itself, the worst is told (a scene with one view counts for
/// coverage only), and of all together. The rest: of all together. Scenes of robots of any look have bars of
/// their own.
std::vector<BarResult> judge(const std::vector<MeasuredScene> &scenes);

} // namespace odo::test
