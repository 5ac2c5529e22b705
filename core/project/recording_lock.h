// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/held_file.h"

namespace odo {

/// Held by who records into a project, so that no other program takes the trial for one that was cut off:
/// `recording.lock` in the media folder.
class RecordingLock
{
public:
    /// Makes the media folder. AlreadyExists while somebody else holds it; Io where the folder cannot be
    /// written to.
    static Result<std::unique_ptr<RecordingLock>> take(const std::filesystem::path &mediaFolder);
    /// What is held; it means nothing by itself.
    static std::filesystem::path fileIn(const std::filesystem::path &mediaFolder);
    /// Whether somebody, this program too, holds it now.
    static bool isHeld(const std::filesystem::path &mediaFolder);

private:
    explicit RecordingLock(std::unique_ptr<HeldFile> file) : m_file(std::move(file)) {}
    const std::unique_ptr<HeldFile> m_file;
};

} // namespace odo
