// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

struct ProjectConnection;

/// Whether each stored task can be used as it is stored. One that cannot (a gate further away than a floor
/// reaches, say) is read without its gates, path, zones and limits, so that the rest of the project can be
/// used.
Result<void> checkStoredTasks(const ProjectConnection &connection);

} // namespace odo
