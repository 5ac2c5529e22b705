// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/school_repository.h"

#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/recording_rows.h"

#include <QUuid>
#include <array>

namespace odo {

namespace {

constexpr StoredWords<SchoolKind, 4> schoolKindWords{{{SchoolKind::Class, "class"},
                                                      {SchoolKind::Team, "team"},
                                                      {SchoolKind::Task, "task"},
                                                      {SchoolKind::Trial, "trial"}}};
constexpr std::array allSchoolKinds{SchoolKind::Class, SchoolKind::Team, SchoolKind::Task, SchoolKind::Trial};

std::string newUuid()
{
    return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

RecordKind recordKindOf(SchoolKind kind)
{
    switch (kind) {
    case SchoolKind::Class:
        return RecordKind::Class;
    case SchoolKind::Team:
        return RecordKind::Team;
    case SchoolKind::Task:
        return RecordKind::Task;
    case SchoolKind::Trial:
        break;
    }
    return RecordKind::Trial;
}

/// Of the bench, which outlives a connection: made once, kept among the properties.
Result<std::string> benchOf(ProjectConnection &connection)
{
    Statement select(connection, QStringLiteral("SELECT value FROM property WHERE name='school_bench'"));
    const auto found = ODO_TRY(select.firstRow());
    if (found)
        return select.text(0);
    const std::string made = newUuid();
    Statement insert(connection, QStringLiteral("INSERT INTO property VALUES ('school_bench',?)"));
    ODO_TRY(insert.bind(made).run());
    return made;
}

const QString identityColumns =
    QStringLiteral("SELECT kind, row_id, uuid, revision, sha256, owner, views FROM school_document ");

SchoolIdentity identityIn(const Statement &row, SchoolKind kind)
{
    SchoolIdentity identity{kind, row.integer(1), row.text(2), row.integer(3), row.text(4), row.text(5)};
    const QStringList views = QString::fromStdString(row.text(6)).split(u'\n', Qt::SkipEmptyParts);
    for (const QString &view : views)
        identity.views.push_back(shownName(view));
    return identity;
}

} // namespace

std::string schoolKindWord(SchoolKind kind)
{
    return storedWord(schoolKindWords, kind);
}

Result<SchoolKind> schoolKindOf(const std::string &word)
{
    return fromStoredWord(schoolKindWords, word, ODO_TEXT("project.school_document", "document of the hub"));
}

SchoolRepository::SchoolRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<std::optional<SchoolLink>> SchoolRepository::link() const
{
    Statement select(m_connection,
                     QStringLiteral("SELECT url, bench, role, schema_version, media, pulled, last_sync_ms "
                                    "FROM school_link"));
    const auto found = ODO_TRY(select.firstRow());
    if (!found)
        return std::nullopt;
    SchoolLink link{select.text(0),         select.text(1), select.text(2),
                    select.smallInteger(3), select.text(4), select.integer(5)};
    if (select.optionalReal(6))
        link.lastSync = Instant(std::chrono::milliseconds(select.integer(6)));
    return link;
}

Result<void> SchoolRepository::connect(SchoolLink link)
{
    return transact(m_connection, [&]() -> Result<void> {
        link.bench = ODO_TRY(benchOf(m_connection));
        ODO_TRY(m_connection.execute(QStringLiteral("DELETE FROM school_link")));
        Statement insert(
            m_connection,
            QStringLiteral("INSERT INTO school_link (id, url, bench, role, schema_version, media, "
                           "pulled, last_sync_ms) VALUES (1,?,?,?,?,?,0,NULL)"));
        insert.bind(link.url).bind(link.bench).bind(link.role).bind(link.schemaVersion);
        ODO_TRY(insert.bind(link.media).run());
        // Which revisions this hub has is not known; it knows its documents by their UUIDs.
        ODO_TRY(m_connection.execute(QStringLiteral("UPDATE school_document SET revision=0, sha256=''")));
        for (const SchoolKind kind : allSchoolKinds) {
            const QString word = QString::fromStdString(schoolKindWord(kind));
            const QString finished =
                kind == SchoolKind::Trial ? QStringLiteral(" WHERE state='complete'") : QString();
            ODO_TRY(m_connection.execute(
                QStringLiteral("INSERT OR REPLACE INTO school_outbox (kind, row_id, mark) "
                               "SELECT '%1', id, random() FROM %1%2 ORDER BY id")
                    .arg(word, finished)));
        }
        return {};
    });
}

Result<void> SchoolRepository::disconnect()
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(m_connection.execute(QStringLiteral("DELETE FROM school_link")));
        return m_connection.execute(QStringLiteral("DELETE FROM school_outbox"));
    });
}

Result<void> SchoolRepository::setContact(const std::string &role, int schemaVersion, Instant when)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement update(m_connection,
                         QStringLiteral("UPDATE school_link SET role=?, schema_version=?, last_sync_ms=?"));
        return update.bind(role)
            .bind(schemaVersion)
            .bind(static_cast<std::int64_t>(when.time_since_epoch().count()))
            .run();
    });
}

