// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/school_documents.h"
#include "core/school/hub_address.h"
#include "core/school/internal/hub_queries.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// What became of a document that was published.
struct PublishOutcome
{
    /// New, Changed, Same: it is in force. Conflict: it is, and replaced what another bench had published
    /// meanwhile (other). Refused: another login's (other) stays in force.
    enum class Kind { New, Changed, Same, Conflict, Refused } kind = Kind::Same;
    std::string uuid; ///< by which the hub knows it; that of one of the same name where that was there first
    std::int64_t revision = 0;
    std::string owner;
    QByteArray other;
};

/// A document as the hub has it.
struct HubDocument
{
    SchoolDocument document;
    std::string uuid, owner;
    std::int64_t revision = 0;
    bool isRemoved = false;
};

/// A connection to the school's hub, on the thread that made it. Errors, in one line and without a password:
/// Unavailable where the server cannot be reached or goes away, which may pass; InvalidInput and NotFound for
/// what does not pass by itself.
class SchoolHub
{
public:
    static Result<std::unique_ptr<SchoolHub>> connect(const HubAddress &address);
    ~SchoolHub();
    SchoolHub(const SchoolHub &) = delete;
    SchoolHub &operator=(const SchoolHub &) = delete;

    /// 0: the database has no hub.
    Result<int> schemaVersion();
    /// That the hub's schema is the one that this program uses.
    Result<void> checkSchema(int version) const;
    /// Runs the missing migrations, each in a transaction of its own; gives the version. As a login that may
    /// make schemas and roles.
    Result<int> upgrade();
    /// "teacher", "bench" or "viewer": the first that the login has. NotFound where it has none.
    Result<std::string> role();

    /// The rows are read forward.
    Result<QSqlQuery> run(const HubQuery &query);

    /// standing: of a trial, as standingMarks(); empty for what has none.
    Result<PublishOutcome> publish(const SchoolDocument &document, const std::string &uuid,
                                   const std::string &bench, std::int64_t base, bool isRemoved,
                                   const QJsonObject &standing = {});
    /// Of the trials that this bench published last: standingMarks() with the UUID of each as "trial".
    Result<void> setStandings(const std::string &bench, const QJsonArray &standings);
    /// What others than this bench made since a revision, in the order of the revisions, so many at most.
    Result<std::vector<HubDocument>> since(std::int64_t revision, const std::string &bench, int most);

    /// What the recordings of a trial are; empty where it has none, or the login may not read them.
    Result<QByteArray> recordingsOf(const std::string &uuid);
    /// Makes the database of an address where its server has none of that name.
    static Result<void> makeDatabase(const HubAddress &address);

    static int newestVersion();

private:
    explicit SchoolHub(HubAddress address, QString name);
    Result<PublishOutcome> publishAlone(const SchoolDocument &document, const std::string &uuid,
                                        const std::string &bench, std::int64_t base, bool isRemoved);
    Result<void> begin();
    Result<void> commit();
    Result<void> runAll(const QString &sql);
    tl::unexpected<Error> failure(const QSqlError &error) const;

    HubAddress m_address;
    QString m_name;
    QSqlDatabase m_database;
};

/// What to do where the server is away for a while.
Message tryLater();

/// A connection to a hub whose schema this program uses, and what the login is there.
struct ReadyHub
{
    std::unique_ptr<SchoolHub> hub;
    std::string role;
    int version = 0; ///< of the schema
};

/// Errors: those of SchoolHub::connect, checkSchema and role.
Result<ReadyHub> connectReady(const HubAddress &address);

} // namespace odo
