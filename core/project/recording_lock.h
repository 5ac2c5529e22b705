// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <memory>

namespace odo {

/// Held by who records into a project, so that no other program takes the trial for one that was cut off. The
/// system gives it back when the program ends, however it ends: the file that carries it, `recording.lock` in
/// the media folder, means nothing by itself.
class RecordingLock
{
public:
    /// Makes the media folder. AlreadyExists while somebody else holds it; Io where the folder cannot be
    /// written to.
    static Result<std::unique_ptr<RecordingLock>> take(const std::filesystem::path &mediaFolder);
    /// Whether somebody, this program too, holds it now.
    static bool isHeld(const std::filesystem::path &mediaFolder);
    ~RecordingLock();
    RecordingLock(const RecordingLock &) = delete;
    RecordingLock &operator=(const RecordingLock &) = delete;

private:
    explicit RecordingLock(int descriptor) : m_descriptor(descriptor) {}
    const int m_descriptor;
};

} // namespace odo
