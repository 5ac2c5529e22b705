// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/protected_files.h"
#include "core/project/project_locks.h"
#include "core/project/records.h"
#include "core/project/write_ahead_log.h"

#include <QByteArray>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

struct sqlite3;

namespace odo {

/// How a database file is opened.
enum class DatabaseAccess {
    ReadWrite,
    QueryOnly, ///< with SQLite's locks and log, so that others may write meanwhile; refuses every change
    /// the same where the file or its folder cannot be written to, if the log's index lies there already
    ReadOnly,
    Immutable, ///< without locks; only for a file that nobody changes
};

/// One open SQLite database with the settings that a project needs: foreign keys on, synchronous=FULL, a
/// schema that is not trusted. Private to core/project and its tests; belongs to the thread that opened it.
struct ProjectConnection
{
    /// Errors in words for a person: corrupt, locked, not a database, no write access.
    static Result<std::unique_ptr<ProjectConnection>> open(const std::filesystem::path &file,
                                                           DatabaseAccess access);
    /// For reading, beside others that write. Where SQLite cannot make the index that reading a log takes (in
    /// a folder that cannot be written to, or on a full disk), a copy of file and log is read; file() is the
    /// original all the same.
    static Result<std::unique_ptr<ProjectConnection>> openForReading(const std::filesystem::path &file);
    ~ProjectConnection();
    ProjectConnection(const ProjectConnection &) = delete;
    ProjectConnection &operator=(const ProjectConnection &) = delete;

    const QSqlDatabase &database() const { return m_database; }
    /// SQLite's own handle, for what Qt hides: backup, limits, state of the transaction.
    sqlite3 *handle() const;
    const std::filesystem::path &file() const { return m_file; }
    DatabaseAccess access() const { return m_access; }
    /// Held by whoever writes.
    WriteTurn &writeTurn() const { return *m_turn; }
    /// The turn, or that another program keeps it.
    Result<HeldTurn> takeTurn(std::chrono::milliseconds patience = WriteTurn::usualPatience) const;
    /// From now on changes are also stored where the file is no longer in its place: by who rescues it then.
    /// Else they are refused.
    void keepWritingWhenLost() { m_keepsWritingWhenLost = true; }
    /// Whether the file is still where it was opened: it was not deleted, renamed or replaced. Looks at its
    /// path alone.
    bool isInPlace() const;
    /// Starts to check whether something else writes to the file; of a connection that reads and writes, in
    /// WAL mode.
    void watchForOverwriting() const;
    /// Whether something wrote to the file past SQLite since then (FileStamp). False where somebody has the
    /// turn, who may be writing right now. From then on nothing is written to it here.
    bool isOverwritten() const;
    /// Where the file is now that was opened; nothing where it was deleted.
    std::optional<std::filesystem::path> currentLocation() const;
    /// "project 'run.odo'": how messages name it.
    Message subject() const;

    /// Runs one statement without parameters and without rows.
    Result<void> execute(const QString &sql) const;
    /// The first column of the first row of a statement, as an integer.
    Result<std::int64_t> number(const QString &sql) const;

    /// Begins a history of its own, to which the log of no other file belongs: of a database that nobody else
    /// has open.
    Result<void> beginHistory() const { return setLogMark(newLogMark()); }

    /// How far the log is written back into the file. Passing does what can be done without waiting for those
    /// who read; Emptying waits for them, and makes the log empty.
    enum class Checkpoint { Passing, Emptying };
    /// True: all of it is in the file now.
    bool checkpoint(Checkpoint how) const;

private:
    friend class Transaction;
    friend class Statement;
    ProjectConnection(std::filesystem::path file, QString name, DatabaseAccess access);
    static Result<std::unique_ptr<ProjectConnection>>
    openAt(const std::filesystem::path &location, const std::filesystem::path &file, DatabaseAccess access);
    Result<void> configure();
    bool mayRemoveLog(const HeldTurn &turn) const noexcept;
    void noteStamp() const;
    bool hasUselessLog() const noexcept;
    void removeLog() const noexcept;
    void countChanges() const;
    Result<void> setLogMark(LogMark mark) const;
    Result<void> markLog() const;

    std::filesystem::path m_file;
    const OpenProjectFile m_open{m_file};
    QString m_name;
    DatabaseAccess m_access;
    std::shared_ptr<WriteTurn> m_turn;
    std::unique_ptr<LogCopy> m_copy; ///< what is read in the place of the file
    QSqlDatabase m_database;
    int m_transactionDepth = 0;
    FileIdentity m_opened;                    ///< of the file when it was opened
    mutable std::optional<FileStamp> m_stamp; ///< at the last look
    mutable bool m_isOverwritten = false;
    bool m_keepsWritingWhenLost = false;
    mutable std::int64_t m_countedRows = 0; ///< that were changed, as far as they are counted as changes
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
    Statement &bind(const Message &value);
    /// An id, stored as NULL when it is 0.
    Statement &bindReference(RecordId id);
    /// A span as two numbers of nanoseconds, NULL where there is none.
    Statement &bind(const std::optional<TimeSpan> &span);

    /// Runs a statement that gives no rows.
    Result<void> run();
    /// Runs, and calls the function for each row until it fails.
    Result<void> eachRow(const std::function<Result<void>(const Statement &)> &row);
    /// Runs, and returns whether there is a first row, which can then be read.
    Result<bool> firstRow();

    std::int64_t integer(int column) const;
    int smallInteger(int column) const; ///< 0 when it does not fit
    double real(int column) const;      ///< within ±largestNumber; 0 for what is no number
    std::optional<double> optionalReal(int column) const;
    /// Of this column and the next; empty for what is no span since the trial's beginning.
    std::optional<TimeSpan> span(int column) const;
    std::string text(int column) const; ///< its first 20,000 characters
    /// A name as it can be shown: of one line, without invisible characters (see plainLine), its first 200
    /// characters.
    std::string name(int column) const;
    Message message(int column) const; ///< as bind() has stored it
    QByteArray blob(int column) const;
    RecordId insertedId() const;

private:
    Result<void> start();
    Result<void> runAlone();
    tl::unexpected<Error> failure() const;

    const ProjectConnection &m_connection;
    QSqlQuery m_query;
    bool m_prepared = false;
    bool m_inRange = true;
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
    Result<void> checkPosition() const;
    Result<void> mark() const;
    void rollBack();

    ProjectConnection &m_connection;
    HeldTurn m_turn;
    bool m_open = false;
    int m_depth = 0;
    std::int64_t m_rowsBefore = 0; ///< that the connection had changed
};

/// Runs work, which gives a Result, in one transaction that is rolled back when it fails.
template <class Work>
auto transact(ProjectConnection &connection, const Work &work) -> decltype(work())
{
    Transaction transaction(connection);
    ODO_TRY(transaction.begin());
    auto outcome = work();
    if (!outcome)
        return outcome;
    ODO_TRY(transaction.commit());
    return outcome;
}

} // namespace odo
