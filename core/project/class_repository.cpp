// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/class_repository.h"

#include "core/base/error.h"
#include "core/base/subjects.h"
#include "core/project/internal/connection.h"
#include "core/project/names.h"
#include "core/project/records.h"

namespace odo {

namespace {

const QString classColumns = QStringLiteral(
    "SELECT id, name, archived_ms, (SELECT COUNT(*) FROM team WHERE class_id=class.id) FROM class ");

ClassRecord classOf(const Statement &row)
{
    ClassRecord record{row.integer(0), row.name(1), {}, row.smallInteger(3)};
    if (row.optionalReal(2))
        record.archived = Instant(std::chrono::milliseconds(row.integer(2)));
    return record;
}

} // namespace

ClassRepository::ClassRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<ClassRecord> ClassRepository::add(const std::string &given)
{
    const std::string name = normalName(given);
    return transact(m_connection, [&]() -> Result<ClassRecord> {
        ODO_TRY(checkName(RecordKind::Class, name));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Class, name));
        Statement insert(m_connection, QStringLiteral("INSERT INTO class (name) VALUES (?)"));
        ODO_TRY(insert.bind(name).run());
        return ClassRecord{insert.insertedId(), name, {}, 0};
    });
}

Result<std::vector<ClassRecord>> ClassRepository::all() const
{
    std::vector<ClassRecord> classes;
    Statement select(m_connection, classColumns + QStringLiteral("ORDER BY name"));
    auto read = select.eachRow([&classes](const Statement &row) -> Result<void> {
        classes.push_back(classOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return classes;
}

Result<ClassRecord> ClassRepository::get(RecordId id) const
{
    Statement select(m_connection, classColumns + QStringLiteral("WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Class, id);
    return classOf(select);
}

Result<void> ClassRepository::rename(RecordId id, const std::string &given)
{
    const std::string name = normalName(given);
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(id);
        if (!known || known->name == name)
            return withoutValue(known);
        ODO_TRY(checkName(RecordKind::Class, name));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Class, name));
        Statement update(m_connection, QStringLiteral("UPDATE class SET name=? WHERE id=?"));
        return update.bind(name).bind(id).run();
    });
}

Result<void> ClassRepository::setArchived(RecordId id, bool archived)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(id);
        if (!known || known->archived.has_value() == archived)
            return withoutValue(known);
        Statement update(m_connection, QStringLiteral("UPDATE class SET archived_ms=? WHERE id=?"));
        return update.bindReference(archived ? instantNow().time_since_epoch().count() : 0).bind(id).run();
    });
}

Result<void> ClassRepository::remove(RecordId id)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(id));
        if (known.teams > 0)
            return fail(
                ErrorCode::InvalidInput, classSubject(known.name),
                known.teams == 1 ? Message(ODO_TEXT("project.class_has_team", "a team belongs to it"))
                                 : ODO_TEXT("project.class_has_teams", "%1 teams belong to it")(known.teams),
                ODO_TEXT("project.move_teams_first", "move its teams to another class first, or archive it"));
        return runFor(m_connection, "DELETE FROM class WHERE id=?", id);
    });
}

} // namespace odo
