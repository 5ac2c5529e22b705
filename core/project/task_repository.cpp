// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/project/series_blobs.h"
#include "core/project/stored_words.h"
#include "core/project/task_rows.h"

namespace odo {

namespace {

const QString taskColumns =
    QStringLiteral("SELECT id, name, template, path_points, path_closed, max_speed_m_s, max_accel_m_s2, archived_ms FROM task ");

constexpr auto restoreAdvice = "restore the project from a backup copy";

/// x and y of each point in turn.
QByteArray packPlaces(const std::vector<Eigen::Vector2d> &points)
{
    std::vector<double> numbers;
    for (const Eigen::Vector2d &point : points)
        numbers.insert(numbers.end(), {point.x(), point.y()});
    return packNumbers(numbers);
}

/// name: of the line, for messages ("its reference path").
Result<std::vector<Eigen::Vector2d>> unpackPlaces(const QByteArray &blob, const std::string &what, const std::string &name)
{
    std::vector<Eigen::Vector2d> points;
    if (blob.isEmpty())
        return points;
    const auto numbers = unpackNumbers(blob, what);
    if (!numbers)
        return tl::unexpected(numbers.error());
    if (numbers->size() % 2 != 0)
        return fail(ErrorCode::InvalidInput, what, name + " ends within a point", restoreAdvice);
    for (std::size_t i = 0; i < numbers->size(); i += 2)
        points.emplace_back((*numbers)[i], (*numbers)[i + 1]);
    return points;
}

Result<void> readZones(const ProjectConnection &connection, const std::string &what, TaskRecord &into)
{
    Statement select(connection, QStringLiteral("SELECT name, rule, corners FROM zone WHERE task_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&](const Statement &row) -> Result<void> {
        const auto rule = fromStoredWord(zoneRuleWords, row.text(1), "zone '" + row.name(0) + "'");
        if (!rule)
            return tl::unexpected(rule.error());
        auto corners = unpackPlaces(row.blob(2), what, "its zone '" + row.name(0) + "'");
        if (!corners)
            return tl::unexpected(corners.error());
        into.task.zones.push_back({row.name(0), *rule, std::move(*corners)});
        return {};
    });
}

Result<void> readGates(const ProjectConnection &connection, TaskRecord &into)
{
    Statement select(connection, QStringLiteral("SELECT name, role, from_x_m, from_y_m, to_x_m, to_y_m FROM gate "
                                                "WHERE task_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        const auto role = fromStoredWord(gateRoleWords, row.text(1), "gate '" + row.name(0) + "'");
        if (!role)
            return tl::unexpected(role.error());
        into.task.gates.push_back(
            {row.name(0), *role, {row.real(2), row.real(3)}, {row.real(4), row.real(5)}});
        return {};
    });
}

/// Its course into `record`; fails where it cannot be used.
Result<void> readCourse(const ProjectConnection &connection, const Statement &row, TaskRecord &record)
{
    const std::string what = "task '" + record.name + "'";
    const auto kind = fromStoredWord(taskTemplateWords, row.text(2), what);
    if (!kind)
        return tl::unexpected(kind.error());
    record.task.kind = *kind;
    auto path = unpackPlaces(row.blob(3), what, "its reference path");
    if (!path)
        return tl::unexpected(path.error());
    record.task.path = {std::move(*path), row.integer(4) != 0};
    record.task.limits = {row.optionalReal(5), row.optionalReal(6)};
    if (auto read = readGates(connection, record); !read)
        return read;
    if (auto read = readZones(connection, what, record); !read)
        return read;
    if (auto valid = checkTask(record.task); !valid)
        return fail(valid.error().code, what, valid.error().what + ": " + valid.error().why, restoreAdvice);
    return {};
}

/// Without its course.
TaskRecord taskOf(const Statement &row)
{
    TaskRecord record;
    record.id = row.integer(0);
    record.name = row.name(1);
    if (row.optionalReal(7))
        record.archived = Instant(std::chrono::milliseconds(row.integer(7)));
    return record;
}

TaskRecord readTask(const ProjectConnection &connection, const Statement &row)
{
    TaskRecord record = taskOf(row);
    if (!readCourse(connection, row, record))
        record.task = {}; // checkStoredTasks tells why
    return record;
}

TaskRecord withNormalNames(TaskRecord task)
{
    task.name = normalName(task.name);
    for (Gate &gate : task.task.gates)
        gate.name = normalName(gate.name);
    for (Zone &zone : task.task.zones)
        zone.name = normalName(zone.name);
    return task;
}

Result<void> addGates(ProjectConnection &connection, RecordId task, const std::vector<Gate> &gates)
{
    for (std::size_t i = 0; i < gates.size(); ++i) {
        const Gate &gate = gates[i];
        if (auto valid = checkName("gate", gate.name); !valid)
            return valid;
        Statement insert(connection, QStringLiteral("INSERT INTO gate VALUES (?,?,?,?,?,?,?,?)"));
        insert.bind(task).bind(static_cast<std::int64_t>(i)).bind(gate.name);
        insert.bind(storedWord(gateRoleWords, gate.role)).bind(gate.from.x()).bind(gate.from.y());
        if (auto done = insert.bind(gate.to.x()).bind(gate.to.y()).run(); !done)
            return done;
    }
    return {};
}

Result<void> addZones(ProjectConnection &connection, RecordId task, const std::vector<Zone> &zones)
{
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Zone &zone = zones[i];
        if (auto valid = checkName("zone", zone.name); !valid)
            return valid;
        Statement insert(connection, QStringLiteral("INSERT INTO zone VALUES (?,?,?,?,?)"));
        insert.bind(task).bind(static_cast<std::int64_t>(i)).bind(zone.name);
        if (auto done = insert.bind(storedWord(zoneRuleWords, zone.rule)).bind(packPlaces(zone.corners)).run(); !done)
            return done;
    }
    return {};
}

} // namespace

