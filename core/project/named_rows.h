// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <string>

namespace odo {

struct ProjectConnection;

/// The id of the row of that name in a table that has only names (class, task), made when it is new.
/// 0 for an empty name.
Result<RecordId> idOfName(ProjectConnection &connection, const std::string &table, const std::string &name);

} // namespace odo
