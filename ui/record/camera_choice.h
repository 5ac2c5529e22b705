// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/project/records.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// A camera of the project and the address of the device that it is; empty: it is not used.
using ChosenCamera = std::pair<std::string, std::string>;

/// Which device each camera of a project is: the one told in the project, or chosen before on this machine, where it is
/// connected and free, with what is wanted of it; else a simulated one of its name while no real one is
/// there, else the real ones that are left, in their order. A project without cameras gets "A", "B", ... for
/// those that are connected, two at most.
std::vector<ChosenCamera> proposeCameras(const std::vector<CameraRecord> &cameras,
                                         const std::vector<CameraDescription> &connected,
                                         const std::map<std::string, std::string> &before);

/// Remembered on this machine, by the cameras' names.
std::map<std::string, std::string> rememberedCameras();
void rememberCameras(const std::vector<ChosenCamera> &cameras);

} // namespace odo
