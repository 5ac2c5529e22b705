// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/opening_check.h"

#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/schema.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/new_file.h"
#include "core/project/project_words.h"
#include "core/project/write_ahead_log.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <sqlite3.h>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

namespace {

/// Only Project::check reads larger files in full: reading them at every start would be slow.
constexpr std::uintmax_t quickCheckBytes = 64 * 1024 * 1024;
/// More than the fullest file of that size takes; a file may be made so that reading it does not end.
constexpr std::int64_t mostOpeningSteps = 500'000'000;

using Schema = std::set<std::string>;

/// The schema as SQLite keeps it: one text for each table, index, trigger and view; the first so many of
/// them.
Result<Schema> schemaOf(const ProjectConnection &connection, std::size_t most)
{
    Schema schema;
    Statement select(connection, QStringLiteral("SELECT type, name, sql FROM sqlite_master LIMIT ?"));
    auto read =
        select.bind(static_cast<std::int64_t>(most)).eachRow([&schema](const Statement &row) -> Result<void> {
            schema.insert(row.text(0) + ' ' + row.text(1) + ' ' + row.text(2));
            return {};
        });
    if (!read)
        return tl::unexpected(read.error());
    return schema;
}

/// What a project of that version has. Kept, because making it takes longer than checking a small
/// project. Any thread.
Result<Schema> expectedSchema(const Migrator &migrator, int version)
{
    static std::mutex mutex;
    static std::map<int, Schema> known;
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(version); found != known.end())
        return found->second;
    const auto reference = ODO_TRY(ProjectConnection::open(":memory:", DatabaseAccess::ReadWrite));
    ODO_TRY(migrator.create(*reference, version));
    auto schema = schemaOf(*reference, std::numeric_limits<std::int64_t>::max());
    if (schema)
        known.emplace(version, *schema);
    return schema;
}

/// A project may come from anyone: views, triggers or checks in it that are not ours would be a program that
/// we run.
Result<void> checkSchema(const ProjectConnection &connection, const Migrator &migrator, int version)
{
    const auto expected = ODO_TRY(expectedSchema(migrator, version));
    const auto found = ODO_TRY(schemaOf(connection, expected.size() + 1));
    if (expected != found)
        return fail(ErrorCode::InvalidInput, connection.subject(),
                    ODO_TEXT("project.other_tables", "its tables are not those of a project"), restoreFile());
    return {};
}

/// Whether the disk gives all of it, whatever it is.
bool canBeRead(const std::filesystem::path &file)
{
    const DatabaseBytes bytes(file);
    std::vector<std::byte> block(1 << 16);
    for (std::uintmax_t at = 0; at < bytes.size(); at += block.size()) {
        if (!bytes.read(block, at))
            return false;
    }
    return bytes.isOpen();
}

Result<void> quickCheck(const ProjectConnection &connection)
{
    std::error_code problem;
    if (files::sizeOf(connection.file(), problem) > quickCheckBytes)
        return {};
    // What the disk fails to give looks like damage to SQLite: so it is asked once more.
    for (int attempt = 0; attempt < 2; ++attempt) {
        const auto sound = ODO_TRY(passesQuickCheck(connection));
        if (sound)
            return {};
        if (!canBeRead(connection.file()))
            return fail(ErrorCode::Io, connection.subject(), diskCannotBeRead(), copyToAnotherDisk());
    }
    return fail(ErrorCode::InvalidInput, connection.subject(), fileIsDamaged(), restoreFile());
}

Result<int> checkSnapshot(const ProjectConnection &connection, const Migrator &migrator)
{
    auto version = ODO_TRY(migrator.knownVersion(connection));
    ODO_TRY(checkSchema(connection, migrator, version));
    ODO_TRY(quickCheck(connection));
    return version;
}

} // namespace

Result<int> checkContent(ProjectConnection &connection, const Migrator &migrator)
{
    const StepLimit limit(connection, mostOpeningSteps);
    // In one transaction, for another process may be bringing it up to date.
    ODO_TRY(connection.execute(QStringLiteral("BEGIN")));
    auto version = checkSnapshot(connection, migrator);
    static_cast<void>(connection.execute(QStringLiteral("COMMIT"))); // nothing was changed
    return version;
}

namespace {

constexpr int stepsBetweenCalls = 10'000;

} // namespace

StepLimit::StepLimit(const ProjectConnection &connection, std::int64_t most)
    : m_handle(connection.handle()), m_left(most)
{
    sqlite3_progress_handler(m_handle, stepsBetweenCalls, &StepLimit::onSteps, this);
}

StepLimit::~StepLimit()
{
    sqlite3_progress_handler(m_handle, 0, nullptr, nullptr);
}

int StepLimit::onSteps(void *limit)
{
    auto &self = *static_cast<StepLimit *>(limit);
    self.m_left -= stepsBetweenCalls;
    return self.m_left < 0 ? 1 : 0;
}

