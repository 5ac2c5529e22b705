// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

namespace odo {

struct ProjectConnection;

/// The pictures of a calibration as rows, used and rejected ones; CameraRepository's part of them. The record has its id.
Result<void> addCalibrationPictures(ProjectConnection &connection, const IntrinsicsRecord &record);
Result<void> readCalibrationPictures(const ProjectConnection &connection, IntrinsicsRecord &into);

} // namespace odo
