// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace odo {

struct MediaCopy
{
    std::filesystem::path file;
    std::string sha256; ///< lower-case hexadecimal
    std::int64_t bytes = 0;
    bool made = false; ///< false: the file was there already
};

/// Copies a file into the media folder (made when missing) under a name made safe for every file system, never over
/// another file, and computes its hash on the way. It appears under its name only when whole and on the disk.
/// A file that lies in the media folder already is only hashed.
Result<MediaCopy> copyIntoMedia(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                                const std::string &name, const JobControl &control);

/// A file name in a folder that is neither there nor among those taken, made of a name that is made safe for every file
/// system and cut to 80 letters, so that different names may give the same.
std::filesystem::path freeMediaPath(const std::filesystem::path &folder, const std::string &name,
                                    const std::string &ending, const std::vector<std::filesystem::path> &taken = {});

} // namespace odo
