// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/disk_watch.h"

#include "core/base/file_system.h"

#include <algorithm>

namespace odo {

std::optional<DiskRoom> diskRoomOf(const std::filesystem::path &folder)
{
    std::error_code problem;
    const files::DiskSpace space = files::diskSpace(folder, problem);
    if (problem)
        return std::nullopt;
    return DiskRoom{space.freeBytes, space.bytes};
}

std::uint64_t DiskWatch::reserved(const DiskRoom &disk) const
{
    return std::min(mostReserved, disk.size / 20);
}

std::uint64_t DiskWatch::left(const DiskRoom &disk) const
{
    return disk.free - std::min(disk.free, reserved(disk));
}

} // namespace odo
