// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <string>

namespace odo {

class Project;

/// The team of that name; one without a class is added when there is none. Project's thread.
Result<TeamRecord> findOrAddTeam(Project &project, const std::string &name);

} // namespace odo
