// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"
#include "core/project/records.h"

namespace odo {

struct ProjectConnection;

/// Intrinsics as rows of the table "lens", which calibrations and registrations refer to.
Result<RecordId> addLens(ProjectConnection &connection, const Intrinsics &intrinsics);
Result<Intrinsics> lens(const ProjectConnection &connection, RecordId id);

} // namespace odo
