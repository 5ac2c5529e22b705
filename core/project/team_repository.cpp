// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"
#include "core/project/named_rows.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

const QString teamColumns = QStringLiteral("SELECT team.id, team.name, class.name, pseudonym FROM team "
                                           "LEFT JOIN class ON class.id=team.class_id ");

TeamRecord teamOf(const Statement &row)
{
    return {row.integer(0), row.text(1), row.text(2), row.text(3)};
}

Result<void> checkTeam(const TeamRecord &team)
{
    if (auto valid = checkName("team", team.name); !valid)
        return valid;
    return team.pseudonym.empty() ? Result<void>() : checkName("pseudonym", team.pseudonym);
}

} // namespace

TeamRepository::TeamRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TeamRecord> TeamRepository::add(const TeamRecord &team)
{
    return transact(m_connection, [&]() -> Result<TeamRecord> {
        if (auto valid = checkTeam(team); !valid)
            return tl::unexpected(valid.error());
        if (auto isFree = checkNameIsFree(m_connection, "team", "team", team.name); !isFree)
            return tl::unexpected(isFree.error());
        const auto classId = idOfName(m_connection, "class", team.className);
        if (!classId)
            return tl::unexpected(classId.error());
        Statement insert(m_connection, QStringLiteral("INSERT INTO team (name, class_id, pseudonym) VALUES (?,?,?)"));
        if (auto done = insert.bind(team.name).bindReference(*classId).bind(team.pseudonym).run(); !done)
            return tl::unexpected(done.error());
        TeamRecord stored = team;
        stored.id = insert.insertedId();
        return stored;
    });
}

Result<std::vector<TeamRecord>> TeamRepository::all() const
{
    std::vector<TeamRecord> teams;
    Statement select(m_connection, teamColumns + QStringLiteral("ORDER BY team.id"));
    auto read = select.eachRow([&teams](const Statement &row) -> Result<void> {
        teams.push_back(teamOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return teams;
}

Result<TeamRecord> TeamRepository::find(const std::string &name) const
{
    Statement select(m_connection, teamColumns + QStringLiteral("WHERE team.name=?"));
    const auto found = select.bind(name).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchName(m_connection, "team", "team", name);
    return teamOf(select);
}

Result<void> TeamRepository::set(const TeamRecord &team)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto valid = checkTeam(team); !valid)
            return valid;
        Statement known(m_connection, QStringLiteral("SELECT name FROM team WHERE id=?"));
        const auto found = known.bind(team.id).firstRow();
        if (!found || !*found)
            return found ? noSuchId(m_connection, "team", team.id) : tl::unexpected(found.error());
        if (known.text(0) != team.name)
            if (auto isFree = checkNameIsFree(m_connection, "team", "team", team.name); !isFree)
                return isFree;
        const auto classId = idOfName(m_connection, "class", team.className);
        if (!classId)
            return tl::unexpected(classId.error());
        Statement update(m_connection, QStringLiteral("UPDATE team SET name=?, class_id=?, pseudonym=? WHERE id=?"));
        return update.bind(team.name).bindReference(*classId).bind(team.pseudonym).bind(team.id).run();
    });
}

Result<void> TeamRepository::remove(RecordId team)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement known(m_connection, QStringLiteral("SELECT name, (SELECT COUNT(*) FROM trial WHERE team_id=team.id) FROM team WHERE id=?"));
        const auto found = known.bind(team).firstRow();
        if (!found || !*found)
            return found ? noSuchId(m_connection, "team", team) : tl::unexpected(found.error());
        const int trials = known.smallInteger(1);
        if (trials > 0)
            return fail(ErrorCode::InvalidInput, "team '" + known.text(0) + "'",
                        trials == 1 ? "a trial is its" : std::to_string(trials) + " trials are its",
                        "delete them for good first, or archive its class");
        return runFor(m_connection, "DELETE FROM team WHERE id=?", team);
    });
}

Result<std::vector<std::string>> TeamRepository::classes() const
{
    return textsOf(m_connection, QStringLiteral("SELECT name FROM class ORDER BY name"));
}

} // namespace odo
