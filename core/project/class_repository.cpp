// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/class_repository.h"

#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/names.h"
#include "core/project/records.h"
#include "core/project/repositories.h"

#include <set>
#include <unordered_map>

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

Result<ClassRecord> ClassRepository::find(const std::string &name) const
{
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Class, name));
    return id == 0 ? noSuchName(m_connection, RecordKind::Class, name) : get(id);
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

namespace {

constexpr std::size_t mostMembers = 200;

const QString teamColumns = QStringLiteral("SELECT team.id, team.name, class.name, pseudonym FROM team "
                                           "LEFT JOIN class ON class.id=team.class_id ");

/// The teams that a condition with one parameter means, or all, with their members and robots: three queries,
/// however many teams.
Result<std::vector<TeamRecord>> readTeams(const ProjectConnection &connection, const char *condition,
                                          const RecordId *id)
{
    std::vector<TeamRecord> teams;
    std::unordered_map<RecordId, std::size_t> positionOf;
    const auto read = [&](const QString &sql, const char *order, const auto &take) {
        Statement select(connection, sql + QLatin1String(condition) + QLatin1String(order));
        if (id)
            select.bind(*id);
        return select.eachRow([&take](const Statement &row) -> Result<void> {
            take(row);
            return {};
        });
    };
    const auto teamOf = [&](const Statement &row) -> TeamRecord * {
        const auto location = positionOf.find(row.integer(0));
        return location == positionOf.end() ? nullptr : &teams[location->second];
    };
    auto done = read(teamColumns, " ORDER BY team.id", [&](const Statement &row) {
        positionOf.emplace(row.integer(0), teams.size());
        teams.push_back({row.integer(0), row.name(1), row.name(2), row.name(3)});
    });
    if (done)
        done = read(
            QStringLiteral("SELECT team.id, team_member.name FROM team JOIN team_member ON team_id=team.id "),
            " ORDER BY team.id, position", [&](const Statement &row) {
                if (TeamRecord *team = teamOf(row); team && team->members.size() < mostMembers)
                    team->members.push_back(row.name(1));
            });
    if (done)
        done = read(QStringLiteral("SELECT team.id, robot_id FROM team JOIN team_robot ON team_id=team.id "),
                    " ORDER BY team.id, position", [&](const Statement &row) {
                        if (TeamRecord *team = teamOf(row))
                            team->robots.push_back(row.integer(1));
                    });
    if (!done)
        return tl::unexpected(done.error());
    return teams;
}

TeamRecord withNormalNames(TeamRecord team)
{
    team.name = normalName(team.name);
    team.pseudonym = normalName(team.pseudonym);
    for (std::string &member : team.members)
        member = normalName(member);
    return team;
}

Result<void> checkTeam(const TeamRecord &team)
{
    ODO_TRY(checkName(RecordKind::Team, team.name));
    const Message what = teamSubject(team.name);
    if (team.members.size() > mostMembers)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.too_many_members", "it has more than %1 members")(mostMembers),
                    ODO_TEXT("project.give_members", "give the names of the people in the team"));
    for (const std::string &member : team.members)
        ODO_TRY(checkName(RecordKind::Member, member));
    if (std::set(team.robots.begin(), team.robots.end()).size() != team.robots.size())
        return fail(ErrorCode::InvalidInput, what, ODO_TEXT("project.robot_twice", "it has a robot twice"),
                    ODO_TEXT("project.name_robots_once", "list each of its robots once"));
    return team.pseudonym.empty() ? Result<void>() : checkName(RecordKind::Pseudonym, team.pseudonym);
}

Result<void> removeLists(ProjectConnection &connection, RecordId team)
{
    ODO_TRY(runFor(connection, "DELETE FROM team_member WHERE team_id=?", team));
    return runFor(connection, "DELETE FROM team_robot WHERE team_id=?", team);
}

