// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/base/job_control.h"
#include "core/video/frame.h"

#include <filesystem>
#include <functional>
#include <string>

namespace odo {

/// By the ending of its name.
bool isStillPicture(const std::filesystem::path &file);

/// One picture of a file, whole: of a video the frame of this index, of a still the only one there is.
/// Errors: neither a picture nor a video; NotFound for a frame that it does not have.
Result<Frame> pictureOf(const std::filesystem::path &file, std::int64_t frame);

/// Gives the pictures of a file one after another, named "file" or "file@frame": one for a still, every step-th for a
/// video. Stops early when visit returns false. Errors: neither a picture nor a video; Cancelled.
Result<void> visitPictures(const std::filesystem::path &file, int videoStep,
                           const std::function<bool(const Frame &, const std::string &)> &visit, const CancelToken &cancel);

} // namespace odo
