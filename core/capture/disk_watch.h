// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace odo {

/// Bytes that may still be written into a folder; nullopt where the system does not say.
std::optional<std::uint64_t> freeBytesOf(const std::filesystem::path &folder);

/// How full a recording may make its disk.
struct DiskWatch
{
    /// A recording ends by itself with so much left: enough for the project and everything else on this
    /// machine to go on.
    std::uint64_t reserveBytes = 200 << 20;
    /// Asked once a second while recording, on the thread that writes.
    std::function<std::optional<std::uint64_t>(const std::filesystem::path &folder)> freeBytes = freeBytesOf;
};

} // namespace odo
