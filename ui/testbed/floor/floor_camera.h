// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/models/figure_text.h"

#include <QString>
#include <filesystem>
#include <optional>

namespace odo {

/// What a registration needs to know of a camera.
struct FloorCamera
{
    QString name;
    std::optional<IntrinsicsRecord> intrinsics;           ///< in force
    std::optional<std::filesystem::path> newestRecording; ///< in which the markers may be seen
    Badge badge = {};                                     ///< of the registration in force
};

} // namespace odo
