// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"

#include <vector>

namespace odo {

/// Whether what the views see is only a mark at the robot's top (a cap, a ball on a mast) and not a body that reaches
/// down to the floor: the outline is then shorter than half of what a body of that height would span in the picture,
/// from its foot to its top. Median over all sightings; false where there is none.
bool isMarkAtTop(const std::vector<ViewTrack> &views, double heightM);

} // namespace odo
