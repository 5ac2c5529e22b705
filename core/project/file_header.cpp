// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/file_header.h"

#include "core/base/file_system.h"
#include "core/project/database_bytes.h"
#include "core/project/log_copy.h"
#include "core/project/schema.h"
#include "core/project/side_files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <span>
#include <string_view>

namespace odo {

namespace {

// Offsets of the header of an SQLite file: https://www.sqlite.org/fileformat.html, section 1.3.
constexpr std::string_view sqliteMagic("SQLite format 3\0", 16);
constexpr std::size_t pageSizeOffset = 16, changeCounterOffset = 24, pageCountOffset = 28, schemaFormatOffset = 44,
                      userVersionOffset = 60, applicationIdOffset = 68, countValidForOffset = 92;
using Header = DatabaseHeader;

bool isOfSqlite(const Header &header)
{
    return std::ranges::equal(std::as_bytes(std::span(sqliteMagic)), std::span(header).first(sqliteMagic.size()));
}

/// The size that the header promises, or 0 where it does not say.
std::uintmax_t promisedBytes(const Header &header)
{
    if (bigEndian(header, changeCounterOffset) != bigEndian(header, countValidForOffset))
        return 0;
    const std::uint32_t coded = bigEndian(header, pageSizeOffset) >> 16; // two bytes
    const std::uintmax_t pageBytes = coded == 1 ? 65536 : coded;
    return pageBytes * bigEndian(header, pageCountOffset);
}

std::string nameOf(const std::filesystem::path &file)
{
    return "project '" + file.string() + "'";
}

tl::unexpected<Error> cutOff(const std::filesystem::path &file, std::uintmax_t bytes, std::uintmax_t promised)
{
    return fail(ErrorCode::InvalidInput, nameOf(file),
                "the file is cut off: it has " + std::to_string(bytes) + " of " + std::to_string(promised) + " bytes",
                "copy it again from where it came, or restore a backup copy");
}

/// Whether a rollback journal ends with the name of another one (https://www.sqlite.org/fileformat.html, section 3), which SQLite
/// would remove after rolling back, whatever file it is. It belongs to changes of several databases, which we never make.
bool namesAnotherFile(const std::filesystem::path &journal)
{
    constexpr std::string_view mark("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
    std::ifstream input(journal, std::ios::binary);
    std::string end(mark.size(), '\0');
    input.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    return input.read(end.data(), static_cast<std::streamsize>(end.size())) && end == mark;
}

/// Whether what lies beside a project leads to another file, which SQLite would then write to or remove.
bool leadsElsewhere(const std::filesystem::path &file)
{
    std::error_code problem;
    std::filesystem::path real = files::realPath(file, problem); // SQLite looks beside that one
    if (problem)
        real = file;
    if (std::ranges::any_of(sideFileSuffixes, [&](const char *side) { return files::kindOfItself(besideFile(real, side)) == files::Kind::Link; }))
        return true;
    const std::filesystem::path journal = besideFile(real, journalSuffix);
    return files::isFile(journal) && namesAnotherFile(journal);
}

} // namespace

bool isProjectFile(const std::filesystem::path &file)
{
    if (!files::isFile(file))
        return false;
    const DatabaseBytes bytes(file);
    Header header{};
    return bytes.read(header, 0) && isOfSqlite(header) &&
           bigEndian(header, applicationIdOffset) == projectApplicationId;
}

Result<void> checkIsFile(const std::filesystem::path &file)
{
    std::error_code problem;
    const files::Kind kind = files::kindOf(file, problem);
    if (problem)
        return fail(ErrorCode::Io, nameOf(file), "it cannot be looked at (" + problem.message() + ")", "check that you may read the file");
    if (kind == files::Kind::Missing)
        return fail(ErrorCode::NotFound, nameOf(file), "there is no such file", "check the name, or make a new project");
    if (const char *reason = files::insteadOfFile(kind))
        return fail(ErrorCode::InvalidInput, nameOf(file), reason, "choose a file that Odograph has written");
    return {};
}

Result<void> checkFileHeader(const std::filesystem::path &file, int newestVersion)
{
    if (auto isFile = checkIsFile(file); !isFile)
        return isFile;
    const std::string what = nameOf(file);
    const DatabaseBytes bytes(file);
    Header header{};
    if (!bytes.read(header, 0))
        return fail(ErrorCode::Io, what, "it cannot be read", "check that you may read the file");
    if (bytes.size() == 0)
        return fail(ErrorCode::InvalidInput, what, "the file is empty", "restore it from a backup copy");
    if (!isOfSqlite(header))
        return fail(ErrorCode::InvalidInput, what, "it is not a project file",
                    "choose a file that Odograph has written");
    if (bytes.size() < header.size())
        return cutOff(file, bytes.size(), header.size());
    if (bigEndian(header, applicationIdOffset) != projectApplicationId)
        return fail(ErrorCode::InvalidInput, what, "it is a database of another program",
                    "choose a file that Odograph has written");
    constexpr std::uint32_t newestSchemaFormat = 4; // SQLite's own; it would only say that it is not supported
    if (bigEndian(header, schemaFormatOffset) > newestSchemaFormat)
        return fail(ErrorCode::InvalidInput, what, "the file is damaged", "restore it from a backup copy");
    const auto version = static_cast<std::int32_t>(bigEndian(header, userVersionOffset));
    if (version > newestVersion)
        return fail(ErrorCode::NewerFormat, what,
                    "it was written by a newer Odograph (format " + std::to_string(version) +
                        ", this one knows formats up to " + std::to_string(newestVersion) + ")",
                    "open it with that Odograph, or update this one");
    if (leadsElsewhere(file))
        return fail(ErrorCode::InvalidInput, what, "the journal beside it names another file",
                    "copy it again from where it came, or restore a backup copy");
    // While a write-ahead log lies beside it, the file itself may lag behind. Asked before the size: whoever empties the log has
    // written all of it into the file before.
    if (!hasLog(file) && bytes.size() < promisedBytes(header))
        return cutOff(file, bytes.size(), promisedBytes(header));
    return {};
}

} // namespace odo
