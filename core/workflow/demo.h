// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <filesystem>

namespace odo {

/// Makes the demo lesson in a folder: demo.odo with a simulated class whose cameras are calibrated and
/// registered from simulated images (kept in calibration/), its trials' videos (demo.media/), and their known
/// truth (truth/). The trials are tracked. Nothing is left behind when it fails. May run on any thread; opens
/// the project for itself. Gives the project's file. AlreadyExists where the folder holds a demo.
Result<std::filesystem::path> makeDemo(const std::filesystem::path &folder, const JobControl &control);

} // namespace odo
