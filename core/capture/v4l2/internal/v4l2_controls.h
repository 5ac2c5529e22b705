// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/v4l2/internal/v4l2_device.h"

#include <string>
#include <utility>
#include <vector>

namespace odo {

/// What was set at a camera, to be set again when it comes back: ids and values, in their order.
using V4l2Settings = std::vector<std::pair<std::string, double>>;

/// All that can be set and has one value; texts and tables are left out. A button is a Boolean that is never
/// on. Ids are the names in lower case with underscores, as v4l2-ctl writes them. Errors: those of
/// v4l2Failure.
Result<std::vector<CameraControl>> v4l2Controls(const V4l2Device &device, const std::string &uri);

/// Errors: as CameraSource::set.
Result<void> setV4l2Control(const V4l2Device &device, const std::string &uri, const std::string &id,
                            double value);

/// As CameraSource::holdAutomatics.
struct V4l2Held
{
    V4l2Settings settings;        ///< what was set for it
    V4l2Settings automatics;      ///< as they stood, those that were on
    std::vector<Message> stillOn; ///< names of what could not be turned off
};
V4l2Held holdV4l2Automatics(const V4l2Device &device, const std::string &uri);

} // namespace odo
