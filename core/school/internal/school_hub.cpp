// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/school_hub.h"

#include "core/project/names.h"
#include "core/school/internal/hub_queries.h"

#include <QFile>
#include <QJsonDocument>
#include <QSqlDriver>
#include <QVariant>
#include <array>
#include <atomic>

/// Outside of any namespace, as the macro wants it.
static void initHubSchema()
{
    Q_INIT_RESOURCE(hub_schema);
}

namespace odo {

namespace {

constexpr std::array migrations{"01_hub", "02_standings", "03_benches"};

QString migrationText(const char *name)
{
    initHubSchema();
    QFile file(QStringLiteral(":/hub/schema/%1.sql").arg(QLatin1String(name)));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the program was built without the schema of the school hub");
    return QString::fromUtf8(file.readAll());
}

/// As libpq reads its parameters; Qt takes the semicolon for a blank.
QString connectOptions(const HubAddress &address)
{
    QString options =
        QStringLiteral("connect_timeout=10;keepalives_idle=20;keepalives_interval=5;keepalives_count=3;"
                       "tcp_user_timeout=30000;application_name=odograph;sslmode=") +
        QString::fromStdString(address.sslMode);
    if (!address.sslRootCert.empty())
        options += QStringLiteral(";sslrootcert='%1'").arg(QString::fromStdString(address.sslRootCert));
    return options;
}

/// The server's own sentence, without its prefix and the statement.
Message serverWords(const QSqlError &error)
{
    QString text = error.databaseText().isEmpty() ? error.driverText() : error.databaseText();
    text = text.section(u'\n', 0, 0);
    for (const QLatin1String prefix : {QLatin1String("ERROR:  "), QLatin1String("FATAL:  ")}) {
        const auto at = text.indexOf(prefix);
        if (at >= 0)
            text.remove(at, prefix.size());
    }
    return foreignWords(text.simplified().toStdString());
}

/// Whether it may pass by itself: the server is away, starting, stopping or full, or somebody else was first.
bool mayPass(const QSqlError &error)
{
    const QString state = error.nativeErrorCode();
    return error.type() == QSqlError::ConnectionError || state.isEmpty() ||
           state.startsWith(QLatin1String("08")) || state.startsWith(QLatin1String("57P")) ||
           state.startsWith(QLatin1String("40")) || state.startsWith(QLatin1String("53"));
}

/// Of opening a connection, of which the driver gives the words alone. libpq says the first in English,
/// whatever its language, and so do most servers the second.
std::optional<Error> passwordError(const QSqlError &error, const Message &what)
{
    const QString text = error.databaseText() + error.driverText();
    const bool gotOne = text.contains(QLatin1String("password authentication failed"));
    if (!gotOne && !text.contains(QLatin1String("no password supplied")))
        return std::nullopt;
    return needsPassword(what, gotOne).value();
}

PublishOutcome::Kind outcomeOf(const QString &word)
{
    using Kind = PublishOutcome::Kind;
    constexpr std::array known{std::pair{"new", Kind::New}, std::pair{"changed", Kind::Changed},
                               std::pair{"conflict", Kind::Conflict}, std::pair{"refused", Kind::Refused}};
    for (const auto &[name, kind] : known) {
        if (word == QLatin1String(name))
            return kind;
    }
    return Kind::Same;
}

} // namespace

SchoolHub::SchoolHub(HubAddress address, QString name)
    : m_address(std::move(address)), m_name(std::move(name))
{
}

SchoolHub::~SchoolHub()
{
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

Result<std::unique_ptr<SchoolHub>> SchoolHub::connect(const HubAddress &address)
{
    static std::atomic<int> count = 0;
    const QString driver = QStringLiteral("QPSQL");
    if (!QSqlDatabase::isDriverAvailable(driver))
        return fail(ErrorCode::NotFound, address.subject(),
                    ODO_TEXT("school.no_driver", "this computer has no driver for PostgreSQL"),
                    ODO_TEXT("school.install_driver", "install the package libqt6sql6-psql"));
    std::unique_ptr<SchoolHub> hub(new SchoolHub(address, QStringLiteral("odograph-hub-%1").arg(++count)));
    hub->m_database = QSqlDatabase::addDatabase(driver, hub->m_name);
    QSqlDatabase &database = hub->m_database;
    database.setHostName(QString::fromStdString(address.host));
    database.setUserName(QString::fromStdString(address.user));
    database.setDatabaseName(QString::fromStdString(address.database));
    if (!address.password.empty())
        database.setPassword(QString::fromStdString(address.password));
    if (address.port > 0)
        database.setPort(address.port);
    database.setConnectOptions(connectOptions(address));
    if (!database.open())
        return hub->failure(database.lastError());
    // libpq would print notices of the server on the standard error output
    ODO_TRY(hub->run({QStringLiteral("SET client_min_messages = error")}));
    return hub;
}

Message tryLater()
{
    return ODO_TEXT("school.publish_later", "try again later; what was not sent yet is kept");
}

tl::unexpected<Error> SchoolHub::failure(const QSqlError &error) const
{
    const bool isOpen = m_database.isOpen();
    const QString state = error.nativeErrorCode();
    const Message what = m_address.subject();
    if (!isOpen)
        if (auto aboutPassword = passwordError(error, what))
            return tl::unexpected(std::move(*aboutPassword));
    if (!isOpen)
        return fail(ErrorCode::Unavailable, what, serverWords(error),
                    ODO_TEXT("school.check_connection",
                             "check the address, the login in ~/.pgpass, and the network; "
                             "what is recorded meanwhile is sent later"));
    if (mayPass(error))
        return fail(ErrorCode::Unavailable, what,
                    ODO_TEXT("school.went_away", "the connection was lost (%1)")(serverWords(error)),
                    tryLater());
    if (state == QLatin1String("42501"))
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("school.not_allowed", "the login may not do that (%1)")(serverWords(error)),
            ODO_TEXT("school.ask_administrator", "ask the hub's administrator for the role that may"));
    return fail(ErrorCode::InvalidInput, what, serverWords(error),
                ODO_TEXT("school.report_to_administrator", "show this to the hub's administrator"));
}

int SchoolHub::newestVersion()
{
    return int(migrations.size());
}

Result<void> SchoolHub::begin()
{
    return m_database.transaction() ? Result<void>() : failure(m_database.lastError());
}

Result<void> SchoolHub::commit()
{
    return m_database.commit() ? Result<void>() : failure(m_database.lastError());
}

/// Several statements; the driver gives an error of a later one only to who asks for its result.
Result<void> SchoolHub::runAll(const QString &sql)
{
    QSqlQuery query(m_database);
    bool isGood = query.exec(sql);
    while (isGood && query.nextResult()) {
    }
    return query.lastError().isValid() ? failure(query.lastError()) : Result<void>();
}

Result<int> SchoolHub::schemaVersion()
{
    QSqlQuery query(m_database);
    if (!query.exec(QStringLiteral("SELECT to_regclass('odograph.hub_version') IS NOT NULL")) ||
        !query.next())
        return failure(query.lastError());
    if (!query.value(0).toBool())
        return 0;
    if (!query.exec(QStringLiteral("SELECT max(version) FROM odograph.hub_version")) || !query.next())
        return failure(query.lastError());
    return query.value(0).toInt();
}

Result<void> SchoolHub::checkSchema(int version) const
{
    if (version == newestVersion())
        return {};
    if (version > newestVersion())
        return fail(
            ErrorCode::NewerFormat, m_address.subject(),
            ODO_TEXT("school.newer_hub",
                     "its schema has version %1, and this Odograph knows up to %2")(version, newestVersion()),
            ODO_TEXT("school.update_program", "update Odograph"));
    return fail(ErrorCode::NotFound, m_address.subject(),
                version == 0
                    ? Message(ODO_TEXT("school.no_hub", "the database has no hub"))
                    : ODO_TEXT("school.older_hub", "its schema has version %1, and this Odograph needs %2")(
                          version, newestVersion()),
                ODO_TEXT("school.run_init", "have its administrator run odograph school init"));
}

Result<int> SchoolHub::upgrade()
{
    auto version = ODO_TRY(schemaVersion());
    if (version > newestVersion())
        ODO_TRY(checkSchema(version));
    for (; version < newestVersion(); ++version) {
        ODO_TRY(begin());
        if (auto done = runAll(migrationText(migrations[std::size_t(version)])); !done) {
            m_database.rollback();
            return tl::unexpected(done.error());
        }
        ODO_TRY(commit());
    }
    return version;
}

Result<std::string> SchoolHub::role()
{
    QSqlQuery query(m_database);
    if (!query.exec(
            QStringLiteral("SELECT rolname FROM pg_roles WHERE rolname IN ('teacher', 'bench', 'viewer') "
                           "AND pg_has_role(current_user, oid, 'USAGE') "
                           "ORDER BY array_position(ARRAY['teacher', 'bench', 'viewer'], rolname::text)")))
        return failure(query.lastError());
    if (!query.next())
        return fail(
            ErrorCode::NotFound, m_address.subject(),
            ODO_TEXT("school.no_role", "the login has none of the roles teacher, bench and viewer"),
            ODO_TEXT("school.grant_role", "have the hub's administrator grant it one: GRANT bench TO login"));
    return query.value(0).toString().toStdString();
}

Result<QSqlQuery> SchoolHub::run(const HubQuery &query)
{
    QSqlQuery rows(m_database);
    rows.setForwardOnly(true);
    bool isGood = query.values.isEmpty() ? rows.exec(query.text) : rows.prepare(query.text);
    if (isGood && !query.values.isEmpty()) {
        for (const QVariant &value : query.values)
            rows.addBindValue(value);
        isGood = rows.exec();
    }
    return isGood ? Result<QSqlQuery>(std::move(rows)) : failure(rows.lastError());
}

Result<PublishOutcome> SchoolHub::publish(const SchoolDocument &document, const std::string &uuid,
                                          const std::string &bench, std::int64_t base, bool isRemoved,
                                          const QJsonObject &standing)
{
    ODO_TRY(begin());
    auto outcome = publishAlone(document, uuid, bench, base, isRemoved);
    if (outcome && !standing.isEmpty()) {
        QJsonObject ofTrial = standing;
        ofTrial[QStringLiteral("trial")] = QString::fromStdString(uuid);
        if (auto set = setStandings(bench, {ofTrial}); !set)
            outcome = tl::unexpected(set.error());
    }
    if (!outcome) {
        m_database.rollback();
        return outcome;
    }
    ODO_TRY(commit());
    return outcome;
}

Result<PublishOutcome> SchoolHub::publishAlone(const SchoolDocument &document, const std::string &uuid,
                                               const std::string &bench, std::int64_t base, bool isRemoved)
{
    const QString results = QString::fromUtf8(QJsonDocument(document.results).toJson(QJsonDocument::Compact));
    auto query = ODO_TRY(run(hubQueries::publish(
        {QString::fromStdString(uuid), QString::fromStdString(schoolKindWord(document.kind)),
         QString::fromStdString(document.name), QString::fromStdString(bench), qint64(base),
         QString::fromStdString(document.sha256), document.body,
         document.recordings.isEmpty() ? QVariant(QMetaType(QMetaType::QByteArray))
                                       : QVariant(document.recordings),
         results, isRemoved})));
    if (!query.next())
        return failure(query.lastError());
    return PublishOutcome{outcomeOf(query.value(0).toString()), query.value(1).toString().toStdString(),
                          query.value(2).toLongLong(), query.value(3).toString().toStdString(),
                          query.value(4).toByteArray()};
}

Result<void> SchoolHub::setStandings(const std::string &bench, const QJsonArray &standings)
{
    ODO_TRY(run(hubQueries::setStandings(
        bench, QString::fromUtf8(QJsonDocument(standings).toJson(QJsonDocument::Compact)))));
    return {};
}

Result<std::vector<HubDocument>> SchoolHub::since(std::int64_t revision, const std::string &bench, int most)
{
    auto query = ODO_TRY(run(hubQueries::since(revision, bench, most)));
    std::vector<HubDocument> documents;
    while (query.next()) {
        HubDocument one;
        one.uuid = query.value(0).toString().toStdString();
        const auto kind = ODO_TRY(schoolKindOf(query.value(1).toString().toStdString()));
        one.document.kind = kind;
        one.document.name = shownName(query.value(2).toString());
        one.owner = query.value(3).toString().toStdString();
        one.revision = query.value(4).toLongLong();
        one.isRemoved = query.value(5).toBool();
        one.document.sha256 = query.value(6).toString().toStdString();
        one.document.body = query.value(7).toByteArray();
        documents.push_back(std::move(one));
    }
    if (query.lastError().isValid())
        return failure(query.lastError());
    return documents;
}

Result<QByteArray> SchoolHub::recordingsOf(const std::string &uuid)
{
    auto query = ODO_TRY(run(hubQueries::recordings(uuid)));
    return query.next() ? query.value(0).toByteArray() : QByteArray();
}

Result<void> SchoolHub::makeDatabase(const HubAddress &address)
{
    HubAddress usual = address;
    usual.database = "postgres";
    const auto server = ODO_TRY(connect(usual));
    QSqlQuery query(server->m_database);
    query.prepare(QStringLiteral("SELECT 1 FROM pg_database WHERE datname = ?"));
    query.addBindValue(QString::fromStdString(address.database));
    if (!query.exec())
        return server->failure(query.lastError());
    if (query.next())
        return {};
    const QString name = server->m_database.driver()->escapeIdentifier(
        QString::fromStdString(address.database), QSqlDriver::TableName);
    return server->runAll(QStringLiteral("CREATE DATABASE %1").arg(name));
}

Result<ReadyHub> connectReady(const HubAddress &address)
{
    auto hub = ODO_TRY(SchoolHub::connect(address));
    const auto version = ODO_TRY(hub->schemaVersion());
    ODO_TRY(hub->checkSchema(version));
    auto role = ODO_TRY(hub->role());
    return ReadyHub{std::move(hub), std::move(role), version};
}

} // namespace odo
