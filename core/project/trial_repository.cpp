// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"
#include "core/project/named_rows.h"
#include "core/project/names.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

const QString trialColumns = QStringLiteral(
    "SELECT trial.id, trial.name, trial.team_id, team.name, class.name, task.name, date_ms, notes, "
    "sync_method, "
    "sync_offset_s, sync_offset_sigma_s, sync_score, duration_s, sync_rate, sync_rate_sigma, "
    "(SELECT COUNT(*) FROM recording WHERE recording.trial_id=trial.id), trial.state, starred, "
    "trial.archived_ms, binned_ms "
    "FROM trial LEFT JOIN team ON team.id=trial.team_id LEFT JOIN class ON class.id=team.class_id "
    "LEFT JOIN task ON task.id=trial.task_id ");

std::optional<Instant> instantOf(const Statement &row, int column)
{
    if (!row.optionalReal(column))
        return std::nullopt;
    return Instant(std::chrono::milliseconds(row.integer(column)));
}

/// Calls take with each row's id and text.
template <class Take>
Result<void> readList(const ProjectConnection &connection, const char *sql, RecordId trial, const Take &take)
{
    Statement select(connection, QString::fromLatin1(sql));
    return select.bind(trial).eachRow([&take](const Statement &row) -> Result<void> {
        take(row.integer(0), row.text(1));
        return {};
    });
}

Result<TrialRecord> readTrial(const ProjectConnection &connection, const Statement &row)
{
    TrialRecord trial;
    trial.id = row.integer(0);
    trial.name = row.text(1);
    trial.team = row.integer(2);
    trial.teamName = row.text(3);
    trial.className = row.text(4);
    trial.task = row.text(5);
    trial.date = Instant(std::chrono::milliseconds(row.integer(6)));
    trial.notes = row.text(7);
    trial.syncMethod = row.text(8);
    trial.syncOffsetS = row.real(9);
    trial.syncOffsetSigmaS = row.real(10);
    trial.syncScore = row.real(11);
    trial.durationS = row.real(12);
    trial.syncRate = row.real(13);
    trial.syncRateSigma = row.real(14);
    trial.viewCount = row.smallInteger(15);
    trial.unfinished = row.text(16) == "recording";
    trial.starred = row.integer(17) != 0;
    trial.archived = instantOf(row, 18);
    trial.binned = instantOf(row, 19);
    auto robots = readList(connection,
                           "SELECT robot.id, robot.name FROM trial_robot JOIN robot ON robot.id=trial_robot.robot_id "
                           "WHERE trial_id=? ORDER BY trial_robot.position",
                           trial.id, [&trial](RecordId id, std::string name) {
                               trial.robots.push_back(id);
                               trial.robotNames.push_back(std::move(name));
                           });
    if (!robots)
        return tl::unexpected(robots.error());
    auto tags = readList(connection, "SELECT 0, tag FROM trial_tag WHERE trial_id=? ORDER BY tag", trial.id,
                         [&trial](RecordId, std::string tag) { trial.tags.push_back(std::move(tag)); });
    if (!tags)
        return tl::unexpected(tags.error());
    return trial;
}

Result<RecordId> addRow(ProjectConnection &connection, const TrialRecord &trial)
{
    if (auto valid = checkName("trial", trial.name); !valid)
        return tl::unexpected(valid.error());
    if (auto valid = checkText("notes of a trial", trial.notes); !valid)
        return tl::unexpected(valid.error());
    if (auto isFree = checkNameIsFree(connection, "trial", "trial", trial.name); !isFree)
        return tl::unexpected(isFree.error());
    const auto task = idOfName(connection, "task", trial.task);
    if (!task)
        return tl::unexpected(task.error());
    Statement insert(connection,
                     QStringLiteral("INSERT INTO trial (name, team_id, task_id, date_ms, notes, sync_method, "
                                    "sync_offset_s, sync_offset_sigma_s, sync_score, duration_s, sync_rate, sync_rate_sigma) "
                                    "VALUES (?,?,?,?,?,?,?,?,?,?,?,?)"));
    insert.bind(trial.name).bindReference(trial.team).bindReference(*task);
    insert.bind(static_cast<std::int64_t>(trial.date.time_since_epoch().count())).bind(trial.notes);
    insert.bind(trial.syncMethod).bind(trial.syncOffsetS).bind(trial.syncOffsetSigmaS).bind(trial.syncScore);
    if (auto done = insert.bind(trial.durationS).bind(trial.syncRate).bind(trial.syncRateSigma).run(); !done)
        return tl::unexpected(done.error());
    return insert.insertedId();
}

