// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/disk_watch.h"

namespace odo {

std::optional<std::uint64_t> freeBytesOf(const std::filesystem::path &folder)
{
    std::error_code problem;
    const std::filesystem::space_info space = std::filesystem::space(folder, problem);
    if (problem)
        return std::nullopt;
    return space.available;
}

} // namespace odo
