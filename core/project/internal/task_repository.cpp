// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/task_repository.h"

#include "core/analysis/task.h"
#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/records.h"
#include "core/project/repositories.h"

#include <QRegularExpression>

namespace odo {

namespace {

const QString taskColumns = QStringLiteral("SELECT id, name, template, path_points, path_closed, "
                                           "max_speed_m_s, max_accel_m_s2, archived_ms FROM task ");

/// x and y of each point in turn.
QByteArray packPositions(const std::vector<Eigen::Vector2d> &points)
{
    std::vector<double> numbers;
    for (const Eigen::Vector2d &point : points)
        numbers.insert(numbers.end(), {point.x(), point.y()});
    return packNumbers(numbers);
}

/// ifCutOff: why it cannot be used where half a point is at its end.
Result<std::vector<Eigen::Vector2d>> unpackPositions(const QByteArray &blob, const Message &what,
                                                     const Message &ifCutOff)
{
    std::vector<Eigen::Vector2d> points;
    if (blob.isEmpty())
        return points;
    const auto numbers = ODO_TRY(unpackNumbers(blob, what));
    if (numbers.size() % 2 != 0)
        return fail(ErrorCode::InvalidInput, what, ifCutOff, restoreProject());
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        points.emplace_back(numbers[i], numbers[i + 1]);
    return points;
}

Result<void> readZones(const ProjectConnection &connection, const Message &what, TaskRecord &into)
{
    Statement select(
        connection, QStringLiteral("SELECT name, rule, corners FROM zone WHERE task_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&](const Statement &row) -> Result<void> {
        const auto rule = ODO_TRY(fromStoredWord(zoneRuleWords, row.text(1), zoneSubject(row.name(0))));
        auto corners = ODO_TRY(unpackPositions(
            row.blob(2), what,
            ODO_TEXT("project.zone_cut_off", "its zone '%1' ends within a point")(row.name(0))));
        into.task.zones.push_back({row.name(0), rule, std::move(corners)});
        return {};
    });
}

Result<void> readGates(const ProjectConnection &connection, TaskRecord &into)
{
    Statement select(connection,
                     QStringLiteral("SELECT name, role, from_x_m, from_y_m, to_x_m, to_y_m FROM gate "
                                    "WHERE task_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        const auto role = ODO_TRY(fromStoredWord(gateRoleWords, row.text(1), gateSubject(row.name(0))));
        into.task.gates.push_back(
            {row.name(0), role, {row.real(2), row.real(3)}, {row.real(4), row.real(5)}});
        return {};
    });
}

/// Its course into `record`; fails where it cannot be used.
Result<void> readCourse(const ProjectConnection &connection, const Statement &row, TaskRecord &record)
{
    const Message what = taskSubject(record.name);
    const auto kind = ODO_TRY(fromStoredWord(taskTemplateWords, row.text(2), what));
    record.task.kind = kind;
    auto path = ODO_TRY(unpackPositions(
        row.blob(3), what, ODO_TEXT("project.path_cut_off", "its reference path ends within a point")));
    record.task.path = {std::move(path), row.integer(4) != 0};
    record.task.limits = {row.optionalReal(5), row.optionalReal(6)};
    ODO_TRY(readGates(connection, record));
    ODO_TRY(readZones(connection, what, record));
    if (auto valid = checkTask(record.task); !valid)
        return fail(valid.error().code, what, wholeMessage(valid.error().what, valid.error().why),
                    restoreProject());
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
        record.task = {}; // checkStoredTasks reports why
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
        ODO_TRY(checkName(RecordKind::Gate, gate.name));
        Statement insert(connection, QStringLiteral("INSERT INTO gate VALUES (?,?,?,?,?,?,?,?)"));
        insert.bind(task).bind(static_cast<std::int64_t>(i)).bind(gate.name);
        insert.bind(storedWord(gateRoleWords, gate.role)).bind(gate.from.x()).bind(gate.from.y());
        ODO_TRY(insert.bind(gate.to.x()).bind(gate.to.y()).run());
    }
    return {};
}

Result<void> addZones(ProjectConnection &connection, RecordId task, const std::vector<Zone> &zones)
{
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Zone &zone = zones[i];
        ODO_TRY(checkName(RecordKind::Zone, zone.name));
        Statement insert(connection, QStringLiteral("INSERT INTO zone VALUES (?,?,?,?,?)"));
        insert.bind(task).bind(static_cast<std::int64_t>(i)).bind(zone.name);
        ODO_TRY(insert.bind(storedWord(zoneRuleWords, zone.rule)).bind(packPositions(zone.corners)).run());
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
        ODO_TRY(checkName(RecordKind::Task, task.name));
        ODO_TRY(checkTask(task.task));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Task, task.name));
        Statement insert(
            m_connection,
            QStringLiteral("INSERT INTO task (name, template, path_points, path_closed, "
                           "max_speed_m_s, max_accel_m_s2, archived_ms) VALUES (?,?,?,?,?,?,?)"));
        insert.bind(task.name)
            .bind(storedWord(taskTemplateWords, task.task.kind))
            .bind(packPositions(task.task.path.points));
        insert.bind(task.task.path.closed ? 1 : 0).bind(task.task.limits.maxSpeedMps);
        insert.bind(task.task.limits.maxAccelMps2);
        insert.bindReference(task.archived ? task.archived->time_since_epoch().count() : 0);
        ODO_TRY(insert.run());
        TaskRecord stored = task;
        stored.id = insert.insertedId();
        ODO_TRY(addGates(m_connection, stored.id, task.task.gates));
        ODO_TRY(addZones(m_connection, stored.id, task.task.zones));
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
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Task, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Task, name);
    return get(id);
}

