// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/log_copy.h"

#include "core/base/file_system.h"
#include "core/project/database_bytes.h"
#include "core/project/side_files.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sys/stat.h>
#include <vector>

namespace odo {

namespace {

tl::unexpected<Error> notCopied(const std::filesystem::path &file, const char *why)
{
    return fail(ErrorCode::Io, "project '" + file.filename().string() + "'", std::string("it could not be copied to be read (") + why + ")",
                "copy it with the files beside it to a folder that you may write to, and open the copy");
}

/// What changes when a file is written to.
using Stamp = std::array<std::int64_t, 4>;

Stamp stampOf(const std::filesystem::path &file)
{
    struct stat there{};
    if (::stat(file.c_str(), &there) != 0)
        return {};
    return {there.st_size, there.st_mtim.tv_sec, there.st_mtim.tv_nsec, static_cast<std::int64_t>(there.st_ino)};
}

bool copyDatabaseBytes(const std::filesystem::path &from, std::ofstream &into)
{
    const DatabaseBytes bytes(from);
    std::vector<std::byte> block(1 << 20);
    const std::uintmax_t size = bytes.size();
    for (std::uintmax_t at = 0; at < size; at += block.size()) {
        block.resize(static_cast<std::size_t>(std::min<std::uintmax_t>(block.size(), size - at)));
        if (!bytes.read(block, at) || !into.write(reinterpret_cast<const char *>(block.data()), static_cast<std::streamsize>(block.size())))
            return false;
    }
    return bytes.isOpen() && into.flush();
}

} // namespace

bool hasLog(const std::filesystem::path &file)
{
    std::error_code problem;
    return files::sizeOf(besideFile(files::realPath(file), logSuffix), problem) > 0;
}

Result<std::unique_ptr<LogCopy>> LogCopy::make(const std::filesystem::path &file)
{
    const char *told = std::getenv("TMPDIR");
    auto folder = TemporaryFolder::make(told != nullptr ? told : "/tmp", "copy of project '" + file.filename().string() + "'");
    if (!folder)
        return tl::unexpected(folder.error());
    std::unique_ptr<LogCopy> copy(new LogCopy(std::move(*folder)));
    if (auto filled = copy->fill(file); !filled)
        return tl::unexpected(filled.error());
    return copy;
}

Result<void> LogCopy::fill(const std::filesystem::path &file) const
{
    const std::filesystem::path log = besideFile(file, logSuffix);
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const std::array before{stampOf(file), stampOf(log)};
        std::ofstream database(this->file(), std::ios::binary), logCopy(besideFile(this->file(), logSuffix), std::ios::binary);
        std::ifstream logged(log, std::ios::binary);
        if (!copyDatabaseBytes(file, database) || !(logCopy << logged.rdbuf()).flush())
            return notCopied(file, std::strerror(errno));
        if (before == std::array{stampOf(file), stampOf(log)})
            return {};
    }
    return fail(ErrorCode::Unavailable, "project '" + file.filename().string() + "'", "another program is writing to it",
                "close the other program and try again");
}

} // namespace odo
