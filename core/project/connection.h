// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/protected_files.h"
#include "core/project/records.h"

#include <QByteArray>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

struct sqlite3;

namespace odo {

/// How a database file is opened. Immutable: read without locks and without making any file beside it; only
/// for a file that has no write-ahead log, because nobody is changing it then.
enum class DatabaseAccess { ReadWrite, ReadOnly, Immutable };

/// One open SQLite database with the settings that a project needs: foreign keys on, synchronous=FULL, a
/// schema that is not trusted. Private to core/project and its tests; belongs to the thread that opened it.
struct ProjectConnection
{
    /// Errors in words for a person: corrupt, locked, not a database, no write access.
    static Result<std::unique_ptr<ProjectConnection>> open(const std::filesystem::path &file,
                                                           DatabaseAccess access);
    ~ProjectConnection();
    ProjectConnection(const ProjectConnection &) = delete;
    ProjectConnection &operator=(const ProjectConnection &) = delete;

    const QSqlDatabase &database() const { return m_database; }
    /// SQLite's own handle, for what Qt hides: backup, limits, state of the transaction.
    sqlite3 *handle() const;
    const std::filesystem::path &file() const { return m_file; }
    /// Held by whoever writes, see write_turn.h.
    std::recursive_mutex &writeTurn() const { return *m_turn; }
    /// "project 'run.odo'": how messages name it.
    std::string displayName() const;

    /// Runs one statement without parameters and without rows.
    Result<void> execute(const QString &sql);
    /// The first column of the first row of a statement, as an integer.
    Result<std::int64_t> number(const QString &sql) const;

    /// Writes the log back into the file, so that the closed project is one file again.
    void checkpoint() const;

private:
    friend class Transaction;
    ProjectConnection(std::filesystem::path file, QString name);
    Result<void> configure(DatabaseAccess access);

    std::filesystem::path m_file;
    const OpenProjectFile m_open{m_file};
    QString m_name;
    std::shared_ptr<std::recursive_mutex> m_turn;
    QSqlDatabase m_database;
    int m_transactionDepth = 0;
};

/// One prepared statement. Parameters are bound in the order of the question marks.
class Statement
{
public:
    Statement(const ProjectConnection &connection, const QString &sql);

    Statement &bind(std::int64_t value);
    Statement &bind(int value) { return bind(static_cast<std::int64_t>(value)); }
    Statement &bind(double value);
    Statement &bind(const std::string &value);
    Statement &bind(const QByteArray &value);
    Statement &bind(const std::optional<double> &value);
    /// An id, stored as NULL when it is 0.
    Statement &bindReference(RecordId id);

    /// Runs a statement that gives no rows.
    Result<void> run();
    /// Runs, and calls the function for each row until it fails.
    Result<void> eachRow(const std::function<Result<void>(const Statement &)> &row);
    /// Runs, and tells whether there is a first row, which can then be read.
    Result<bool> firstRow();

    std::int64_t integer(int column) const;
    int smallInteger(int column) const; ///< 0 when it does not fit
    double real(int column) const;
    std::optional<double> optionalReal(int column) const;
    std::string text(int column) const;
    QByteArray blob(int column) const;
    RecordId insertedId() const;

private:
    Result<void> start();
    tl::unexpected<Error> failure() const;

    const ProjectConnection &m_connection;
    QSqlQuery m_query;
    bool m_prepared = false;
    bool m_finite = true;
    int m_bound = 0;
};

/// A transaction that rolls back unless it was committed. Inside another one it is a savepoint of it.
class Transaction
{
public:
    explicit Transaction(ProjectConnection &connection) : m_connection(connection) {}
    ~Transaction();
    Transaction(const Transaction &) = delete;
    Transaction &operator=(const Transaction &) = delete;
    Result<void> begin();
    Result<void> commit();

private:
    void rollBack();

    ProjectConnection &m_connection;
    std::unique_lock<std::recursive_mutex> m_turn;
    bool m_open = false;
    int m_depth = 0;
};

/// Runs work, which gives a Result, in one transaction that is rolled back when it fails.
template <class Work>
auto transact(ProjectConnection &connection, const Work &work) -> decltype(work())
{
    Transaction transaction(connection);
    if (auto begun = transaction.begin(); !begun)
        return tl::unexpected(begun.error());
    auto outcome = work();
    if (!outcome)
        return outcome;
    if (auto committed = transaction.commit(); !committed)
        return tl::unexpected(committed.error());
    return outcome;
}

} // namespace odo
