// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/robot_appearances.h"

namespace odo {

std::vector<RobotAppearance> appearancesOf(const std::vector<RobotRecord> &robots)
{
    std::vector<RobotAppearance> appearances;
    for (const RobotRecord &robot : robots)
        appearances.push_back({robot.colour, robot.lengthM, robot.widthM, robot.heightM});
    return appearances;
}

} // namespace odo
