// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/calibration_file.h"
#include "core/exchange/internal/yaml_document.h"

#include <string>
#include <vector>

namespace odo {

/// One camera of a calibration file.
struct CalibrationEntry
{
    std::string key, name; ///< as the file calls it; both empty where it holds one camera only
    const YamlNode *node = nullptr;
};

/// The cameras that a tree holds: the root, or what lies up to two levels below it and has a camera matrix.
/// The root where there is none: reading it names what is missing.
std::vector<CalibrationEntry> calibrationEntries(const YamlNode &root);

/// Reads one of them. The entries have the names that ROS, OpenCV, Kalibr, anipose, Pose2Sim and PhotonVision
/// give them, in upper or lower case. Errors as readCalibrationFile's.
Result<ImportedIntrinsics> readCalibrationEntry(const std::filesystem::path &file,
                                                const CalibrationEntry &entry);

/// "use a calibration file …", as advice.
Message useCalibrationFile();

} // namespace odo
