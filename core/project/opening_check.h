// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

class Migrator;
struct ProjectConnection;

/// Looks through a project's file before anything is written to it, for it may come from anyone, and gives
/// the version of its schema: the file holds that schema and nothing else, and all of it is whole, unless it
/// is so large that reading it would take long. The schema comes first, for looking through the rest
/// evaluates the checks in it; all of it is read as it was at one moment. A file made so that looking through it does not end is given up. On the
/// connection's thread. Errors: NewerFormat, InvalidInput (damaged, or not a project's tables), Io where the
/// disk does not give what is in the file.
Result<int> checkContent(ProjectConnection &connection, const Migrator &migrator);

} // namespace odo
