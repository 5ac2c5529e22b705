// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/video/frame.h"

#include <filesystem>
#include <functional>
#include <string>

namespace odo {

/// Gives the frames of a clip of a board that are worth a search, named "file@frame": of each quarter of a
/// second, or of each 240th part of a longer clip, the frame with the sharpest edges. So motion blur is
/// passed over where the hand was still for a moment, and the rate of the frames does not matter. Stops early
/// when visit returns false. Errors: no video; Cancelled.
Result<void> visitSharpestFrames(const std::filesystem::path &file,
                                 const std::function<bool(const Frame &, const std::string &)> &visit,
                                 const CancelToken &cancel);

/// The mean square of the steps from pixel to pixel of every other row: of frames of one scene, the larger
/// the sharper.
double edgeStrength(const Frame &frame);

} // namespace odo
