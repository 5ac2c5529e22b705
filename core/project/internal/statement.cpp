// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/statement.h"

#include "core/base/shortage.h"
#include "core/files/file_words.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/message_json.h"
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

Statement &Statement::bind(const std::optional<TimeSpan> &span)
{
    if (span)
        return bind(static_cast<std::int64_t>(span->begin.count()))
            .bind(static_cast<std::int64_t>(span->end.count()));
    return bindReference(0).bindReference(0);
}

Result<void> Statement::start()
{
    if (!m_inRange)
        return fail(ErrorCode::InvalidInput, m_connection.subject(),
                    ODO_TEXT("project.no_ordinary_number", "a value to store is too large or not a number"),
                    ODO_TEXT("project.check_its_input", "check the input that it was computed from"));
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
    ODO_TRY(m_connection.execute(QStringLiteral("BEGIN IMMEDIATE")));
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
    const auto turn = ODO_TRY(m_connection.takeTurn());
    const bool isAlone =
        sqlite3_get_autocommit(m_connection.handle()) != 0 && m_connection.m_transactionDepth == 0;
    auto done = isAlone && changesRows(m_query) ? runAlone() : start();
    if (m_connection.m_transactionDepth == 0) // else its end counts them
        m_connection.countChanges();
    return done;
}

Result<void> Statement::eachRow(const std::function<Result<void>(const Statement &)> &row)
{
    ODO_TRY(start());
    while (m_query.next())
        ODO_TRY(row(*this));
    if (m_query.lastError().isValid())
        return failure();
    return {};
}

Result<bool> Statement::firstRow()
{
    ODO_TRY(start());
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
    return fail(reason.code, m_connection.subject(),
                reason.code == ErrorCode::Internal
                    ? ODO_TEXT("project.database_refused_because", "the database reported an error (%1)")(
                          foreignWords(error.databaseText().toStdString()))
                    : reason.why,
                reason.advice);
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

std::optional<TimeSpan> Statement::span(int column) const
{
    const TimeSpan span{Nanoseconds(integer(column)), Nanoseconds(integer(column + 1))};
    const bool isSpan = !m_query.isNull(column) && !m_query.isNull(column + 1) && span.begin.count() >= 0 &&
                        span.begin < span.end;
    return isSpan ? std::optional(span) : std::nullopt;
}

std::string Statement::text(int column) const
{
    return firstCharacters(m_query.value(column).toString(), maxTextLength).toStdString();
}
std::string Statement::name(int column) const
{
    return shownName(m_query.value(column).toString());
}
Statement &Statement::bind(const Message &value)
{
    return bind(storedMessage(value));
}

Message Statement::message(int column) const
{
    constexpr qsizetype longest = 20 * maxTextLength; // of ours, by far
    const QString stored = m_query.value(column).toString();
    return messageFromStored(
        (stored.size() > longest ? firstCharacters(stored, maxTextLength) : stored).toStdString());
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
Result<void> Transaction::checkPosition() const
{
    if (m_depth > 0)
        return {};
    m_connection.noteStamp();
    if (m_connection.m_isOverwritten)
        return fail(
            ErrorCode::Unavailable, m_connection.subject(),
            ODO_TEXT("project.written_over", "another program wrote over its file while it was open; "
                                             "nothing more was stored"),
            ODO_TEXT("project.open_again",
                     "open it again; if you were recording, find stray files (odograph check --adopt)"));
    if (!m_connection.m_keepsWritingWhenLost && !m_connection.isInPlace())
        return fail(ErrorCode::Unavailable, m_connection.subject(),
                    ODO_TEXT("project.file_lost",
                             "its file was deleted, renamed or replaced while it was open; "
                             "nothing was stored"),
                    ODO_TEXT("project.put_back_and_retry", "move it back to its folder and try again"));
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
        return fail(ErrorCode::Io, m_connection.subject(),
                    ODO_TEXT("project.earlier_step_failed", "an earlier step of this change failed"),
                    ODO_TEXT("project.try_change_again", "try the whole change again"));
    m_turn = ODO_TRY(m_connection.takeTurn());
    ODO_TRY(checkPosition());
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
    if (auto inPlace = checkPosition(); !inPlace) {
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

/// SQLite needs files and memory but reports a shortage of neither.
SqliteRefusal unlessShort(SqliteRefusal reason)
{
    const MessageText *shortage = shortageNowOfSystem();
    return shortage ? SqliteRefusal{ErrorCode::Unavailable, *shortage, shortageAdvice()} : reason;
}

SqliteRefusal unknownRefusal()
{
    return {ErrorCode::Internal, ODO_TEXT("project.database_refused", "the database reported an error"),
            runProjectCheck()};
}

SqliteRefusal fullDisk()
{
    return {ErrorCode::Io, ODO_TEXT("project.disk_full", "the disk is full, the change was not saved"),
            freeDiskSpace()};
}

} // namespace

SqliteRefusal sqliteRefusal(int resultCode, int systemError)
{
    switch (resultCode & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL: // it came too often between others that lock
        return {ErrorCode::Io, anotherProgramWrites(), closeOtherProgram()};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return {ErrorCode::ReadOnly, cannotBeWrittenTo(), copyToWritableFolder()};
    case SQLITE_CANTOPEN:
        return unlessShort({ErrorCode::ReadOnly,
                            ODO_TEXT("project.folder_read_only", "its folder cannot be written to"),
                            copyToWritableFolder()});
    case SQLITE_FULL:
        return fullDisk();
    case SQLITE_IOERR:
        if (systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG)
            return fullDisk();
        if (systemError == EROFS)
            return {
                ErrorCode::Io,
                ODO_TEXT("project.disk_read_only", "the disk has become read-only, the change was not saved"),
                copyToAnotherDisk()};
        if (resultCode == SQLITE_IOERR_READ || resultCode == SQLITE_IOERR_CORRUPTFS) // what EIO is to it
            return {ErrorCode::Io, diskCannotBeRead(), copyToAnotherDisk()};
        return unlessShort(
            {ErrorCode::Io,
             ODO_TEXT("project.disk_error", "the disk reported an error, the change was not saved"),
             copyToAnotherDisk()});
    case SQLITE_NOMEM:
    case SQLITE_OK: // Qt failed by itself
        return unlessShort(unknownRefusal());
    case SQLITE_CORRUPT:
    case SQLITE_INTERRUPT: // by a StepLimit
        return {ErrorCode::InvalidInput, fileIsDamaged(), restoreFile()};
    case SQLITE_NOTADB:
        return {ErrorCode::InvalidInput, isNoProject(), chooseOurFile()};
    case SQLITE_CONSTRAINT:
        return {ErrorCode::InvalidInput,
                ODO_TEXT("project.refers_to_nothing",
                         "it refers to something missing from the project, or a value is missing"),
                ODO_TEXT("project.add_what_it_refers_to", "add what it refers to first")};
    case SQLITE_TOOBIG:
        return {ErrorCode::InvalidInput, ODO_TEXT("project.value_too_large", "a value is too large to store"),
                ODO_TEXT("project.split_recording", "split the recording into shorter ones")};
    default:
        return unknownRefusal();
    }
}

} // namespace odo