Result<void> checkStoredTasks(const ProjectConnection &connection)
{
    Statement select(connection, taskColumns + QStringLiteral("ORDER BY id"));
    return select.eachRow([&](const Statement &row) -> Result<void> {
        TaskRecord record = taskOf(row);
        return readCourse(connection, row, record);
    });
}

TaskRepository::TaskRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TaskRecord> TaskRepository::add(const TaskRecord &given)
{
    const TaskRecord task = withNormalNames(given);
    return transact(m_connection, [&]() -> Result<TaskRecord> {
        if (auto valid = checkName("task", task.name); !valid)
            return tl::unexpected(valid.error());
        if (auto valid = checkTask(task.task); !valid)
            return tl::unexpected(valid.error());
        if (auto isFree = checkNameIsFree(m_connection, "task", "task", task.name); !isFree)
            return tl::unexpected(isFree.error());
        Statement insert(m_connection, QStringLiteral("INSERT INTO task (name, template, path_points, path_closed, "
                                                      "max_speed_m_s, max_accel_m_s2, archived_ms) VALUES (?,?,?,?,?,?,?)"));
        insert.bind(task.name).bind(storedWord(taskTemplateWords, task.task.kind)).bind(packPlaces(task.task.path.points));
        insert.bind(task.task.path.closed ? 1 : 0).bind(task.task.limits.maxSpeedMps);
        insert.bind(task.task.limits.maxAccelMps2);
        insert.bindReference(task.archived ? task.archived->time_since_epoch().count() : 0);
        if (auto done = insert.run(); !done)
            return tl::unexpected(done.error());
        TaskRecord stored = task;
        stored.id = insert.insertedId();
        if (auto added = addGates(m_connection, stored.id, task.task.gates); !added)
            return tl::unexpected(added.error());
        if (auto added = addZones(m_connection, stored.id, task.task.zones); !added)
            return tl::unexpected(added.error());
        return stored;
    });
}

Result<std::vector<TaskRecord>> TaskRepository::all() const
{
    std::vector<TaskRecord> tasks;
    Statement select(m_connection, taskColumns + QStringLiteral("ORDER BY id"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        tasks.push_back(readTask(m_connection, row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return tasks;
}

Result<TaskRecord> TaskRepository::find(const std::string &name) const
{
    const auto id = idNamed(m_connection, "task", name);
    if (!id)
        return tl::unexpected(id.error());
    if (*id == 0)
        return noSuchName(m_connection, "task", "task", name);
    return get(*id);
}

Result<TaskRecord> TaskRepository::get(RecordId id) const
{
    Statement select(m_connection, taskColumns + QStringLiteral("WHERE id=?"));
    const auto found = select.bind(id).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchId(m_connection, "task", id);
    return readTask(m_connection, select);
}

} // namespace odo
