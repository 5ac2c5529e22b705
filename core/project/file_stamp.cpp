// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/file_stamp.h"

#include <algorithm>
#include <sqlite3.h>
#include <sys/stat.h>

namespace odo {

bool FileStamp::isOverwrittenSince(const FileStamp &before) const
{
    return account == before.account && (size != before.size || modifiedNs != before.modifiedNs);
}

std::optional<FileStamp> fileStamp(sqlite3 *database, const std::filesystem::path &file)
{
    constexpr int regionSize = 32'768;
    constexpr std::size_t headerWords = 12, writtenBackAt = 24, attemptedAt = 32; // in words of four bytes
    struct stat status{};
    sqlite3_file *opened = nullptr;
    volatile void *region = nullptr;
    if (::stat(file.c_str(), &status) != 0 || sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &opened) != SQLITE_OK ||
        !opened->pMethods || opened->pMethods->iVersion < 2 || opened->pMethods->xShmMap(opened, 0, regionSize, 0, &region) != SQLITE_OK || !region)
        return std::nullopt;
    const auto *words = static_cast<volatile std::uint32_t *>(region);
    FileStamp stamp{status.st_size, std::int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec, {}};
    std::copy(words, words + headerWords, stamp.account.begin());
    stamp.account[headerWords] = words[writtenBackAt];
    stamp.account[headerWords + 1] = words[attemptedAt];
    return stamp;
}

} // namespace odo
