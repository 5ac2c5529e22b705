// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/floor_readings.h"

#include "core/exchange/labelled_points.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/shared_words.h"

namespace odo {

Result<FloorReading> floorReadingOf(Project &project, const RegistrationRecord &registration)
{
    const bool areIntrinsicsAssumed = registration.intrinsics == 0;
    Intrinsics lens = registration.assumedIntrinsics;
    if (!areIntrinsicsAssumed) {
        auto stored = ODO_TRY(project.cameras().intrinsics(registration.intrinsics));
        lens = std::move(stored.calibration.intrinsics);
    }
    const auto camera = ODO_TRY(CameraModel::create(std::move(lens)));
    return FloorReading(registration.registration, camera, registration.pixels, areIntrinsicsAssumed);
}

std::vector<std::string> LocatedPoints::outside() const
{
    std::vector<std::string> labels;
    for (const LocatedPoint &point : points) {
        const bool isInside = point.pixel.x() >= -0.5 && point.pixel.y() >= -0.5 &&
                              point.pixel.x() <= widthPx - 0.5 && point.pixel.y() <= heightPx - 0.5;
        if (!isInside)
            labels.push_back(point.label);
    }
    return labels;
}

Result<LocatedPoints> locatePoints(Project &project, const std::string &camera,
                                   const std::filesystem::path &pixelsFile, double heightM)
{
    const auto registered = ODO_TRY(registeredCamera(project, camera));
    const auto reading = ODO_TRY(floorReadingOf(project, registered.registration));
    const double cameraM = reading.view().cameraInWorld().z();
    if (!(heightM < cameraM))
        return fail(ErrorCode::InvalidInput, cameraSubject(camera),
                    ODO_TEXT("workflow.height_above_camera",
                             "it is only %1 above the floor, but the points would be at %2")(
                        quantity(cameraM, 2, "m"), quantity(heightM, 2, "m")),
                    ODO_TEXT("workflow.give_height_below_camera", "give a height below the camera"));
    const auto points = ODO_TRY(readPixelsCsv(pixelsFile));
    const Intrinsics &lens = reading.view().camera().intrinsics();
    return LocatedPoints{registered.registration.id,
                         registered.registration.intrinsics == 0,
                         reading.pixelSigmaPx(),
                         lens.widthPx,
                         lens.heightPx,
                         reading.located(points, heightM)};
}

} // namespace odo
