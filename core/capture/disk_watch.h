// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace odo {

struct DiskRoom
{
    std::uint64_t free = 0; ///< bytes that may still be written
    std::uint64_t size = 0; ///< bytes of the whole disk
};

/// Of the disk that a folder is on; nullopt where the system does not say.
std::optional<DiskRoom> diskRoomOf(const std::filesystem::path &folder);

/// How full a recording may make its disk.
struct DiskWatch
{
    /// A recording ends by itself with so many bytes left, or with a twentieth of a disk that is small:
    /// enough for the project and everything else on this machine to go on.
    std::uint64_t mostReserved = 200'000'000;
    /// Asked once a second while recording, on the thread that writes.
    std::function<std::optional<DiskRoom>(const std::filesystem::path &folder)> room = diskRoomOf;

    /// Bytes that a recording may still take.
    std::uint64_t left(const DiskRoom &disk) const;
    std::uint64_t reserved(const DiskRoom &disk) const;
};

} // namespace odo
