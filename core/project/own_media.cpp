// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/own_media.h"

#include "core/base/file_system.h"

#include <algorithm>

namespace odo {

bool isOwnMedia(const std::filesystem::path &file, const std::filesystem::path &mediaFolder)
{
    std::error_code problem, otherProblem;
    const auto real = files::realPath(file, problem), folder = files::realPath(mediaFolder, otherProblem);
    if (problem || otherProblem)
        return false;
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end() && real != folder;
}

} // namespace odo
