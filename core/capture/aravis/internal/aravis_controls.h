// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/aravis/internal/aravis_library.h"
#include "core/capture/camera_source.h"

namespace odo {

/// What can be set at a camera, by the names of GenICam's SFNC: those of exposure, gain, white balance, black
/// level and gamma that it has. On the camera's thread.
std::vector<CameraControl> readAravisControls(ArvCamera *camera);

/// Errors: those of CameraSource::set.
Result<void> setAravisControl(ArvCamera *camera, const std::string &uri, const std::string &id, double value);

/// What has to be set for the camera to stay as it is, in order: the automatics off, then the values they
/// have left.
struct HeldAutomatics
{
    std::vector<std::pair<std::string, double>> settings;
    std::vector<std::pair<std::string, double>> automatics; ///< those that were on, with their values
    std::vector<Message> notHeld;                           ///< names
};
HeldAutomatics holdAravisAutomatics(ArvCamera *camera);

/// What is not held while the camera cannot be asked.
Message exposureAndGain();

/// The failure of one that does not answer.
tl::unexpected<Error> noAnswer(const std::string &uri);

} // namespace odo
