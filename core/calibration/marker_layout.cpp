// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_layout.h"

namespace odo {

Message labelEachMarker()
{
    return ODO_TEXT("calibration.label_each_marker", "give each marker a label of its own");
}

Message labelEachPoint()
{
    return ODO_TEXT("calibration.label_each_point", "give each point a label of its own");
}

} // namespace odo