Result<void> SchoolRepository::setPulled(std::int64_t revision)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement update(m_connection, QStringLiteral("UPDATE school_link SET pulled=?"));
        return update.bind(revision).run();
    });
}

Result<std::vector<OutboxEntry>> SchoolRepository::outbox() const
{
    std::vector<OutboxEntry> entries;
    for (const SchoolKind kind : allSchoolKinds) {
        Statement select(m_connection, QStringLiteral("SELECT row_id, removed, mark FROM school_outbox "
                                                      "WHERE kind=? ORDER BY rowid"));
        auto read = select.bind(schoolKindWord(kind)).eachRow([&](const Statement &row) -> Result<void> {
            entries.push_back({kind, row.integer(0), row.text(1), row.integer(2)});
            return {};
        });
        if (!read)
            return tl::unexpected(read.error());
    }
    return entries;
}

Result<std::int64_t> SchoolRepository::pending() const
{
    return m_connection.number(QStringLiteral("SELECT COUNT(*) FROM school_outbox"));
}

Result<bool> SchoolRepository::isPending(SchoolKind kind, RecordId row) const
{
    Statement select(m_connection,
                     QStringLiteral("SELECT 1 FROM school_outbox WHERE kind=? AND row_id=? AND removed=''"));
    return select.bind(schoolKindWord(kind)).bind(row).firstRow();
}

Result<void> SchoolRepository::settle(const OutboxEntry &entry)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection, QStringLiteral("DELETE FROM school_outbox WHERE kind=? AND row_id=? "
                                                      "AND removed=? AND mark=?"));
        remove.bind(schoolKindWord(entry.kind)).bind(entry.row).bind(entry.removed);
        return remove.bind(entry.mark).run();
    });
}

Result<void> SchoolRepository::settle(SchoolKind kind, RecordId row)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(
            m_connection,
            QStringLiteral("DELETE FROM school_outbox WHERE kind=? AND row_id=? AND removed=''"));
        return remove.bind(schoolKindWord(kind)).bind(row).run();
    });
}

Result<std::optional<SchoolIdentity>> SchoolRepository::known(SchoolKind kind, RecordId row) const
{
    Statement select(m_connection, identityColumns + QStringLiteral("WHERE kind=? AND row_id=?"));
    const auto found = ODO_TRY(select.bind(schoolKindWord(kind)).bind(row).firstRow());
    return found ? std::optional(identityIn(select, kind)) : std::nullopt;
}

Result<SchoolIdentity> SchoolRepository::identity(SchoolKind kind, RecordId row)
{
    return transact(m_connection, [&]() -> Result<SchoolIdentity> {
        if (auto its = ODO_TRY(known(kind, row)))
            return std::move(*its);
        const SchoolIdentity made{kind, row, newUuid()};
        ODO_TRY(setIdentity(made));
        return made;
    });
}

Result<std::optional<SchoolIdentity>> SchoolRepository::find(const std::string &uuid) const
{
    Statement select(m_connection, identityColumns + QStringLiteral("WHERE uuid=?"));
    const auto found = ODO_TRY(select.bind(uuid).firstRow());
    if (!found)
        return std::nullopt;
    const auto kind = ODO_TRY(schoolKindOf(select.text(0)));
    return identityIn(select, kind);
}

Result<void> SchoolRepository::setIdentity(const SchoolIdentity &identity)
{
    std::string views;
    for (const std::string &view : identity.views)
        views += view + '\n';
    return transact(m_connection, [&]() -> Result<void> {
        Statement insert(
            m_connection,
            QStringLiteral("INSERT OR REPLACE INTO school_document (kind, row_id, uuid, revision, "
                           "sha256, owner, views) VALUES (?,?,?,?,?,?,?)"));
        insert.bind(schoolKindWord(identity.kind)).bind(identity.row).bind(identity.uuid);
        return insert.bind(identity.revision).bind(identity.sha256).bind(identity.owner).bind(views).run();
    });
}

Result<void> SchoolRepository::addRecordings(RecordId trial, const std::vector<RecordingRecord> &recordings,
                                             const std::function<Result<void>()> &synchronise)
{
    std::vector<DigestedPart> parts;
    Statement select(m_connection, QStringLiteral("SELECT id FROM analysis WHERE trial_id=?"));
    auto read = select.bind(trial).eachRow([&parts](const Statement &row) -> Result<void> {
        parts.push_back({row.integer(0), DigestPart::Recordings});
        return {};
    });
    if (!read)
        return read;
    return keepDigestsRight(m_connection, parts, [&]() -> Result<void> {
        for (const RecordingRecord &recording : recordings)
            ODO_TRY(addRecording(m_connection, recording));
        return synchronise();
    });
}

Result<RecordId> SchoolRepository::rowNamed(SchoolKind kind, const std::string &name) const
{
    return idNamed(m_connection, recordKindOf(kind), name);
}

} // namespace odo
