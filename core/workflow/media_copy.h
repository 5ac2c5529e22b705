// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/files/temporary.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace odo {

struct MediaCopy
{
    ClaimedFile file;   ///< a new one goes with it unless it is kept; one that was there already stays
    std::string sha256; ///< lower-case hexadecimal
    std::int64_t bytes = 0;
};

/// Copies a file into the media folder (made when missing) under a name of its own, and computes its hash
/// meanwhile. It appears under its name only when whole and on the disk. A file that lies in the media folder
/// already is only hashed. Errors: Io, NotFound, Cancelled, Unavailable (it lies there already, and somebody
/// writes or removes it).
Result<MediaCopy> copyIntoMedia(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                                const std::string &name, const JobControl &control);

/// What `make` writes to an empty file, which it finds under an unforeseeable name, as a file of the media
/// folder: as copyIntoMedia, it appears under its name only when whole and on the disk, and goes where
/// anything fails. what: names it in messages. Errors: Io, Cancelled and those of `make`.
Result<MediaCopy> makeInMedia(const std::filesystem::path &mediaFolder, const std::string &name,
                              const std::string &ending, const Message &what,
                              const std::function<Result<void>(const std::filesystem::path &claimed)> &make,
                              const JobControl &control);

/// A new empty file in the media folder (made when missing), called after a name, which is made safe for
/// every file system and cut to 80 letters, so that different names may give the same; then it gets a number.
/// Error Io.
Result<ClaimedFile> claimMediaFile(const std::filesystem::path &folder, const std::string &name,
                                   const std::string &ending);

/// As claimMediaFile, with what the file holds, whole and on the disk. what: names it in messages. Error Io.
Result<ClaimedFile> writeMediaFile(const std::filesystem::path &folder, const std::string &name,
                                   const std::string &ending, std::span<const char> content,
                                   const Message &what);

} // namespace odo