/// Replaces members and robots.
Result<void> setLists(ProjectConnection &connection, RecordId id, const TeamRecord &team)
{
    ODO_TRY(removeLists(connection, id));
    for (std::size_t i = 0; i < team.members.size(); ++i) {
        Statement insert(connection, QStringLiteral("INSERT INTO team_member VALUES (?,?,?)"));
        ODO_TRY(insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(team.members[i]).run());
    }
    for (std::size_t i = 0; i < team.robots.size(); ++i) {
        Statement known(connection, QStringLiteral("SELECT 1 FROM robot WHERE id=?"));
        const auto found = known.bind(team.robots[i]).firstRow();
        if (!found || !*found)
            return found ? noSuchId(connection, RecordKind::Robot, team.robots[i])
                         : tl::unexpected(found.error());
        Statement insert(connection, QStringLiteral("INSERT INTO team_robot VALUES (?,?,?)"));
        ODO_TRY(insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(team.robots[i]).run());
    }
    return {};
}

} // namespace

TeamRepository::TeamRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TeamRecord> TeamRepository::add(const TeamRecord &given)
{
    const TeamRecord team = withNormalNames(given);
    return transact(m_connection, [&]() -> Result<TeamRecord> {
        ODO_TRY(checkTeam(team));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Team, team.name));
        const auto classId = ODO_TRY(idOfName(m_connection, RecordKind::Class, team.className));
        Statement insert(m_connection,
                         QStringLiteral("INSERT INTO team (name, class_id, pseudonym) VALUES (?,?,?)"));
        ODO_TRY(insert.bind(team.name).bindReference(classId).bind(team.pseudonym).run());
        TeamRecord stored = team;
        stored.id = insert.insertedId();
        ODO_TRY(setLists(m_connection, stored.id, team));
        return stored;
    });
}

Result<std::vector<TeamRecord>> TeamRepository::all() const
{
    return readTeams(m_connection, "", nullptr);
}

Result<TeamRecord> TeamRepository::find(const std::string &name) const
{
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Team, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Team, name);
    return readTeams(m_connection, "WHERE team.id=?", &id).map([](auto &&teams) {
        return std::move(teams.front());
    });
}

Result<void> TeamRepository::set(const TeamRecord &given)
{
    const TeamRecord team = withNormalNames(given);
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(checkTeam(team));
        Statement known(m_connection, QStringLiteral("SELECT name FROM team WHERE id=?"));
        const auto found = known.bind(team.id).firstRow();
        if (!found || !*found)
            return found ? noSuchId(m_connection, RecordKind::Team, team.id) : tl::unexpected(found.error());
        if (known.name(0) != team.name)
            ODO_TRY(checkNameIsFree(m_connection, RecordKind::Team, team.name));
        const auto classId = ODO_TRY(idOfName(m_connection, RecordKind::Class, team.className));
        Statement update(m_connection,
                         QStringLiteral("UPDATE team SET name=?, class_id=?, pseudonym=? WHERE id=?"));
        ODO_TRY(update.bind(team.name).bindReference(classId).bind(team.pseudonym).bind(team.id).run());
        return setLists(m_connection, team.id, team);
    });
}

Result<void> TeamRepository::remove(RecordId team)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement known(
            m_connection,
            QStringLiteral(
                "SELECT name, (SELECT COUNT(*) FROM trial WHERE team_id=team.id) FROM team WHERE id=?"));
        const auto found = known.bind(team).firstRow();
        if (!found || !*found)
            return found ? noSuchId(m_connection, RecordKind::Team, team) : tl::unexpected(found.error());
        const int trials = known.smallInteger(1);
        if (trials > 0)
            return fail(ErrorCode::InvalidInput, teamSubject(known.name(0)),
                        trials == 1 ? Message(ODO_TEXT("project.team_has_trial", "it has a trial"))
                                    : ODO_TEXT("project.team_has_trials", "it has %1 trials")(trials),
                        ODO_TEXT("project.delete_its_trials",
                                 "delete its trials permanently first, or archive its class"));
        ODO_TRY(removeLists(m_connection, team));
        return runFor(m_connection, "DELETE FROM team WHERE id=?", team);
    });
}

Result<std::vector<std::string>> TeamRepository::classes() const
{
    return textsOf(m_connection, QStringLiteral("SELECT name FROM class ORDER BY name"));
}

} // namespace odo
