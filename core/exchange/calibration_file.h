// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "core/geometry/camera_model.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

enum class IntrinsicsFormat {
    Ros,    ///< camera_info as camera_calibration writes it
    OpenCv, ///< as OpenCV's calibration samples write it
};

/// The contents of a calibration file.
struct ImportedIntrinsics
{
    Intrinsics intrinsics;
    std::string cameraName;               ///< empty where the file has none
    std::optional<double> reprojectionPx; ///< avg_reprojection_error, where the file has it
};

/// Reads the intrinsics of a camera from a file of another program, told apart by content: ROS camera_info
/// (YAML, INI, printed messages), OpenCV YAML or JSON, Kalibr, TOML of anipose, caliscope and Pose2Sim,
/// PhotonVision JSON. At most 1 MiB. entry: which of several cameras, by its name or key in the file. Errors,
/// with file and line: not such a file, a missing entry, wrong dimensions, values that are not finite or that
/// no camera has, a lens model that is not known, a skewed matrix, several cameras of which none is chosen.
/// Any thread.
Result<ImportedIntrinsics> readCalibrationFile(const std::filesystem::path &file,
                                               const std::string &entry = {});
/// The same for a text; `file` is only its name for messages.
Result<ImportedIntrinsics> parseCalibration(const std::filesystem::path &file, const std::string &text,
                                            const std::string &entry = {});
/// The intrinsics of a file alone.
Result<Intrinsics> readIntrinsics(const std::filesystem::path &file, const std::string &entry = {});

/// What the cameras of a file are called in it, one or more; of a file for one camera an empty text. Errors:
/// not such a file.
Result<std::vector<std::string>> camerasInCalibration(const std::filesystem::path &file);

/// The file's text in full precision: reading it gives the same numbers bit for bit.
std::string intrinsicsText(const std::string &cameraName, const Intrinsics &intrinsics,
                           IntrinsicsFormat format);

Result<void> writeIntrinsics(const OutputTarget &target, const std::string &cameraName,
                             const Intrinsics &intrinsics, IntrinsicsFormat format);
/// The format follows the extension: OpenCV for ".yml", ROS otherwise.
Result<void> writeIntrinsics(const OutputTarget &target, const std::string &cameraName,
                             const Intrinsics &intrinsics);

} // namespace odo
