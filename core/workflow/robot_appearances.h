// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/simulation/robot_appearance.h"

#include <vector>

namespace odo {

/// What simulated cameras are to show of a project's robots.
std::vector<RobotAppearance> appearancesOf(const std::vector<RobotRecord> &robots);

} // namespace odo
