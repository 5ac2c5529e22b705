// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/recording_lock.h"

#include "core/base/file_system.h"

#include <system_error>

namespace odo {

std::filesystem::path RecordingLock::fileIn(const std::filesystem::path &mediaFolder)
{
    return mediaFolder / "recording.lock";
}

Result<std::unique_ptr<RecordingLock>> RecordingLock::take(const std::filesystem::path &mediaFolder)
{
    const std::string what = "cannot record into " + mediaFolder.string();
    std::error_code problem;
    files::makeFolders(mediaFolder, problem);
    if (problem)
        return fail(ErrorCode::Io, what, problem.message(),
                    "check the free space and the rights of the project's folder");
    auto file = HeldFile::take(fileIn(mediaFolder), HeldFile::Afterwards::Stays);
    if (!file)
        return fail(file.error().code, what, file.error().why, file.error().advice);
    if (!*file)
        return fail(ErrorCode::AlreadyExists, what, "a trial is being recorded into it just now",
                    "wait until that has ended");
    return std::unique_ptr<RecordingLock>(new RecordingLock(std::move(*file)));
}

bool RecordingLock::isHeld(const std::filesystem::path &mediaFolder)
{
    return HeldFile::isHeld(fileIn(mediaFolder));
}

} // namespace odo
