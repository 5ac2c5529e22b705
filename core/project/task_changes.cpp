// SPDX-License-Identifier: GPL-3.0-or-later
// TaskRepository's part of what people change: names, courses, scoring.
#include "core/base/without_value.h"
#include "core/project/connection.h"
#include "core/project/instant_now.h"
#include "core/project/named_rows.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <QRegularExpression>

namespace odo {

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
        auto isFree = checkNameIsFree(connection, "task", "task", version);
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
    for (const char *sql : {"DELETE FROM scoring WHERE task_id=?", "DELETE FROM gate WHERE task_id=?", "DELETE FROM zone WHERE task_id=?",
                            "DELETE FROM task WHERE id=?"})
        if (auto done = runFor(connection, sql, task); !done)
            return done;
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
        if (auto valid = checkName("task", name); !valid)
            return valid;
        if (auto isFree = checkNameIsFree(m_connection, "task", "task", name); !isFree)
            return isFree;
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
        if (auto done = update.bind(to).bind(from).run(); !done)
            return done;
    }
    return {};
}

Result<TaskRecord> TaskRepository::change(const TaskRecord &task)
{
    return transact(m_connection, [&]() -> Result<TaskRecord> {
        auto before = get(task.id);
        if (!before || isSameCourse(before->task, task.task))
            return before;
        const auto version = versionName(m_connection, before->name);
        if (!version)
            return tl::unexpected(version.error());
        if (auto named = setName(m_connection, before->id, *version); !named)
            return tl::unexpected(named.error());
        auto added = add({0, before->name, task.task, before->archived});
        if (!added)
            return added;
        if (auto moved = moveAll(before->id, added->id); !moved)
            return tl::unexpected(moved.error());
        const auto known = uses();
        if (!known)
            return tl::unexpected(known.error());
        if (!known->contains(before->id))
            if (auto gone = removeRows(m_connection, before->id); !gone)
                return tl::unexpected(gone.error());
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
            return fail(ErrorCode::InvalidInput, "task '" + known->name + "'",
                        use->second.trials == 1 ? "a trial has it"
                                                : std::to_string(use->second.trials) + " trials have it",
                        "give them another task first");
        if (use != used->end())
            return fail(ErrorCode::InvalidInput, "task '" + known->name + "'", "trials were measured by it",
                        "keep it: their figures would not say any more what they were measured by");
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
        if (auto valid = checkScoring(criteria); !valid)
            return valid;
        if (*before == criteria)
            return {};
        if (auto gone = runFor(m_connection, "DELETE FROM scoring WHERE task_id=?", task); !gone)
            return gone;
        std::int64_t position = 0;
        for (const Criterion &line : criteria) {
            if (auto valid = checkName("figure", line.metric); !valid)
                return valid;
            Statement insert(m_connection, QStringLiteral("INSERT INTO scoring VALUES (?,?,?,?,?,?)"));
            insert.bind(task).bind(position++).bind(line.metric).bind(line.fullAt).bind(line.noneAt);
            if (auto done = insert.bind(line.points).run(); !done)
                return done;
        }
        return {};
    });
}

} // namespace odo
