// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_guard.h"
#include "core/project/records.h"

#include <filesystem>
#include <optional>
#include <string>

namespace odo {

class Project;

/// The camera of this name, made when the project has none of that name: whoever brings its pictures, intrinsics or
/// videos need not announce it first.
Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name);

/// Reads a ROS camera_info or OpenCV YAML file and stores it as the camera's newest intrinsics.
Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file);

/// Writes the camera's intrinsics in force; the format follows the file's name (.yml OpenCV, otherwise ROS).
Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target);

} // namespace odo