Result<TaskRecord> TaskRepository::get(RecordId id) const
{
    Statement select(m_connection, taskColumns + QStringLiteral("WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Task, id);
    return readTask(m_connection, select);
}

// TaskRepository's part of what people change: names, courses, scoring.

namespace {

bool isSameCourse(const Task &a, const Task &b)
{
    const auto isSameGate = [](const Gate &one, const Gate &other) {
        return one.name == other.name && one.role == other.role && one.from == other.from &&
               one.to == other.to;
    };
    const auto isSameZone = [](const Zone &one, const Zone &other) {
        return one.name == other.name && one.rule == other.rule && one.corners == other.corners;
    };
    return a.kind == b.kind &&
           std::equal(a.zones.begin(), a.zones.end(), b.zones.begin(), b.zones.end(), isSameZone) &&
           std::equal(a.gates.begin(), a.gates.end(), b.gates.begin(), b.gates.end(), isSameGate) &&
           a.path.points == b.path.points && a.path.closed == b.path.closed &&
           a.limits.maxSpeedMps == b.limits.maxSpeedMps && a.limits.maxAccelMps2 == b.limits.maxAccelMps2;
}

/// "Circle (version 1)", free in the project.
Result<std::string> versionName(const ProjectConnection &connection, const std::string &name)
{
    for (int number = 1;; ++number) {
        const std::string suffix = " (version " + std::to_string(number) + ")";
        QString stem = QString::fromStdString(name);
        stem.truncate(maxNameLength - static_cast<qsizetype>(suffix.size()));
        if (!stem.isEmpty() && stem.back().isHighSurrogate())
            stem.chop(1);
        std::string version = stem.toStdString() + suffix;
        auto isFree = checkNameIsFree(connection, RecordKind::Task, version);
        if (isFree)
            return version;
        if (isFree.error().code != ErrorCode::AlreadyExists)
            return tl::unexpected(isFree.error());
    }
}

Result<void> setName(ProjectConnection &connection, RecordId task, const std::string &name)
{
    Statement update(connection, QStringLiteral("UPDATE task SET name=? WHERE id=?"));
    return update.bind(name).bind(task).run();
}

Result<void> removeRows(ProjectConnection &connection, RecordId task)
{
    for (const char *sql : {"DELETE FROM scoring WHERE task_id=?", "DELETE FROM gate WHERE task_id=?",
                            "DELETE FROM zone WHERE task_id=?", "DELETE FROM task WHERE id=?"})
        ODO_TRY(runFor(connection, sql, task));
    return {};
}

Criterion criterionOf(const Statement &row)
{
    return {row.text(1), row.real(2), row.real(3), row.real(4)};
}

} // namespace

bool isEarlierVersion(const TaskRecord &task, const TaskUse &use)
{
    static const QRegularExpression version(QStringLiteral(" \\(version [0-9]+\\)$"));
    return use.trials == 0 && use.analyses > 0 && version.match(QString::fromStdString(task.name)).hasMatch();
}

Result<std::map<RecordId, TaskUse>> TaskRepository::uses() const
{
    std::map<RecordId, TaskUse> uses;
    Statement trials(
        m_connection,
        QStringLiteral("SELECT task_id, COUNT(*) FROM trial WHERE task_id IS NOT NULL GROUP BY task_id"));
    auto read = trials.eachRow([&uses](const Statement &row) -> Result<void> {
        uses[row.integer(0)].trials = row.smallInteger(1);
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    Statement analyses(
        m_connection,
        QStringLiteral("SELECT task_id, COUNT(*) FROM analysis WHERE task_id IS NOT NULL GROUP BY task_id"));
    read = analyses.eachRow([&uses](const Statement &row) -> Result<void> {
        uses[row.integer(0)].analyses = row.smallInteger(1);
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return uses;
}

Result<std::vector<TaskRecord>> TaskRepository::current() const
{
    auto tasks = all();
    const auto known = uses();
    if (!tasks || !known)
        return tasks ? tl::unexpected(known.error()) : tasks;
    std::erase_if(*tasks, [&known](const TaskRecord &task) {
        const auto use = known->find(task.id);
        return task.archived || (use != known->end() && isEarlierVersion(task, use->second));
    });
    return tasks;
}

Result<void> TaskRepository::rename(RecordId task, const std::string &given)
{
    const std::string name = normalName(given);
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(task);
        if (!known || known->name == name)
            return withoutValue(known);
        ODO_TRY(checkName(RecordKind::Task, name));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Task, name));
        return setName(m_connection, task, name);
    });
}

Result<void> TaskRepository::setArchived(RecordId task, bool archived)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(task);
        if (!known || known->archived.has_value() == archived)
            return known ? Result<void>() : tl::unexpected(known.error());
        Statement update(m_connection, QStringLiteral("UPDATE task SET archived_ms=? WHERE id=?"));
        return update.bindReference(archived ? instantNow().time_since_epoch().count() : 0).bind(task).run();
    });
}

