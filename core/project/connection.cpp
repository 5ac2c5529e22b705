// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"

#include "core/base/file_system.h"
#include "core/base/plain_text.h"
#include "core/project/names.h"
#include "core/project/side_files.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QSqlResult>
#include <QUrl>
#include <atomic>
#include <cerrno>
#include <limits>
#include <new>
#include <sqlite3.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

QString toQString(const std::filesystem::path &path)
{
    return QString::fromStdString(path.string());
}

/// A file: address, in which ?, # and % of the path are told apart from the options.
QString immutableAddress(const std::filesystem::path &file)
{
    const QByteArray path = QUrl::toPercentEncoding(toQString(file), QByteArrayLiteral("/"));
    return QStringLiteral("file:") + QString::fromLatin1(path) + QStringLiteral("?immutable=1");
}

struct Explanation
{
    ErrorCode code;
    const char *why, *advice;
};

/// SQLite's result codes in words for a person. systemError: the errno of what it last asked of the system, 0 where that is not known.
Explanation explain(int resultCode, int systemError)
{
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
        return {ErrorCode::ReadOnly, "its folder cannot be written to",
                "copy it to a folder that you may write to, and open the copy"};
    case SQLITE_FULL:
        return {ErrorCode::Io, "the disk is full, the change was not saved",
                "make room on the disk and try again"};
    case SQLITE_IOERR:
        if (systemError == EROFS)
            return {ErrorCode::Io, "the disk has become read-only, the change was not saved",
                    "check the disk, and copy the project to another one"};
        if (resultCode == SQLITE_IOERR_READ || resultCode == SQLITE_IOERR_CORRUPTFS) // what EIO is to it
            return {ErrorCode::Io, "the disk could not be read, and nothing was changed",
                    "check the disk, and copy the project to another one"};
        return {ErrorCode::Io, "the disk reported an error, the change was not saved",
                "check the disk, and copy the project to another one"};
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
        return {ErrorCode::Internal, "the database refused", "run a check of the project"};
    }
}

/// With … in place of the rest of a longer text.
QString firstCharacters(const QString &text, int most)
{
    qsizetype cut = 0, at = 0;
    for (int characters = 0; at < text.size(); ++characters) {
        if (characters == most)
            return text.first(cut) + u'…';
        if (characters < most)
            cut = at;
        at += text.at(at).isHighSurrogate() && at + 1 < text.size() ? 2 : 1;
    }
    return text;
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

/// place: where the database is that is read as the file.
Result<std::unique_ptr<ProjectConnection>> ProjectConnection::openAt(const std::filesystem::path &place, const std::filesystem::path &file,
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
    database.setDatabaseName(access == DatabaseAccess::Immutable ? immutableAddress(place) : toQString(place));
    if (!database.open()) {
        const Explanation reason = explain(database.lastError().nativeErrorCode().toInt(), 0);
        return fail(reason.code, connection->displayName(), reason.why, reason.advice);
    }
    if (auto configured = connection->configure(); !configured)
        return tl::unexpected(configured.error());
    ::stat(place.c_str(), &connection->m_opened);
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
    return ::access(file.c_str(), W_OK) == 0 && ::access(file.parent_path().c_str(), W_OK) == 0;
}

} // namespace

Result<std::unique_ptr<ProjectConnection>> ProjectConnection::openForReading(const std::filesystem::path &file)
{
    const std::filesystem::path real = files::realPath(file);
    if (isWritable(real)) {
        auto connection = open(file, DatabaseAccess::QueryOnly);
        if (!connection || !lacksItsLog(**connection))
            return connection;
    }
    if (!hasLog(real))
        return open(file, DatabaseAccess::Immutable);
    auto connection = open(file, DatabaseAccess::ReadOnly);
    if (connection && !lacksItsLog(**connection))
        return connection;
    auto copy = LogCopy::make(real);
    if (!copy)
        return tl::unexpected(copy.error());
    connection = openAt((*copy)->file(), file, DatabaseAccess::QueryOnly);
    if (connection)
        (*connection)->m_copy = std::move(*copy);
    return connection;
}

