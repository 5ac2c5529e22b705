// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/migrator.h"

#include "core/base/file_system.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/new_file.h"
#include "core/project/project_words.h"

#include <sqlite3.h>

namespace odo {

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

/// Opens the copy for reading and lets SQLite look through it.
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
                    ODO_TEXT("project.impossible_format", "it says of itself to have the format %1")(version),
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
                                 "it could not be brought to format %1 (%2)")(version, migration.purpose),
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
                             "choose a folder that can be written to and has room"));
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
