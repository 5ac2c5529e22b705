// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/recording_lock.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace odo {

namespace {

std::filesystem::path lockFile(const std::filesystem::path &mediaFolder)
{
    return mediaFolder / "recording.lock";
}

} // namespace

Result<std::unique_ptr<RecordingLock>> RecordingLock::take(const std::filesystem::path &mediaFolder)
{
    const std::string what = "cannot record into " + mediaFolder.string();
    std::error_code problem;
    std::filesystem::create_directories(mediaFolder, problem);
    const std::filesystem::path file = lockFile(mediaFolder);
    const int descriptor = problem ? -1 : ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor < 0)
        return fail(ErrorCode::Io, what, problem ? problem.message() : std::strerror(errno),
                    "check the free space and the rights of the project's folder");
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return fail(ErrorCode::AlreadyExists, what, "a trial is being recorded into it just now",
                    "wait until that has ended");
    }
    return std::unique_ptr<RecordingLock>(new RecordingLock(descriptor));
}

bool RecordingLock::isHeld(const std::filesystem::path &mediaFolder)
{
    const int descriptor = ::open(lockFile(mediaFolder).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

RecordingLock::~RecordingLock()
{
    ::close(m_descriptor);
}

} // namespace odo
