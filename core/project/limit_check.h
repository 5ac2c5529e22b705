// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace odo {

struct ProjectConnection;

/// What a file holds beyond the limits (limits.h), which is cut or left out as it is read: only another program can have written it.
Result<std::vector<ProjectProblem>> beyondLimits(const ProjectConnection &connection);

} // namespace odo
