// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/project/series_blobs.h"
#include "core/project/stored_words.h"

namespace odo {

namespace {

const QString taskColumns =
    QStringLiteral("SELECT id, name, template, path_points, path_closed, max_speed_m_s, max_accel_m_s2 FROM task ");

/// x and y of each point in turn.
QByteArray packPath(const ReferencePath &path)
{
    std::vector<double> numbers;
    for (const Eigen::Vector2d &point : path.points)
        numbers.insert(numbers.end(), {point.x(), point.y()});
    return packNumbers(numbers);
}

Result<void> readPath(const Statement &row, const std::string &what, ReferencePath &into)
{
    const QByteArray blob = row.blob(3);
    if (blob.isEmpty())
        return {};
    const auto numbers = unpackNumbers(blob, what);
    if (!numbers)
        return tl::unexpected(numbers.error());
    if (numbers->size() % 2 != 0)
        return fail(ErrorCode::InvalidInput, what, "its reference path ends within a point",
                    "restore the project from a backup copy");
    for (std::size_t i = 0; i < numbers->size(); i += 2)
        into.points.emplace_back((*numbers)[i], (*numbers)[i + 1]);
    into.closed = row.integer(4) != 0;
    return {};
}

Result<void> readGates(const ProjectConnection &connection, TaskRecord &into)
{
    Statement select(connection, QStringLiteral("SELECT name, role, from_x_m, from_y_m, to_x_m, to_y_m FROM gate "
                                                "WHERE task_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        const auto role = fromStoredWord(gateRoleWords, row.text(1), "gate '" + row.text(0) + "'");
        if (!role)
            return tl::unexpected(role.error());
        into.task.gates.push_back(
            {row.text(0), *role, {row.real(2), row.real(3)}, {row.real(4), row.real(5)}});
        return {};
    });
}

Result<TaskRecord> readTask(const ProjectConnection &connection, const Statement &row)
{
    TaskRecord record;
    record.id = row.integer(0);
    record.name = row.text(1);
    const std::string what = "task '" + record.name + "'";
    const auto kind = fromStoredWord(taskTemplateWords, row.text(2), what);
    if (!kind)
        return tl::unexpected(kind.error());
    record.task.kind = *kind;
    if (auto read = readPath(row, what, record.task.path); !read)
        return tl::unexpected(read.error());
    record.task.limits = {row.optionalReal(5), row.optionalReal(6)};
    if (auto read = readGates(connection, record); !read)
        return tl::unexpected(read.error());
    if (auto valid = checkTask(record.task); !valid)
        return fail(valid.error().code, what, valid.error().what + ": " + valid.error().why,
                    "restore the project from a backup copy");
    return record;
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

} // namespace

TaskRepository::TaskRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TaskRecord> TaskRepository::add(const TaskRecord &task)
{
    return transact(m_connection, [&]() -> Result<TaskRecord> {
        if (auto valid = checkName("task", task.name); !valid)
            return tl::unexpected(valid.error());
        if (auto valid = checkTask(task.task); !valid)
            return tl::unexpected(valid.error());
        if (auto isFree = checkNameIsFree(m_connection, "task", "task", task.name); !isFree)
            return tl::unexpected(isFree.error());
        Statement insert(m_connection, QStringLiteral("INSERT INTO task (name, template, path_points, path_closed, "
                                                      "max_speed_m_s, max_accel_m_s2) VALUES (?,?,?,?,?,?)"));
        insert.bind(task.name).bind(storedWord(taskTemplateWords, task.task.kind)).bind(packPath(task.task.path));
        insert.bind(task.task.path.closed ? 1 : 0).bind(task.task.limits.maxSpeedMps);
        if (auto done = insert.bind(task.task.limits.maxAccelMps2).run(); !done)
            return tl::unexpected(done.error());
        TaskRecord stored = task;
        stored.id = insert.insertedId();
        if (auto added = addGates(m_connection, stored.id, task.task.gates); !added)
            return tl::unexpected(added.error());
        return stored;
    });
}

Result<std::vector<TaskRecord>> TaskRepository::all() const
{
    std::vector<TaskRecord> tasks;
    Statement select(m_connection, taskColumns + QStringLiteral("ORDER BY id"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        auto task = readTask(m_connection, row);
        if (!task)
            return tl::unexpected(task.error());
        tasks.push_back(std::move(*task));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return tasks;
}

Result<TaskRecord> TaskRepository::find(const std::string &name) const
{
    Statement select(m_connection, taskColumns + QStringLiteral("WHERE name=?"));
    const auto found = select.bind(name).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchName(m_connection, "task", "task", name);
    return readTask(m_connection, select);
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
