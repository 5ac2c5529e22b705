// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_reading.h"
#include "core/project/records.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

class Project;

/// A camera ready to read floor positions, from its stored registration and the lens that it was made with.
/// Project's thread.
Result<FloorReading> floorReadingOf(Project &project, const RegistrationRecord &registration);

/// Floor positions of image points of one camera.
struct LocatedPoints
{
    RecordId registration = 0;
    bool areIntrinsicsAssumed = false; ///< the registration was made without a lens calibration
    double pixelSigmaPx = 0;           ///< of a coordinate of a pixel, as it counts in the σ
    int widthPx = 0, heightPx = 0;
    std::vector<LocatedPoint> points;

    std::vector<std::string> outside() const; ///< labels of points that are not in the image
};

/// Reads label,u,v (readPixelsCsv) and locates each point on the plane z = heightM, by the camera's
/// registration in force. NotFound where the camera is not registered; InvalidInput for a plane that is not
/// below the camera. Project's thread; quick.
Result<LocatedPoints> locatePoints(Project &project, const std::string &camera,
                                   const std::filesystem::path &pixelsFile, double heightM);

} // namespace odo
