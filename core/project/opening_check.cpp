// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/opening_check.h"

#include "core/base/file_system.h"
#include "core/project/connection.h"
#include "core/project/database_bytes.h"
#include "core/project/migrator.h"
#include "core/project/quick_check.h"
#include "core/project/step_limit.h"

#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace odo {

namespace {

/// Larger files are looked through only by Project::check: reading them at every start would be slow.
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

/// What a project of that version has. Kept, because making it takes longer than to look through a small
/// project. Any thread.
Result<Schema> expectedSchema(const Migrator &migrator, int version)
{
    static std::mutex mutex;
    static std::map<int, Schema> known;
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(version); found != known.end())
        return found->second;
    const auto reference = ProjectConnection::open(":memory:", DatabaseAccess::ReadWrite);
    if (!reference)
        return tl::unexpected(reference.error());
    if (auto made = migrator.create(**reference, version); !made)
        return tl::unexpected(made.error());
    auto schema = schemaOf(**reference, std::numeric_limits<std::int64_t>::max());
    if (schema)
        known.emplace(version, *schema);
    return schema;
}

/// A project may come from anyone: views, triggers or checks in it that are not ours would be a program that
/// we run.
Result<void> checkSchema(const ProjectConnection &connection, const Migrator &migrator, int version)
{
    const auto expected = expectedSchema(migrator, version);
    if (!expected)
        return tl::unexpected(expected.error());
    const auto found = schemaOf(connection, expected->size() + 1);
    if (!found)
        return tl::unexpected(found.error());
    if (*expected != *found)
        return fail(ErrorCode::InvalidInput, connection.displayName(),
                    "its tables are not those of a project", "restore it from a backup copy");
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
        const auto sound = passesQuickCheck(connection);
        if (!sound)
            return tl::unexpected(sound.error());
        if (*sound)
            return {};
        if (!canBeRead(connection.file()))
            return fail(ErrorCode::Io, connection.displayName(),
                        "the disk could not be read, and nothing was changed",
                        "check the disk, and copy the project to another one");
    }
    return fail(ErrorCode::InvalidInput, connection.displayName(), "the file is damaged",
                "restore it from a backup copy");
}

Result<int> checkSnapshot(const ProjectConnection &connection, const Migrator &migrator)
{
    auto version = migrator.knownVersion(connection);
    if (!version)
        return version;
    if (auto ours = checkSchema(connection, migrator, *version); !ours)
        return tl::unexpected(ours.error());
    if (auto sound = quickCheck(connection); !sound)
        return tl::unexpected(sound.error());
    return version;
}

} // namespace

Result<int> checkContent(ProjectConnection &connection, const Migrator &migrator)
{
    const StepLimit limit(connection, mostOpeningSteps);
    // In one transaction, for another process may be bringing it up to date.
    if (auto begun = connection.execute(QStringLiteral("BEGIN")); !begun)
        return tl::unexpected(begun.error());
    auto version = checkSnapshot(connection, migrator);
    static_cast<void>(connection.execute(QStringLiteral("COMMIT"))); // nothing was changed
    return version;
}

} // namespace odo
