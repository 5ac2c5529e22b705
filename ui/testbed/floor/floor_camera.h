// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "core/project/records.h"
#include "ui/models/number_text.h"

#include <Eigen/Core>
#include <QString>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What a registration needs to know of a camera.
struct FloorCamera
{
    QString name;
    std::optional<IntrinsicsRecord> intrinsics;           ///< in force
    std::optional<std::filesystem::path> newestRecording; ///< in which the markers may be seen
    Badge badge = {};                                     ///< of the registration in force
};

/// A registered camera, as the checks take it.
struct CheckCamera
{
    QString name;
    FloorView view;
    MarkerLayout layout; ///< it is registered by
    std::optional<std::filesystem::path> newestRecording;
    std::string deviceUri = {};           ///< may be empty
    Badge badge = {};                     ///< how far it can be relied on
    RegistrationRecord registration = {}; ///< of the view, to convert it to images of another size
};

// What all drawings of a testbed's floor have in common.

inline constexpr double floorGridM = 0.5;
inline constexpr double floorGrabPx = 12; ///< as near as this a press takes hold of something

/// Where the grid has lines between two coordinates. None where they would be all that is to be seen, as of a
/// layout in a wrong unit.
inline std::vector<double> floorGridLines(double fromM, double toM)
{
    constexpr double mostLines = 200;
    std::vector<double> lines;
    if (!((toM - fromM) / floorGridM <= mostLines)) // nor of what is no number
        return lines;
    for (double line = std::ceil(fromM / floorGridM);
         line * floorGridM <= toM + 1e-9 && lines.size() <= mostLines; ++line)
        lines.push_back(line * floorGridM);
    return lines;
}

/// Where something that is dragged comes to lie: on whole centimetres of the world, in metres.
inline Eigen::Vector2d onDragStep(const Eigen::Vector2d &point)
{
    constexpr double stepM = 0.01;
    return stepM * (point / stepM).array().round().matrix();
}

} // namespace odo
