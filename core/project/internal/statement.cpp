// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/statement.h"

#include "core/base/shortage.h"
#include "core/project/internal/connection.h"
#include "core/project/names.h"

#include <QSqlError>
#include <QSqlResult>
#include <algorithm>
#include <cerrno>
#include <limits>
#include <sqlite3.h>

namespace odo {

// Statement and Transaction, which belong to a ProjectConnection.

Statement::Statement(const ProjectConnection &connection, const QString &sql)
    : m_connection(connection), m_query(connection.database()), m_prepared(m_query.prepare(sql))
{
    m_query.setForwardOnly(true);
}

Statement &Statement::bind(std::int64_t value)
{
    m_query.bindValue(m_bound++, QVariant(static_cast<qlonglong>(value)));
    return *this;
}

Statement &Statement::bind(double value)
{
    // SQLite would turn NaN into NULL without a word.
    m_inRange = m_inRange && std::abs(value) <= largestNumber;
    m_query.bindValue(m_bound++, QVariant(value));
    return *this;
}

Statement &Statement::bind(const std::string &value)
{
    // A null QString would become NULL, an empty one stays a text.
    m_query.bindValue(m_bound++, value.empty() ? QStringLiteral("") : QString::fromStdString(value));
    return *this;
}

Statement &Statement::bind(const QByteArray &value)
{
    m_query.bindValue(m_bound++, value);
    return *this;
}

Statement &Statement::bind(const std::optional<double> &value)
{
    if (value)
        return bind(*value);
    m_query.bindValue(m_bound++, QVariant(QMetaType::fromType<double>()));
    return *this;
}

Statement &Statement::bindReference(RecordId id)
{
    if (id != 0)
        return bind(id);
    m_query.bindValue(m_bound++, QVariant(QMetaType::fromType<qlonglong>()));
    return *this;
}

Result<void> Statement::start()
{
    if (!m_inRange)
        return fail(ErrorCode::InvalidInput, m_connection.displayName(),
                    "a value to be stored is not a number of ordinary size",
                    "check the input that it was computed from");
    if (!m_prepared || !m_query.exec())
        return failure();
    return {};
}

namespace {

bool changesNothing(const QSqlQuery &query)
{
    const QVariant handle = query.result()->handle();
    return sqlite3_stmt_readonly(*static_cast<sqlite3_stmt *const *>(handle.constData())) != 0;
}

/// Ours are written in capitals; what begins or ends a transaction, or changes a setting, changes no rows.
bool changesRows(const QSqlQuery &query)
{
    const QString sql = query.lastQuery();
    return sql.startsWith(QLatin1String("INSERT")) || sql.startsWith(QLatin1String("UPDATE")) ||
           sql.startsWith(QLatin1String("DELETE"));
}

} // namespace

/// A statement outside of a transaction, in one of its own: its change gets a mark too.
Result<void> Statement::runAlone()
{
    if (auto begun = m_connection.execute(QStringLiteral("BEGIN IMMEDIATE")); !begun)
        return begun;
    const std::int64_t rowsBefore = sqlite3_total_changes64(m_connection.handle());
    auto done = start();
    if (done && sqlite3_total_changes64(m_connection.handle()) != rowsBefore)
        done = m_connection.markLog();
    if (done)
        done = m_connection.execute(QStringLiteral("COMMIT"));
    if (!done && sqlite3_get_autocommit(m_connection.handle()) == 0)
        static_cast<void>(m_connection.execute(QStringLiteral("ROLLBACK")));
    return done;
}

Result<void> Statement::run()
{
    if (!m_prepared || changesNothing(m_query))
        return start();
    const auto turn = m_connection.takeTurn();
    if (!turn)
        return tl::unexpected(turn.error());
    const bool isAlone =
        sqlite3_get_autocommit(m_connection.handle()) != 0 && m_connection.m_transactionDepth == 0;
    auto done = isAlone && changesRows(m_query) ? runAlone() : start();
    if (m_connection.m_transactionDepth == 0) // else its end counts them
        m_connection.countChanges();
    return done;
}

Result<void> Statement::eachRow(const std::function<Result<void>(const Statement &)> &row)
{
    if (auto started = start(); !started)
        return started;
    while (m_query.next()) {
        if (auto done = row(*this); !done)
            return done;
    }
    if (m_query.lastError().isValid())
        return failure();
    return {};
}

Result<bool> Statement::firstRow()
{
    if (auto started = start(); !started)
        return tl::unexpected(started.error());
    if (m_query.next())
        return true;
    if (m_query.lastError().isValid())
        return failure();
    return false;
}

tl::unexpected<Error> Statement::failure() const
{
    const QSqlError error = m_query.lastError();
    const SqliteRefusal reason =
        sqliteRefusal(error.nativeErrorCode().toInt(), sqlite3_system_errno(m_connection.handle()));
    std::string why = reason.why;
    if (reason.code == ErrorCode::Internal)
        why += " (" + error.databaseText().toStdString() + ")";
    return fail(reason.code, m_connection.displayName(), why, reason.advice);
}

std::int64_t Statement::integer(int column) const
{
    return m_query.value(column).toLongLong();
}

int Statement::smallInteger(int column) const
{
    const std::int64_t value = integer(column);
    using Limits = std::numeric_limits<int>;
    return value < Limits::min() || value > Limits::max() ? 0 : static_cast<int>(value);
}

double Statement::real(int column) const
{
    return bounded(m_query.value(column).toDouble());
}

std::optional<double> Statement::optionalReal(int column) const
{
    if (m_query.isNull(column))
        return std::nullopt;
    return real(column);
}

std::string Statement::text(int column) const
{
    return firstCharacters(m_query.value(column).toString(), maxTextLength).toStdString();
}
std::string Statement::name(int column) const
{
    return shownName(m_query.value(column).toString());
}
QByteArray Statement::blob(int column) const
{
    return m_query.value(column).toByteArray();
}
RecordId Statement::insertedId() const
{
    return m_query.lastInsertId().toLongLong();
}

/// In the turn, of the outermost: whether what is stored gets to where the project was opened.
Result<void> Transaction::checkPlace() const
{
    if (m_depth > 0)
        return {};
    m_connection.noteStamp();
    if (m_connection.m_isOverwritten)
        return fail(ErrorCode::Unavailable, m_connection.displayName(),
                    "another program wrote over its file while it was open; nothing more was stored",
                    "open it again; if you were recording, look for stray files (odograph check --adopt)");
    if (!m_connection.m_keepsWritingWhenLost && !m_connection.isInPlace())
        return fail(ErrorCode::Unavailable, m_connection.displayName(),
                    "its file was deleted, renamed or replaced while it was open; nothing was stored",
                    "put it back in its place and try again");
    return {};
}

/// Before the outermost is committed.
Result<void> Transaction::mark() const
{
    // SQLite has rolled back by itself
    const bool isOver = sqlite3_get_autocommit(m_connection.handle()) != 0;
    return m_depth > 0 || isOver || sqlite3_total_changes64(m_connection.handle()) == m_rowsBefore
               ? Result<void>()
               : m_connection.markLog();
}

Result<void> Transaction::begin()
{
    m_depth = m_connection.m_transactionDepth;
    // An error such as a full disk makes SQLite end the outer transaction by itself: nothing may follow in
    // it.
    if (m_depth > 0 && sqlite3_get_autocommit(m_connection.handle()) != 0)
        return fail(ErrorCode::Io, m_connection.displayName(), "an earlier step of this change failed",
                    "try the whole change again");
    auto turn = m_connection.takeTurn();
    if (!turn)
        return tl::unexpected(turn.error());
    m_turn = std::move(*turn);
    if (auto inPlace = checkPlace(); !inPlace)
        return inPlace;
    const QString sql =
        m_depth == 0 ? QStringLiteral("BEGIN IMMEDIATE") : QStringLiteral("SAVEPOINT step%1").arg(m_depth);
    if (auto begun = m_connection.execute(sql); !begun) {
        m_turn.giveUp();
        return begun;
    }
    m_open = true;
    m_rowsBefore = sqlite3_total_changes64(m_connection.handle());
    ++m_connection.m_transactionDepth;
    return {};
}

Result<void> Transaction::commit()
{
    if (auto inPlace = checkPlace(); !inPlace) {
        rollBack();
        return inPlace;
    }
    if (auto marked = mark(); !marked) {
        rollBack();
        return marked;
    }
    const QString sql =
        m_depth == 0 ? QStringLiteral("COMMIT") : QStringLiteral("RELEASE step%1").arg(m_depth);
    if (auto done = m_connection.execute(sql); !done) {
        rollBack();
        return done;
    }
    m_open = false;
    if (--m_connection.m_transactionDepth == 0) {
        m_connection.countChanges();
        m_connection.noteStamp();
    }
    m_turn.giveUp();
    return {};
}

Transaction::~Transaction()
{
    if (m_open)
        rollBack();
}

void Transaction::rollBack()
{
    const HeldTurn turn = std::move(m_turn); // until it is rolled back
    m_open = false;
    --m_connection.m_transactionDepth;
    if (sqlite3_get_autocommit(m_connection.handle()) != 0)
        return; // SQLite has rolled back by itself
    if (m_depth == 0) {
        static_cast<void>(m_connection.execute(QStringLiteral("ROLLBACK")));
        return;
    }
    static_cast<void>(m_connection.execute(QStringLiteral("ROLLBACK TO step%1").arg(m_depth)));
    static_cast<void>(m_connection.execute(QStringLiteral("RELEASE step%1").arg(m_depth)));
}

namespace {

/// SQLite asks for files and memory and tells of neither.
SqliteRefusal unlessShort(const SqliteRefusal &reason)
{
    const char *shortage = shortageNowOfSystem();
    return shortage ? SqliteRefusal{ErrorCode::Unavailable, shortage, shortageAdvice} : reason;
}

} // namespace

SqliteRefusal sqliteRefusal(int resultCode, int systemError)
{
    constexpr SqliteRefusal unknown{ErrorCode::Internal, "the database refused",
                                    "run a check of the project"};
    constexpr SqliteRefusal full{ErrorCode::Io, "the disk is full, the change was not saved",
                                 "make room on the disk and try again"};
    switch (resultCode & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL: // it came too often between others that lock
        return {ErrorCode::Io, "another program is writing to it", "close the other program and try again"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return {ErrorCode::ReadOnly, "it cannot be written to",
                "copy it to a folder that you may write to, and open the copy"};
    case SQLITE_CANTOPEN:
        return unlessShort({ErrorCode::ReadOnly, "its folder cannot be written to",
                            "copy it to a folder that you may write to, and open the copy"});
    case SQLITE_FULL:
        return full;
    case SQLITE_IOERR:
        if (systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG)
            return full;
        if (systemError == EROFS)
            return {ErrorCode::Io, "the disk has become read-only, the change was not saved",
                    "check the disk, and copy the project to another one"};
        if (resultCode == SQLITE_IOERR_READ || resultCode == SQLITE_IOERR_CORRUPTFS) // what EIO is to it
            return {ErrorCode::Io, "the disk could not be read, and nothing was changed",
                    "check the disk, and copy the project to another one"};
        return unlessShort({ErrorCode::Io, "the disk reported an error, the change was not saved",
                            "check the disk, and copy the project to another one"});
    case SQLITE_NOMEM:
    case SQLITE_OK: // Qt failed by itself
        return unlessShort(unknown);
    case SQLITE_CORRUPT:
    case SQLITE_INTERRUPT: // by a StepLimit
        return {ErrorCode::InvalidInput, "the file is damaged", "restore it from a backup copy"};
    case SQLITE_NOTADB:
        return {ErrorCode::InvalidInput, "it is not a project file",
                "choose a file that Odograph has written"};
    case SQLITE_CONSTRAINT:
        return {ErrorCode::InvalidInput,
                "it refers to something that is not in the project, or a value is missing",
                "add what it refers to first"};
    case SQLITE_TOOBIG:
        return {ErrorCode::InvalidInput, "a value is too large to be stored",
                "split the recording into shorter ones"};
    default:
        return unknown;
    }
}

} // namespace odo
