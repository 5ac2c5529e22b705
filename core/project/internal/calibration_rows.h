// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"
#include "core/project/records.h"

namespace odo {

struct ProjectConnection;

/// The images of a calibration as rows, used and rejected ones; CameraRepository's part of them. The record
/// has its id.
Result<void> addCalibrationImages(ProjectConnection &connection, const IntrinsicsRecord &record);
Result<void> readCalibrationImages(const ProjectConnection &connection, IntrinsicsRecord &into);

/// Intrinsics as rows of the table "lens", which calibrations and registrations refer to.
Result<RecordId> storeIntrinsics(ProjectConnection &connection, const Intrinsics &intrinsics);
Result<Intrinsics> lens(const ProjectConnection &connection, RecordId id);

} // namespace odo