Result<void> addRobots(ProjectConnection &connection, RecordId trial, const std::vector<RecordId> &robots)
{
    for (std::size_t i = 0; i < robots.size(); ++i) {
        Statement insert(connection, QStringLiteral("INSERT INTO trial_robot VALUES (?,?,?)"));
        insert.bind(trial).bind(static_cast<std::int64_t>(i)).bind(robots[i]);
        if (auto done = insert.run(); !done)
            return done;
    }
    return {};
}

} // namespace

TrialRepository::TrialRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TrialRecord> TrialRepository::add(const TrialRecord &trial,
                                         const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<TrialRecord> {
        const auto id = addRow(m_connection, trial);
        if (!id)
            return tl::unexpected(id.error());
        if (auto added = addRobots(m_connection, *id, trial.robots); !added)
            return tl::unexpected(added.error());
        for (std::size_t i = 0; i < recordings.size(); ++i) {
            RecordingRecord recording = recordings[i];
            recording.trial = *id;
            recording.position = static_cast<int>(i);
            if (auto added = addRecording(m_connection, recording); !added)
                return tl::unexpected(added.error());
        }
        return get(*id);
    });
}

Result<std::vector<TrialRecord>> TrialRepository::all() const
{
    std::vector<TrialRecord> trials;
    Statement select(m_connection, trialColumns + QStringLiteral("ORDER BY date_ms DESC, trial.id DESC"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        auto trial = readTrial(m_connection, row);
        if (!trial)
            return tl::unexpected(trial.error());
        trials.push_back(std::move(*trial));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return trials;
}

Result<TrialRecord> TrialRepository::find(const std::string &name) const
{
    Statement select(m_connection, trialColumns + QStringLiteral("WHERE trial.name=?"));
    const auto found = select.bind(name).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchName(m_connection, "trial", "trial", name);
    return readTrial(m_connection, select);
}

Result<TrialRecord> TrialRepository::get(RecordId id) const
{
    Statement select(m_connection, trialColumns + QStringLiteral("WHERE trial.id=?"));
    const auto found = select.bind(id).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchId(m_connection, "trial", id);
    return readTrial(m_connection, select);
}

Result<void> TrialRepository::setNotes(RecordId trial, const std::string &notes)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto valid = checkText("notes of a trial", notes); !valid)
            return valid;
        if (auto known = get(trial); !known)
            return tl::unexpected(known.error());
        Statement update(m_connection, QStringLiteral("UPDATE trial SET notes=? WHERE id=?"));
        return update.bind(notes).bind(trial).run();
    });
}

Result<void> TrialRepository::setRobots(RecordId trial, const std::vector<RecordId> &robots)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection, QStringLiteral("DELETE FROM trial_robot WHERE trial_id=?"));
        if (auto done = remove.bind(trial).run(); !done)
            return done;
        return addRobots(m_connection, trial, robots);
    });
}

Result<void> TrialRepository::setTask(RecordId trial, const std::string &task)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto known = get(trial); !known)
            return tl::unexpected(known.error());
        const auto id = idOfName(m_connection, "task", task);
        if (!id)
            return tl::unexpected(id.error());
        Statement update(m_connection, QStringLiteral("UPDATE trial SET task_id=? WHERE id=?"));
        return update.bindReference(*id).bind(trial).run();
    });
}

Result<std::vector<RecordingRecord>> TrialRepository::recordings(RecordId trial) const
{
    return recordingsOf(m_connection, trial);
}

Result<void> TrialRepository::setSync(const TrialRecord &trial)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto known = get(trial.id); !known)
            return tl::unexpected(known.error());
        Statement update(m_connection, QStringLiteral("UPDATE trial SET sync_method=?, sync_offset_s=?, "
                                                      "sync_offset_sigma_s=?, sync_score=?, sync_rate=?, "
                                                      "sync_rate_sigma=? WHERE id=?"));
        update.bind(trial.syncMethod)
            .bind(trial.syncOffsetS)
            .bind(trial.syncOffsetSigmaS)
            .bind(trial.syncScore)
            .bind(trial.syncRate)
            .bind(trial.syncRateSigma);
        if (auto done = update.bind(trial.id).run(); !done)
            return done;
        Statement second(
            m_connection,
            QStringLiteral("UPDATE recording SET sync_method=?, start_offset_s=?, start_offset_sigma_s=?, clock_rate=? "
                           "WHERE trial_id=? AND position=1"));
        second.bind(trial.syncMethod).bind(trial.syncOffsetS).bind(trial.syncOffsetSigmaS).bind(trial.syncRate);
        return second.bind(trial.id).run();
    });
}

} // namespace odo
