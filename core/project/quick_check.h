// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

struct ProjectConnection;

/// Whether SQLite finds nothing wrong in a project's file, all of which it reads. Errors: those of reading it. The connection's thread.
Result<bool> passesQuickCheck(const ProjectConnection &connection);

} // namespace odo
