// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QString>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// The id of the row of that name in a table that has only names (class, task), made when it is new.
/// 0 for an empty name.
Result<RecordId> idOfName(ProjectConnection &connection, const std::string &table, const std::string &name);

/// The first column of every row that a statement gives, as texts.
Result<std::vector<std::string>> textsOf(const ProjectConnection &connection, const QString &sql);

/// Runs a statement whose only parameter is an id.
Result<void> runFor(const ProjectConnection &connection, const char *sql, RecordId id);

} // namespace odo