Result<void> TaskRepository::moveAll(RecordId from, RecordId to)
{
    for (const char *table : {"trial", "scoring"}) {
        Statement update(m_connection,
                         QStringLiteral("UPDATE %1 SET task_id=? WHERE task_id=?").arg(QLatin1String(table)));
        ODO_TRY(update.bind(to).bind(from).run());
    }
    Statement identity(m_connection,
                       QStringLiteral("UPDATE school_document SET row_id=? WHERE kind='task' AND row_id=?"));
    return identity.bind(to).bind(from).run();
}

Result<TaskRecord> TaskRepository::change(const TaskRecord &task)
{
    return transact(m_connection, [&]() -> Result<TaskRecord> {
        auto before = get(task.id);
        if (!before || isSameCourse(before->task, task.task))
            return before;
        const auto version = ODO_TRY(versionName(m_connection, before->name));
        ODO_TRY(setName(m_connection, before->id, version));
        auto added = ODO_TRY(add({0, before->name, task.task, before->archived}));
        ODO_TRY(moveAll(before->id, added.id));
        const auto known = ODO_TRY(uses());
        if (!known.contains(before->id))
            ODO_TRY(removeRows(m_connection, before->id));
        return added;
    });
}

Result<void> TaskRepository::remove(RecordId task)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(task);
        const auto used = uses();
        if (!known || !used)
            return tl::unexpected(known ? used.error() : known.error());
        const auto use = used->find(task);
        if (use != used->end() && use->second.trials > 0)
            return fail(ErrorCode::InvalidInput, taskSubject(known->name),
                        use->second.trials == 1
                            ? Message(ODO_TEXT("project.task_has_trial", "a trial uses it"))
                            : ODO_TEXT("project.task_has_trials", "%1 trials use it")(use->second.trials),
                        ODO_TEXT("project.give_another_task", "give them another task first"));
        if (use != used->end())
            return fail(
                ErrorCode::InvalidInput, taskSubject(known->name),
                ODO_TEXT("project.measured_by_task", "its rules were used to measure trials"),
                joined({keepIt(), ODO_TEXT("project.figures_without_task",
                                           "without it, their metrics would not show which rules applied")},
                       Join::Colon));
        return removeRows(m_connection, task);
    });
}

Result<std::vector<Criterion>> TaskRepository::scoring(RecordId task) const
{
    std::vector<Criterion> criteria;
    Statement select(
        m_connection,
        QStringLiteral("SELECT task_id, metric, full_at, none_at, points FROM scoring WHERE task_id=? "
                       "ORDER BY position"));
    auto read = select.bind(task).eachRow([&criteria](const Statement &row) -> Result<void> {
        criteria.push_back(criterionOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return criteria;
}

Result<std::map<RecordId, std::vector<Criterion>>> TaskRepository::scorings() const
{
    std::map<RecordId, std::vector<Criterion>> scorings;
    Statement select(
        m_connection,
        QStringLiteral(
            "SELECT task_id, metric, full_at, none_at, points FROM scoring ORDER BY task_id, position"));
    auto read = select.eachRow([&scorings](const Statement &row) -> Result<void> {
        scorings[row.integer(0)].push_back(criterionOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return scorings;
}

Result<void> TaskRepository::setScoring(RecordId task, const std::vector<Criterion> &criteria)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(task);
        const auto before = scoring(task);
        if (!known || !before)
            return tl::unexpected(known ? before.error() : known.error());
        ODO_TRY(checkScoring(criteria));
        if (*before == criteria)
            return {};
        ODO_TRY(runFor(m_connection, "DELETE FROM scoring WHERE task_id=?", task));
        std::int64_t position = 0;
        for (const Criterion &line : criteria) {
            ODO_TRY(checkName(RecordKind::Metric, line.metric));
            Statement insert(m_connection, QStringLiteral("INSERT INTO scoring VALUES (?,?,?,?,?,?)"));
            insert.bind(task).bind(position++).bind(line.metric).bind(line.fullAt).bind(line.noneAt);
            ODO_TRY(insert.bind(line.points).run());
        }
        return {};
    });
}

} // namespace odo
