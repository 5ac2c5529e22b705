// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "core/project/records.h"
#include "ui/models/number_text.h"

#include <QString>
#include <filesystem>
#include <optional>
#include <string>

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
    std::string deviceUri = {}; ///< may be empty
    Badge badge = {};           ///< how far it can be relied on
};

} // namespace odo