namespace {

// Offsets of the header of an SQLite file: https://www.sqlite.org/fileformat.html, section 1.3.
constexpr std::string_view sqliteMagic("SQLite format 3\0", 16);
constexpr std::size_t pageSizeOffset = 16, changeCounterOffset = 24, pageCountOffset = 28,
                      schemaFormatOffset = 44, userVersionOffset = 60, applicationIdOffset = 68,
                      countValidForOffset = 92;
using Header = DatabaseHeader;

bool isOfSqlite(const Header &header)
{
    return std::ranges::equal(std::as_bytes(std::span(sqliteMagic)),
                              std::span(header).first(sqliteMagic.size()));
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

Message copyAgain()
{
    return ODO_TEXT("project.copy_again", "copy it again from its source, or restore a backup copy");
}

tl::unexpected<Error> cutOff(const std::filesystem::path &file, std::uintmax_t bytes, std::uintmax_t promised)
{
    return fail(ErrorCode::InvalidInput, projectSubject(file),
                joined({ODO_TEXT("project.file_cut_off", "the file is incomplete"),
                        ODO_TEXT("project.has_bytes_of", "it has %1 of %2 bytes")(bytes, promised)},
                       Join::Colon),
                copyAgain());
}

/// Whether a rollback journal ends with the name of another one (https://www.sqlite.org/fileformat.html,
/// section 3), which SQLite would remove after rolling back, whatever file it is. It belongs to changes of
/// several databases, which we never make.
bool namesAnotherFile(const std::filesystem::path &journal)
{
    constexpr std::string_view mark("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
    std::ifstream input(journal, std::ios::binary);
    std::string end(mark.size(), '\0');
    input.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    return input.read(end.data(), static_cast<std::streamsize>(end.size())) && end == mark;
}

/// Whether a file beside a project leads to another file, which SQLite would then write to or remove.
bool leadsElsewhere(const std::filesystem::path &file)
{
    std::error_code problem;
    std::filesystem::path real = files::realPath(file, problem); // SQLite looks beside that one
    if (problem)
        real = file;
    if (std::ranges::any_of(sideFileSuffixes, [&](const char *side) {
            return files::kindOfItself(besideFile(real, side)) == files::Kind::Link;
        }))
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
        return cannotBeInspected(projectSubject(file), problem, checkFileMayBeRead());
    if (kind == files::Kind::Missing)
        return fail(ErrorCode::NotFound, projectSubject(file), noSuchFile(),
                    ODO_TEXT("project.check_name_or_make", "check the name, or create a new project"));
    if (Message reason = files::insteadOfFile(kind); !reason.isEmpty())
        return fail(ErrorCode::InvalidInput, projectSubject(file), std::move(reason), chooseOurFile());
    return {};
}

Result<void> checkFileHeader(const std::filesystem::path &file, int newestVersion)
{
    ODO_TRY(checkIsFile(file));
    const Message what = projectSubject(file);
    const DatabaseBytes bytes(file);
    Header header{};
    if (!bytes.read(header, 0))
        return fail(ErrorCode::Io, what, cannotBeRead(), checkFileMayBeRead());
    if (bytes.size() == 0)
        return fail(ErrorCode::InvalidInput, what, fileIsEmpty(), restoreFile());
    if (!isOfSqlite(header))
        return fail(ErrorCode::InvalidInput, what, isNoProject(), chooseOurFile());
    if (bytes.size() < header.size())
        return cutOff(file, bytes.size(), header.size());
    if (bigEndian(header, applicationIdOffset) != projectApplicationId)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.other_database", "it is a database of another program"),
                    chooseOurFile());
    // SQLite's own; it would only say that it is not supported
    constexpr std::uint32_t newestSchemaFormat = 4;
    if (bigEndian(header, schemaFormatOffset) > newestSchemaFormat)
        return fail(ErrorCode::InvalidInput, what, fileIsDamaged(), restoreFile());
    const auto version = static_cast<std::int32_t>(bigEndian(header, userVersionOffset));
    if (version > newestVersion)
        return fail(ErrorCode::NewerFormat, what, isOfNewerFormat(version, newestVersion),
                    openWithThatOdograph());
    if (leadsElsewhere(file))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.journal_of_another", "the journal beside it names another file"),
                    copyAgain());
    // While a write-ahead log is beside it, the file itself may lag behind. Asked before the size: whoever
    // empties the log has written all of it into the file before.
    if (!hasLog(file) && bytes.size() < promisedBytes(header))
        return cutOff(file, bytes.size(), promisedBytes(header));
    return {};
}

namespace {

Result<void> setVersion(ProjectConnection &connection, int version)
{
    return connection.execute(QStringLiteral("PRAGMA user_version=%1").arg(version));
}

std::filesystem::path freeBackupName(const std::filesystem::path &file, std::int64_t version)
{
    std::filesystem::path name = file;
    name += ".bak-";
    name += std::to_string(version);
    const std::filesystem::path first = name;
    for (int i = 2; files::exists(name); ++i) {
        name = first;
        name += '.' + std::to_string(i);
    }
    return name;
}

/// Copies all pages; the result code of SQLite.
int copyPages(sqlite3 *source, const std::filesystem::path &target)
{
    sqlite3 *copy = nullptr;
    int code = sqlite3_open_v2(target.c_str(), &copy, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    if (code == SQLITE_OK) {
        sqlite3_backup *backup = sqlite3_backup_init(copy, "main", source, "main");
        if (backup != nullptr) {
            sqlite3_backup_step(backup, -1);
            code = sqlite3_backup_finish(backup);
        } else {
            code = sqlite3_errcode(copy);
        }
    }
    if (code == SQLITE_OK) // the log of the source is not the copy's
        code = sqlite3_exec(copy, ("PRAGMA default_cache_size=" + std::to_string(newLogMark())).c_str(),
                            nullptr, nullptr, nullptr);
    sqlite3_close(copy);
    return code;
}

/// Opens the copy for reading and lets SQLite check it.
Result<void> checkCopy(const std::filesystem::path &file, const Message &what)
{
    const auto copy = ODO_TRY(ProjectConnection::open(file, DatabaseAccess::Immutable));
    if (!passesQuickCheck(*copy).value_or(false))
        return fail(ErrorCode::Io, what,
                    ODO_TEXT("project.copy_differs", "the copy differs from what was written"),
                    checkDiskAndRetry());
    return {};
}

} // namespace

Migration sqlMigration(Message purpose, std::vector<std::string> statements)
{
    const auto apply = [statements = std::move(statements)](ProjectConnection &connection) -> Result<void> {
        for (const std::string &sql : statements)
            ODO_TRY(connection.execute(QString::fromStdString(sql)));
        return {};
    };
    return {std::move(purpose), apply};
}

Result<void> Migrator::create(ProjectConnection &connection, int version) const
{
    return runSteps(connection, 0, version);
}

Result<int> Migrator::knownVersion(const ProjectConnection &connection) const
{
    const auto version = ODO_TRY(connection.number(QStringLiteral("PRAGMA user_version")));
    if (version > newestVersion())
        return fail(ErrorCode::NewerFormat, connection.subject(), isOfNewerFormat(version, newestVersion()),
                    openWithThatOdograph());
    if (version < 1)
        return fail(ErrorCode::InvalidInput, connection.subject(),
                    ODO_TEXT("project.impossible_format", "it claims to have format %1")(version),
                    restoreFile());
    return static_cast<int>(version);
}

Result<void> Migrator::migrate(ProjectConnection &connection) const
{
    const auto version = ODO_TRY(knownVersion(connection));
    if (version == newestVersion())
        return {};
    ODO_TRY(copyDatabase(connection, freeBackupName(connection.file(), version)));
    return runSteps(connection, version, newestVersion());
}

Result<void> Migrator::runSteps(ProjectConnection &connection, int fromVersion, int toVersion) const
{
    for (int version = fromVersion + 1; version <= toVersion; ++version) {
        const Migration &migration = m_migrations[static_cast<std::size_t>(version - 1)];
        const auto step = [&]() -> Result<void> {
            ODO_TRY(migration.apply(connection));
            return setVersion(connection, version);
        };
        if (auto done = transact(connection, step); !done)
            return fail(
                done.error().code, connection.subject(),
                joined({ODO_TEXT("project.not_brought_to_format",
                                 "it could not be converted to format %1 (%2)")(version, migration.purpose),
                        done.error().why},
                       Join::Colon),
                done.error().advice);
    }
    return {};
}

Result<void> copyDatabase(const ProjectConnection &connection, const std::filesystem::path &target)
{
    const Message what = copySubject(target);
    NewFile file(target, what);
    ODO_TRY(file.prepare());
    const int code = copyPages(connection.handle(), file.temporary());
    if (code != SQLITE_OK)
        return fail(code == SQLITE_READONLY || code == SQLITE_CANTOPEN ? ErrorCode::ReadOnly : ErrorCode::Io,
                    what, foreignWords(sqlite3_errstr(code)),
                    ODO_TEXT("project.choose_writable_folder",
                             "choose a folder that can be written to and has free space"));
    ODO_TRY(checkCopy(file.temporary(), what));
    return file.publish();
}

Result<bool> passesQuickCheck(const ProjectConnection &connection)
{
    Statement check(connection, QStringLiteral("PRAGMA quick_check(1)"));
    const auto row = ODO_TRY(check.firstRow());
    return row && check.text(0) == "ok";
}

} // namespace odo
