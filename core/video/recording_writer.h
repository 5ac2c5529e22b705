// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/frame.h"

#include <filesystem>
#include <memory>
#include <span>

namespace odo {

/// Writes the frames of a camera as they come, as JPEG in Matroska, so that what was written can be read
/// whatever happens to the program or the machine: each frame stands alone, clusters are half a second,
/// every packet goes to the system at once and to the disk with each cluster. Its time stamps are whole
/// milliseconds; whoever needs them exactly keeps them beside it. Not thread-safe.
class RecordingWriter
{
public:
    /// The file must not be there yet, or be empty: one whose name was claimed. Errors: a folder that cannot
    /// be written to.
    static Result<std::unique_ptr<RecordingWriter>>
    create(const std::filesystem::path &file, const FrameFormat &format, double nominalFramesPerSecond);
    ~RecordingWriter(); ///< without finish(): the file stays as a kill would leave it
    RecordingWriter(const RecordingWriter &) = delete;
    RecordingWriter &operator=(const RecordingWriter &) = delete;

    /// time: since the first frame; increasing. Once writing has failed the file is closed, and stays
    /// readable.
    Result<void> write(std::span<const std::uint8_t> jpeg, Nanoseconds time);
    Result<void> finish();

private:
    struct Impl;
    explicit RecordingWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
