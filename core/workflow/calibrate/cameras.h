// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_file.h"
#include "core/project/records.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// The camera of this name, made when the project has none of that name: whoever brings its pictures,
/// intrinsics or videos need not announce it first.
Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name);

/// Reads a ROS camera_info or OpenCV YAML file and stores it as the camera's newest intrinsics.
Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file);

/// Writes the camera's intrinsics in force; the format follows the file's name (.yml OpenCV, otherwise ROS).
Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target);

/// Stores a registration as the newest one of a camera, which is made when the project has none of that name,
/// and stamps it with the time of now and the version of the program. For a job's commit, inside its
/// transaction; gives back what is stored.
Result<RegistrationRecord> storeRegistration(Project &project, const std::string &camera,
                                             RegistrationRecord record);

/// As storeRegistration, for one that was computed anew from older markers, which say nothing of where the
/// camera stands now: what the last check of the one before found still holds.
Result<RegistrationRecord> storeFromOldMarkers(Project &project, const std::string &camera,
                                               RegistrationRecord record,
                                               const std::optional<RegistrationCheck> &lastCheck);

/// A camera with its registration in force.
struct RegisteredCamera
{
    CameraRecord camera;
    RegistrationRecord registration;
};

/// The cameras whose registration in force was made with this layout. Project's thread.
Result<std::vector<RegisteredCamera>> camerasOnLayout(Project &project, RecordId layout);

/// The registration in force of a camera by name. NotFound where it has none, with what to do.
Result<RegisteredCamera> registeredCamera(Project &project, const std::string &camera);

} // namespace odo
