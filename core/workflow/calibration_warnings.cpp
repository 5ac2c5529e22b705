// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibration_warnings.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

std::string sizeText(int width, int height)
{
    return std::to_string(width) + "×" + std::to_string(height);
}

void warnOfAge(const std::string &what, Instant made, Instant now, std::chrono::days oldAfter, const char *advice,
               std::vector<std::string> &warnings)
{
    const auto age = std::chrono::floor<std::chrono::days>(now - made);
    if (age > oldAfter)
        warnings.push_back(what + " is " + std::to_string(age.count()) + " days old: " + advice + ".");
}

} // namespace

Result<std::vector<std::string>> calibrationWarnings(Project &project, const CameraRecord &camera, Instant now,
                                                     std::chrono::days oldAfter)
{
    const auto intrinsics = project.cameras().currentIntrinsics(camera.id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    const auto registration = project.cameras().currentRegistration(camera.id);
    if (!registration)
        return tl::unexpected(registration.error());
    const auto recording = project.trials().newestRecording(camera.id);
    if (!recording)
        return tl::unexpected(recording.error());
    std::vector<std::string> warnings;
    const std::string name = "camera '" + camera.name + "'";
    if (!*intrinsics) {
        warnings.push_back("The lens of " + name + " was never calibrated, its distortion is taken as none: calibrate it.");
    } else {
        warnOfAge("The lens calibration of " + name, (*intrinsics)->made, now, oldAfter,
                  "if zoom, focus or the camera's settings were touched since, calibrate it again", warnings);
        const Intrinsics &lens = (*intrinsics)->calibration.intrinsics;
        if (*recording && ((*recording)->widthPx != lens.widthPx || (*recording)->heightPx != lens.heightPx))
            warnings.push_back("The newest recording of " + name + " is " +
                               sizeText((*recording)->widthPx, (*recording)->heightPx) + ", its lens was calibrated at " +
                               sizeText(lens.widthPx, lens.heightPx) + ": calibrate it at the size it records.");
    }
    if (!*registration)
        return warnings;
    warnOfAge("The floor registration of " + name, (*registration)->made, now, oldAfter,
              "check that the camera has not moved, or register it again", warnings);
    if (*intrinsics && (*registration)->intrinsics != (*intrinsics)->id)
        warnings.push_back("The floor registration of " + name + " was made " +
                           ((*registration)->intrinsics == 0 ? "before its lens was calibrated"
                                                             : "with another calibration of its lens than the one in force") +
                           ": register it again.");
    return warnings;
}

} // namespace odo
