// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// One step of the schema: from version n - 1 to n, where n is its place in the list, counted from 1. A step
/// that was ever published is never changed again.
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
