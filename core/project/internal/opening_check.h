// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

struct sqlite3;

namespace odo {

class Migrator;
struct ProjectConnection;

/// Checks a project's file before anything is written to it, for it may come from anyone, and gives
/// the version of its schema: the file holds that schema and nothing else, and all of it is whole, unless it
/// is so large that reading it would take long. The schema comes first, because the check of the rest
/// evaluates the checks in it; all of it is read as it was at one moment. A file made so that checking
/// it does not end is given up. On the connection's thread. Errors: NewerFormat, InvalidInput (damaged, or
/// not a project's tables), Io where the disk does not give what is in the file.
Result<int> checkContent(ProjectConnection &connection, const Migrator &migrator);

/// While it lives, the statements of a connection may take so many steps of SQLite's virtual machine in all;
/// one that would take more fails with InvalidInput, "the file is damaged". One at a time for a connection,
/// on its thread.
class StepLimit
{
public:
    StepLimit(const ProjectConnection &connection, std::int64_t most);
    ~StepLimit();
    StepLimit(const StepLimit &) = delete;
    StepLimit &operator=(const StepLimit &) = delete;

private:
    static int onSteps(void *limit);

    sqlite3 *const m_handle;
    std::int64_t m_left;
};

/// Looks at the first bytes of a file, without a lock, and says in words why it is no project that can be
/// opened: missing, a folder, empty, another kind of file, another program's database, cut off, or written by
/// a newer Odograph than one that knows `newestVersion`. Says nothing false of a file that another process
/// works on. Never changes anything.
Result<void> checkFileHeader(const std::filesystem::path &file, int newestVersion);

/// Whether the first bytes are those of a project, of any version and however damaged the rest is.
bool isProjectFile(const std::filesystem::path &file);

/// That there is such a file, which could be opened.
Result<void> checkIsFile(const std::filesystem::path &file);

/// One step of the schema: from version n - 1 to n, where n is its position in the list, counted from 1. A
/// step that was ever published is never changed again.
struct Migration
{
    Message purpose; ///< what it brings, for messages
    std::function<Result<void>(ProjectConnection &)> apply;
};

/// A migration that only runs statements.
Migration sqlMigration(Message purpose, std::vector<std::string> statements);

/// Brings a database to the newest version of its schema (PRAGMA user_version), one transaction a step.
class Migrator
{
public:
    explicit Migrator(std::vector<Migration> migrations) : m_migrations(std::move(migrations)) {}

    int newestVersion() const { return static_cast<int>(m_migrations.size()); }

    /// Makes the schema of a version in an empty database.
    Result<void> create(ProjectConnection &connection, int version) const;

    /// The version of a database. NewerFormat for one beyond the newest, InvalidInput for none at all.
    Result<int> knownVersion(const ProjectConnection &connection) const;

    /// Nothing to do for the newest version; NewerFormat for a version beyond it. Otherwise copies the
    /// database to
    /// "<file>.bak-<version>" (checked; another name with a number when that is taken), then runs the missing
    /// steps. A step that fails is rolled back: the database keeps the version that it had reached, the
    /// backup stays.
    Result<void> migrate(ProjectConnection &connection) const;

private:
    Result<void> runSteps(ProjectConnection &connection, int fromVersion, int toVersion) const;

    std::vector<Migration> m_migrations;
};

/// Copies a database through SQLite's backup API to a file that must not exist yet (AlreadyExists), and
/// checks the copy. It appears under its name only when it is whole and on the disk.
Result<void> copyDatabase(const ProjectConnection &connection, const std::filesystem::path &target);

/// Whether SQLite finds nothing wrong in a project's file, all of which it reads. Errors: those of reading
/// it. The connection's thread.
Result<bool> passesQuickCheck(const ProjectConnection &connection);

} // namespace odo
