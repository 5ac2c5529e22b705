// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <string>
#include <vector>

namespace odo::test {

/// What a camera offers, as the command line prints it.
inline std::vector<std::string> offeredFormats(const CameraDescription &camera)
{
    std::vector<std::string> words;
    for (const CameraFormat &format : camera.formats)
        words.push_back(format.words.english());
    return words;
}

} // namespace odo::test
