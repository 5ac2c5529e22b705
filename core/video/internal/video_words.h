// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <filesystem>

namespace odo {

/// What is said at several places of this folder.
Message cannotOpenVideo(const std::filesystem::path &file);
Message dataAreDamaged();
Message writingFailedBefore();
Message copyFromCamera();
Message convertToH264();

} // namespace odo
