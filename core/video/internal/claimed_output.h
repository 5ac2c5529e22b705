// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/platform/file_handle.h"
#include "core/video/internal/libav.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace odo {

/// What a muxer of libav writes to: a file whose name was claimed, opened by us. libav opens no file by its
/// name, which could be another one's by then. Not thread-safe.
class ClaimedOutput
{
public:
    ClaimedOutput() = default;
    ~ClaimedOutput() { close(); }
    ClaimedOutput(const ClaimedOutput &) = delete;
    ClaimedOutput &operator=(const ClaimedOutput &) = delete;

    /// Never through a link, nor over what is there: the file must be empty, or not be there yet.
    std::error_code open(const std::filesystem::path &file);
    /// Of the file that is open; null before and afterwards.
    AVIOContext *io() const { return m_io; }
    /// What was handed to the system is on the disk.
    std::error_code syncData() const { return m_handle.syncData(); }
    /// Why what was written may not all be on the disk.
    std::error_code close();

private:
    static int write(void *output, std::uint8_t *bytes, int count);
    static std::int64_t seek(void *output, std::int64_t offset, int whence);

    FileHandle m_handle;
    AVIOContext *m_io = nullptr;
};

} // namespace odo
