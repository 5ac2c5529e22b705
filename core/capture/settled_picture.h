// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/capture/camera_source.h"

namespace odo {

/// One picture of a camera that was just opened, as soon as it has settled: the first ones of a webcam are
/// dark, its exposure is being found. Takes half a second at least; a camera that is not there for the moment
/// is waited for some three. Any thread. Errors: those of the camera; Cancelled.
Result<Frame> settledPicture(CameraSource &camera, const JobControl &control);

} // namespace odo