namespace {

/// A project may come from anyone: its schema is data, not trusted code, and what is larger than anything of ours is refused
/// before it takes time and memory (https://www.sqlite.org/security.html).
void harden(sqlite3 *handle)
{
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    for (const int allowed : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION,
                              SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML})
        sqlite3_db_config(handle, allowed, 0, nullptr);
    constexpr std::pair<int, int> limits[] = {
        {SQLITE_LIMIT_LENGTH, 512 * 1024 * 1024}, {SQLITE_LIMIT_SQL_LENGTH, 100'000}, {SQLITE_LIMIT_COLUMN, 100},
        {SQLITE_LIMIT_EXPR_DEPTH, 100},           {SQLITE_LIMIT_COMPOUND_SELECT, 10}, {SQLITE_LIMIT_VDBE_OP, 250'000},
        {SQLITE_LIMIT_FUNCTION_ARG, 16},          {SQLITE_LIMIT_ATTACHED, 1},         {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 1000},
        {SQLITE_LIMIT_VARIABLE_NUMBER, 1000},     {SQLITE_LIMIT_TRIGGER_DEPTH, 10},   {SQLITE_LIMIT_WORKER_THREADS, 0}};
    for (const auto &[limit, most] : limits)
        sqlite3_limit(handle, limit, most);
}

} // namespace

Result<void> ProjectConnection::configure()
{
    if (m_access == DatabaseAccess::ReadWrite && sqlite3_db_readonly(handle(), "main") == 1)
        return fail(ErrorCode::ReadOnly, displayName(), "it cannot be written to",
                    "copy it to a folder that you may write to, and open the copy");
    harden(handle());
    for (const char *pragma :
         {"PRAGMA trusted_schema=OFF", "PRAGMA cell_size_check=ON", "PRAGMA mmap_size=0",
          "PRAGMA temp_store=MEMORY", "PRAGMA foreign_keys=ON", "PRAGMA synchronous=FULL"}) {
        if (auto done = execute(QString::fromLatin1(pragma)); !done)
            return done;
    }
    return m_access == DatabaseAccess::QueryOnly ? execute(QStringLiteral("PRAGMA query_only=ON")) : Result<void>();
}

ProjectConnection::~ProjectConnection()
{
    HeldTurn turn; // the last one to be closed writes the log back
    if (m_access == DatabaseAccess::ReadWrite)
        turn = HeldTurn(writeTurn());
    if (m_database.isOpen() && !mayRemoveLog(turn))
        sqlite3_db_config(handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

/// When this is the last connection to be closed. Who only reads writes nothing, and beside a file that took the place of
/// this one the log may be that one's.
bool ProjectConnection::mayRemoveLog(const HeldTurn &turn) const noexcept
{
    try {
        return isInPlace() && (m_access == DatabaseAccess::QueryOnly ? !hasLog(m_file) : turn.isHeld());
    } catch (const std::bad_alloc &) {
        return false;
    }
}

sqlite3 *ProjectConnection::handle() const
{
    const QVariant handle = m_database.driver()->handle();
    return *static_cast<sqlite3 *const *>(handle.constData());
}

std::string ProjectConnection::displayName() const
{
    return "project '" + m_file.filename().string() + "'";
}

Result<void> ProjectConnection::execute(const QString &sql)
{
    return Statement(*this, sql).run();
}

Result<std::int64_t> ProjectConnection::number(const QString &sql) const
{
    Statement statement(*this, sql);
    const auto found = statement.firstRow();
    if (!found)
        return tl::unexpected(found.error());
    return *found ? statement.integer(0) : 0;
}

Result<HeldTurn> ProjectConnection::takeTurn(std::chrono::milliseconds patience) const
{
    HeldTurn turn(writeTurn(), patience);
    if (turn.isHeld())
        return turn;
    const Explanation reason = explain(SQLITE_BUSY, 0);
    return fail(reason.code, displayName(), reason.why, reason.advice);
}

bool ProjectConnection::isInPlace() const
{
    int hasMoved = 0;
    return m_copy || sqlite3_file_control(handle(), "main", SQLITE_FCNTL_HAS_MOVED, &hasMoved) != SQLITE_OK || hasMoved == 0;
}

std::optional<std::filesystem::path> ProjectConnection::presentPlace() const
{
    const std::filesystem::path descriptors("/proc/self/fd");
    std::error_code problem;
    for (const std::string &number : files::namesIn(descriptors, problem)) {
        struct stat there{};
        if (::stat((descriptors / number).c_str(), &there) != 0 || there.st_ino != m_opened.st_ino || there.st_dev != m_opened.st_dev)
            continue;
        std::filesystem::path place = files::linkTarget(descriptors / number, problem);
        return there.st_nlink > 0 && !problem ? std::optional(std::move(place)) : std::nullopt;
    }
    return std::nullopt;
}

bool ProjectConnection::checkpoint(Checkpoint how) const
{
    const HeldTurn turn(writeTurn());
    if (!turn.isHeld())
        return false;
    int logged = 0, written = 0; // -1 where there is no log
    const int mode = how == Checkpoint::Passing ? SQLITE_CHECKPOINT_PASSIVE : SQLITE_CHECKPOINT_TRUNCATE;
    return sqlite3_wal_checkpoint_v2(handle(), "main", mode, &logged, &written) == SQLITE_OK && logged == written;
}

void ProjectConnection::countChanges() const
{
    const std::int64_t rows = sqlite3_total_changes64(handle());
    if (std::exchange(m_countedRows, rows) != rows)
        writeTurn().countChange();
}

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

} // namespace

Result<void> Statement::run()
{
    if (!m_prepared || changesNothing(m_query))
        return start();
    const auto turn = m_connection.takeTurn();
    if (!turn)
        return tl::unexpected(turn.error());
    auto done = start();
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
    const Explanation reason = explain(error.nativeErrorCode().toInt(), sqlite3_system_errno(m_connection.handle()));
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
    // An escaped character is at most eight long, and takes the place of one: no more than this can be shown of it.
    const QString begin = firstCharacters(m_query.value(column).toString(), maxNameLength + 1);
    return firstCharacters(QString::fromStdString(plainLine(begin.toStdString())), maxNameLength).toStdString();
}
QByteArray Statement::blob(int column) const
{
    return m_query.value(column).toByteArray();
}
RecordId Statement::insertedId() const
{
    return m_query.lastInsertId().toLongLong();
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
    const QString sql =
        m_depth == 0 ? QStringLiteral("BEGIN IMMEDIATE") : QStringLiteral("SAVEPOINT step%1").arg(m_depth);
    if (auto begun = m_connection.execute(sql); !begun) {
        m_turn.giveUp();
        return begun;
    }
    m_open = true;
    ++m_connection.m_transactionDepth;
    return {};
}

Result<void> Transaction::commit()
{
    const QString sql =
        m_depth == 0 ? QStringLiteral("COMMIT") : QStringLiteral("RELEASE step%1").arg(m_depth);
    if (auto done = m_connection.execute(sql); !done) {
        rollBack();
        return done;
    }
    m_open = false;
    if (--m_connection.m_transactionDepth == 0)
        m_connection.countChanges();
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

} // namespace odo
