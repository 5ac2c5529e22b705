// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/connection.h"

#include "core/base/file_system.h"
#include "core/project/internal/statement.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/write_ahead_log.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QUrl>
#include <atomic>
#include <new>
#include <sqlite3.h>
#include <utility>

namespace odo {

namespace {

QString toQString(const std::filesystem::path &path)
{
    return QString::fromStdString(path.string());
}

/// SQLite's own. The header holds a LogMark in the place of a size that it would take instead.
constexpr const char *usualCache = "PRAGMA cache_size=-2000";

/// A file: address, in which ?, # and % of the path are kept apart from the options.
QString immutableAddress(const std::filesystem::path &file)
{
    const QByteArray path = QUrl::toPercentEncoding(toQString(file), QByteArrayLiteral("/"));
    return QStringLiteral("file:") + QString::fromLatin1(path) + QStringLiteral("?immutable=1");
}

} // namespace

ProjectConnection::ProjectConnection(std::filesystem::path file, QString name, DatabaseAccess access)
    : m_file(std::move(file)), m_name(std::move(name)), m_access(access), m_turn(WriteTurn::of(m_file))
{
}

Result<std::unique_ptr<ProjectConnection>> ProjectConnection::open(const std::filesystem::path &file,
                                                                   DatabaseAccess access)
{
    return openAt(file, file, access);
}

/// location: of the database that is read as the file.
Result<std::unique_ptr<ProjectConnection>> ProjectConnection::openAt(const std::filesystem::path &location,
                                                                     const std::filesystem::path &file,
                                                                     DatabaseAccess access)
{
    static std::atomic<int> count = 0;
    const QString name = QStringLiteral("odograph-%1").arg(++count);
    std::unique_ptr<ProjectConnection> connection(new ProjectConnection(file, name, access));
    connection->m_database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
    QSqlDatabase &database = connection->m_database;
    QString options = QStringLiteral("QSQLITE_BUSY_TIMEOUT=5000");
    if (access == DatabaseAccess::ReadOnly || access == DatabaseAccess::Immutable)
        options += QStringLiteral(";QSQLITE_OPEN_READONLY");
    if (access == DatabaseAccess::Immutable)
        options += QStringLiteral(";QSQLITE_OPEN_URI");
    database.setConnectOptions(options);
    database.setDatabaseName(access == DatabaseAccess::Immutable ? immutableAddress(location)
                                                                 : toQString(location));
    if (!database.open()) {
        const SqliteRefusal reason = sqliteRefusal(database.lastError().nativeErrorCode().toInt(), 0);
        return fail(reason.code, connection->subject(), reason.why, reason.advice);
    }
    ODO_TRY(connection->configure());
    connection->m_opened = identityOf(location).value_or(FileIdentity());
    return connection;
}

namespace {

/// Whether SQLite cannot read it for want of a log or of the log's index, which it could not make.
bool lacksItsLog(const ProjectConnection &connection)
{
    if (connection.number(QStringLiteral("SELECT COUNT(*) FROM sqlite_master")))
        return false;
    const int code = sqlite3_errcode(connection.handle()) & 0xff;
    return code == SQLITE_CANTOPEN || code == SQLITE_READONLY || code == SQLITE_FULL || code == SQLITE_IOERR;
}

bool isWritable(const std::filesystem::path &file)
{
    return !checkAccess(file, FileAccess::Write) && !checkAccess(file.parent_path(), FileAccess::Write);
}

} // namespace

Result<std::unique_ptr<ProjectConnection>>
ProjectConnection::openForReading(const std::filesystem::path &file)
{
    const std::filesystem::path real = files::realPath(file);
    if (isWritable(real)) {
        auto connection = open(file, DatabaseAccess::QueryOnly);
        if (!connection || !lacksItsLog(**connection))
            return connection;
    }
    if (!hasLog(file))
        return open(file, DatabaseAccess::Immutable);
    auto connection = open(file, DatabaseAccess::ReadOnly);
    if (connection && !lacksItsLog(**connection))
        return connection;
    auto copy = ODO_TRY(LogCopy::make(real));
    connection = openAt(copy->file(), file, DatabaseAccess::QueryOnly);
    if (connection)
        (*connection)->m_copy = std::move(copy);
    return connection;
}

namespace {

/// A project may come from anyone: its schema is data, not trusted code, and what is larger than anything of
/// ours is refused before it takes time and memory (https://www.sqlite.org/security.html).
void harden(sqlite3 *handle)
{
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    for (const int allowed :
         {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION,
          SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML})
        sqlite3_db_config(handle, allowed, 0, nullptr);
    constexpr std::pair<int, int> limits[] = {{SQLITE_LIMIT_LENGTH, 512 * 1024 * 1024},
                                              {SQLITE_LIMIT_SQL_LENGTH, 100'000},
                                              {SQLITE_LIMIT_COLUMN, 100},
                                              {SQLITE_LIMIT_EXPR_DEPTH, 100},
                                              {SQLITE_LIMIT_COMPOUND_SELECT, 10},
                                              {SQLITE_LIMIT_VDBE_OP, 250'000},
                                              {SQLITE_LIMIT_FUNCTION_ARG, 16},
                                              {SQLITE_LIMIT_ATTACHED, 1},
                                              {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 1000},
                                              {SQLITE_LIMIT_VARIABLE_NUMBER, 1000},
                                              {SQLITE_LIMIT_TRIGGER_DEPTH, 10},
                                              {SQLITE_LIMIT_WORKER_THREADS, 0}};
    for (const auto &[limit, most] : limits)
        sqlite3_limit(handle, limit, most);
}

} // namespace

Result<void> ProjectConnection::configure()
{
    if (m_access == DatabaseAccess::ReadWrite && sqlite3_db_readonly(handle(), "main") == 1)
        return fail(ErrorCode::ReadOnly, subject(), cannotBeWrittenTo(), copyToWritableFolder());
    harden(handle());
    for (const char *pragma :
         {"PRAGMA trusted_schema=OFF", "PRAGMA cell_size_check=ON", "PRAGMA mmap_size=0",
          "PRAGMA temp_store=MEMORY", "PRAGMA foreign_keys=ON", "PRAGMA synchronous=FULL", usualCache}) {
        ODO_TRY(execute(QString::fromLatin1(pragma)));
    }
    return m_access == DatabaseAccess::QueryOnly ? execute(QStringLiteral("PRAGMA query_only=ON"))
                                                 : Result<void>();
}

ProjectConnection::~ProjectConnection()
{
    HeldTurn turn; // the last one to be closed writes the log back
    if (m_access == DatabaseAccess::ReadWrite)
        turn = HeldTurn(writeTurn());
    if (m_database.isOpen() && turn.isHeld())
        noteStamp();
    const bool isLogUseless = m_database.isOpen() && turn.isHeld() && hasUselessLog();
    if (m_database.isOpen() && !mayRemoveLog(turn))
        sqlite3_db_config(handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    m_database.close();
    if (isLogUseless)
        removeLog();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

/// When this is the last connection to be closed. A reader writes nothing, and beside a file that replaced
/// this one, the log may belong to that one.
bool ProjectConnection::mayRemoveLog(const HeldTurn &turn) const noexcept
{
    try {
        return isInPlace() && !m_isOverwritten &&
               (m_access == DatabaseAccess::QueryOnly ? !hasLog(m_file) : turn.isHeld());
    } catch (const std::bad_alloc &) {
        return false;
    }
}

sqlite3 *ProjectConnection::handle() const
{
    const QVariant handle = m_database.driver()->handle();
    return *static_cast<sqlite3 *const *>(handle.constData());
}

Message ProjectConnection::subject() const
{
    return projectSubject(m_file.filename());
}

Result<void> ProjectConnection::execute(const QString &sql) const
{
    return Statement(*this, sql).run();
}

Result<std::int64_t> ProjectConnection::number(const QString &sql) const
{
    Statement statement(*this, sql);
    const auto found = ODO_TRY(statement.firstRow());
    return found ? statement.integer(0) : 0;
}

Result<HeldTurn> ProjectConnection::takeTurn(std::chrono::milliseconds patience) const
{
    HeldTurn turn(writeTurn(), patience);
    if (turn.isHeld())
        return turn;
    const SqliteRefusal reason = sqliteRefusal(SQLITE_BUSY, 0);
    return fail(reason.code, subject(), reason.why, reason.advice);
}

bool ProjectConnection::isInPlace() const
{
    int hasMoved = 0;
    return m_copy || sqlite3_file_control(handle(), "main", SQLITE_FCNTL_HAS_MOVED, &hasMoved) != SQLITE_OK ||
           hasMoved == 0;
}

void ProjectConnection::watchForOverwriting() const
{
    if (number(QStringLiteral("PRAGMA user_version"))) // reads, so that there is an account
        m_stamp = fileStamp(handle(), m_file);
}

/// In the turn.
void ProjectConnection::noteStamp() const
{
    if (!m_stamp || m_isOverwritten)
        return;
    const auto stamp = fileStamp(handle(), m_file);
    m_isOverwritten = stamp && stamp->isOverwrittenSince(*m_stamp) && isInPlace();
    m_stamp = stamp;
}

bool ProjectConnection::isOverwritten() const
{
    if (const HeldTurn turn = HeldTurn::ifFree(writeTurn()); turn.isHeld())
        noteStamp();
    return m_isOverwritten;
}

/// That of a file that was written over, for whoever opens it next would write the log into what it holds
/// now; and the empty one of a file that is gone.
bool ProjectConnection::hasUselessLog() const noexcept
{
    try {
        return m_isOverwritten ? hasLog(m_file) : !isInPlace() && !files::exists(m_file) && !hasLog(m_file);
    } catch (const std::bad_alloc &) {
        return false;
    }
}

void ProjectConnection::removeLog() const noexcept
{
    try {
        std::error_code problem;
        for (const char *suffix : {logSuffix, logIndexSuffix})
            files::remove(besideFile(files::realPath(m_file), suffix), problem);
    } catch (const std::bad_alloc &) { // it stays
    }
}

std::optional<std::filesystem::path> ProjectConnection::currentLocation() const
{
    return pathOfOpenFile(m_opened);
}

bool ProjectConnection::checkpoint(Checkpoint how) const
{
    const HeldTurn turn(writeTurn());
    if (!turn.isHeld())
        return false;
    noteStamp();
    if (m_isOverwritten)
        return false;
    int logged = 0, written = 0; // -1 where there is no log
    const int mode = how == Checkpoint::Passing ? SQLITE_CHECKPOINT_PASSIVE : SQLITE_CHECKPOINT_TRUNCATE;
    const bool isDone = sqlite3_wal_checkpoint_v2(handle(), "main", mode, &logged, &written) == SQLITE_OK &&
                        logged == written;
    noteStamp();
    return isDone;
}

Result<void> ProjectConnection::setLogMark(LogMark mark) const
{
    ODO_TRY(execute(QStringLiteral("PRAGMA default_cache_size=%1").arg(mark)));
    return execute(QString::fromLatin1(usualCache));
}

/// In a transaction that has changed rows, before it is committed: its log belongs to this state of the file.
Result<void> ProjectConnection::markLog() const
{
    const auto before = ODO_TRY(number(QStringLiteral("PRAGMA default_cache_size")));
    // below zero: SQLite's own size, for want of a mark
    return setLogMark(nextLogMark(before > 0 ? static_cast<LogMark>(before) : 0));
}

void ProjectConnection::countChanges() const
{
    const std::int64_t rows = sqlite3_total_changes64(handle());
    if (std::exchange(m_countedRows, rows) != rows)
        writeTurn().countChange();
}

} // namespace odo
