// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <vector>

namespace odo {

struct ProjectConnection;

/// Stores when it was ambiguous which robot an analysis is of, and reads it back in the same order. On
/// the connection's thread. Errors: those of the database; a robot that is not there.
Result<void> addAmbiguousNames(ProjectConnection &connection, RecordId analysis,
                               const std::vector<AmbiguousName> &ambiguities);
Result<std::vector<AmbiguousName>> readAmbiguousNames(const ProjectConnection &connection, RecordId analysis);

} // namespace odo
