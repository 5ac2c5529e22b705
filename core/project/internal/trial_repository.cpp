// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/records.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <unordered_map>

namespace odo {

namespace {

const QString trialColumns = QStringLiteral(
    "SELECT trial.id, trial.name, trial.team_id, team.name, class.name, task.name, date_ms, notes, "
    "sync_method, "
    "sync_offset_s, sync_offset_sigma_s, sync_score, duration_s, sync_rate, sync_rate_sigma, "
    "(SELECT COUNT(*) FROM recording WHERE recording.trial_id=trial.id), trial.state, starred, "
    "trial.archived_ms, binned_ms, team.pseudonym, trial.range_from_ns, trial.range_to_ns "
    "FROM trial LEFT JOIN team ON team.id=trial.team_id LEFT JOIN class ON class.id=team.class_id "
    "LEFT JOIN task ON task.id=trial.task_id ");

Message notesOfTrial()
{
    return ODO_TEXT("project.trial_notes", "notes of a trial");
}

std::optional<Instant> instantOf(const Statement &row, int column)
{
    if (!row.optionalReal(column))
        return std::nullopt;
    return Instant(std::chrono::milliseconds(row.integer(column)));
}

TrialRecord trialOf(const Statement &row)
{
    TrialRecord trial;
    trial.id = row.integer(0);
    trial.name = row.name(1);
    trial.team = row.integer(2);
    trial.teamName = row.name(3);
    trial.className = row.name(4);
    trial.task = row.name(5);
    trial.date = Instant(std::chrono::milliseconds(row.integer(6)));
    trial.notes = row.text(7);
    trial.syncMethod = row.text(8);
    trial.syncOffsetS = row.real(9);
    trial.syncOffsetSigmaS = row.real(10);
    trial.syncScore = row.real(11);
    trial.durationS = row.real(12);
    trial.syncRate = row.real(13);
    trial.syncRateSigma = row.real(14);
    trial.viewCount = std::min(row.smallInteger(15), static_cast<int>(mostViews));
    trial.unfinished = row.text(16) == "recording";
    trial.starred = row.integer(17) != 0;
    trial.archived = instantOf(row, 18);
    trial.binned = instantOf(row, 19);
    trial.teamPseudonym = row.name(20);
    trial.range = row.span(21);
    return trial;
}

/// Which trials are meant: a condition on their rows, with its parameters.
struct Choice
{
    QString condition;
    std::vector<std::int64_t> parameters;
};

/// Adds what a trial has several of; trials that were not read are passed over. One query for each kind,
/// however many trials.
Result<void> addLists(const ProjectConnection &connection, const Choice &choice,
                      std::vector<TrialRecord> &trials)
{
    std::unordered_map<RecordId, TrialRecord *> byId;
    for (TrialRecord &trial : trials)
        byId.emplace(trial.id, &trial);
    const auto read = [&](const QString &sql, const auto &take) {
        Statement select(connection, sql.arg(choice.condition));
        for (const std::int64_t parameter : choice.parameters)
            select.bind(parameter);
        return select.eachRow([&](const Statement &row) -> Result<void> {
            if (const auto trial = byId.find(row.integer(0)); trial != byId.end())
                take(*trial->second, row);
            return {};
        });
    };
    auto robots = read(QStringLiteral("SELECT trial_id, robot.id, robot.name FROM trial "
                                      "JOIN trial_robot ON trial_id=trial.id JOIN robot ON robot.id=robot_id "
                                      "WHERE %1 ORDER BY trial_id, trial_robot.position"),
                       [](TrialRecord &trial, const Statement &row) {
                           if (trial.robots.size() == mostRobots)
                               return;
                           trial.robots.push_back(row.integer(1));
                           trial.robotNames.push_back(row.name(2));
                       });
    if (!robots)
        return robots;
    auto tags = read(QStringLiteral("SELECT trial_id, tag FROM trial JOIN trial_tag ON trial_id=trial.id "
                                    "WHERE %1 ORDER BY trial_id, tag"),
                     [](TrialRecord &trial, const Statement &row) {
                         if (trial.tags.size() < mostTags)
                             trial.tags.push_back(row.name(1));
                     });
    if (!tags)
        return tags;
    return read(
        QStringLiteral(
            "SELECT trial_id, trial_variable.name, value FROM trial JOIN trial_variable ON trial_id=trial.id "
            "WHERE %1 ORDER BY trial_id, trial_variable.name"),
        [](TrialRecord &trial, const Statement &row) {
            if (trial.variables.size() < mostVariables)
                trial.variables.emplace(row.name(1), row.name(2));
        });
}

Result<std::vector<TrialRecord>> readTrials(const ProjectConnection &connection, const Choice &choice)
{
    std::vector<TrialRecord> trials;
    Statement select(
        connection,
        trialColumns + QStringLiteral("WHERE %1 ORDER BY date_ms DESC, trial.id DESC").arg(choice.condition));
    for (const std::int64_t parameter : choice.parameters)
        select.bind(parameter);
    auto read = select.eachRow([&trials](const Statement &row) -> Result<void> {
        trials.push_back(trialOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    ODO_TRY(addLists(connection, choice, trials));
    return trials;
}

Result<RecordId> addRow(ProjectConnection &connection, const TrialRecord &trial)
{
    ODO_TRY(checkName(RecordKind::Trial, trial.name));
    ODO_TRY(checkText(notesOfTrial(), trial.notes));
    ODO_TRY(checkNameIsFree(connection, RecordKind::Trial, trial.name));
    const auto task = ODO_TRY(idOfName(connection, RecordKind::Task, trial.task));
    Statement insert(
        connection,
        QStringLiteral(
            "INSERT INTO trial (name, team_id, task_id, date_ms, notes, sync_method, "
            "sync_offset_s, sync_offset_sigma_s, sync_score, duration_s, sync_rate, sync_rate_sigma, "
            "range_from_ns, range_to_ns) VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
    insert.bind(trial.name).bindReference(trial.team).bindReference(task);
    insert.bind(static_cast<std::int64_t>(trial.date.time_since_epoch().count())).bind(trial.notes);
    insert.bind(trial.syncMethod).bind(trial.syncOffsetS).bind(trial.syncOffsetSigmaS).bind(trial.syncScore);
    insert.bind(trial.durationS).bind(trial.syncRate).bind(trial.syncRateSigma).bind(trial.range);
    ODO_TRY(insert.run());
    return insert.insertedId();
}

Result<void> addRobots(ProjectConnection &connection, RecordId trial, const std::vector<RecordId> &robots)
{
    if (robots.size() > mostRobots)
        return fail(ErrorCode::InvalidInput,
                    ODO_TEXT("project.trial_of_project", "trial %1 of the project")(trial),
                    ODO_TEXT("project.has_robots", "it has %1 robots")(robots.size()), useAtMost(mostRobots));
    for (std::size_t i = 0; i < robots.size(); ++i) {
        Statement insert(connection, QStringLiteral("INSERT INTO trial_robot VALUES (?,?,?)"));
        insert.bind(trial).bind(static_cast<std::int64_t>(i)).bind(robots[i]);
        ODO_TRY(insert.run());
    }
    return {};
}

} // namespace

TrialRepository::TrialRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<TrialRecord> TrialRepository::add(const TrialRecord &given,
                                         const std::vector<RecordingRecord> &recordings)
{
    TrialRecord trial = given;
    trial.name = normalName(given.name);
    return transact(m_connection, [&]() -> Result<TrialRecord> {
        if (recordings.size() > mostViews)
            return tooManyViews(trialSubject(trial.name), recordings.size());
        const auto id = ODO_TRY(addRow(m_connection, trial));
        ODO_TRY(addRobots(m_connection, id, trial.robots));
        for (std::size_t i = 0; i < recordings.size(); ++i) {
            RecordingRecord recording = recordings[i];
            recording.trial = id;
            recording.position = static_cast<int>(i);
            ODO_TRY(addRecording(m_connection, recording));
        }
        return get(id);
    });
}

Result<std::vector<TrialRecord>> TrialRepository::all() const
{
    return readTrials(m_connection, {QStringLiteral("1=1"), {}});
}

Result<std::vector<TrialRecord>> TrialRepository::page(const TrialRecord *after, int count) const
{
    // The oldest date of the page, so that the lists are asked for by the same dates.
    Statement oldest(m_connection,
                     QStringLiteral("SELECT MIN(date_ms), COUNT(*) FROM (SELECT date_ms FROM trial WHERE %1 "
                                    "ORDER BY date_ms DESC LIMIT ?)")
                         .arg(after ? QStringLiteral("date_ms<?") : QStringLiteral("1=1")));
    const auto dateMs = [](Instant instant) {
        return static_cast<std::int64_t>(instant.time_since_epoch().count());
    };
    if (after)
        oldest.bind(dateMs(after->date));
    const auto found = ODO_TRY(oldest.bind(count).firstRow());
    if (!found || oldest.integer(1) == 0)
        return std::vector<TrialRecord>();
    Choice choice{QStringLiteral("date_ms>=?"), {oldest.integer(0)}};
    if (after) {
        choice.condition += QStringLiteral(" AND date_ms<?");
        choice.parameters.push_back(dateMs(after->date));
    }
    return readTrials(m_connection, choice);
}

Result<std::vector<TrialName>> TrialRepository::names() const
{
    std::vector<TrialName> names;
    Statement select(
        m_connection,
        QStringLiteral("SELECT trial.id, trial.name, team.name, trial.state, binned_ms FROM trial "
                       "LEFT JOIN team ON team.id=team_id ORDER BY date_ms DESC, trial.id DESC"));
    auto read = select.eachRow([&names](const Statement &row) -> Result<void> {
        names.push_back({row.integer(0), row.name(1), row.name(2), row.text(3) == "recording",
                         instantOf(row, 4).has_value()});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return names;
}

Result<TrialRecord> TrialRepository::find(const std::string &name) const
{
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Trial, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Trial, name);
    return get(id);
}

Result<TrialRecord> TrialRepository::get(RecordId id) const
{
    auto trials = readTrials(m_connection, {QStringLiteral("trial.id=?"), {id}});
    if (!trials)
        return tl::unexpected(trials.error());
    if (trials->empty())
        return noSuchId(m_connection, RecordKind::Trial, id);
    return std::move(trials->front());
}

Result<void> TrialRepository::setName(RecordId trial, const std::string &given)
{
    const std::string name = normalName(given);
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(trial));
        ODO_TRY(checkName(RecordKind::Trial, name));
        if (known.name != name)
            ODO_TRY(checkNameIsFree(m_connection, RecordKind::Trial, name));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET name=? WHERE id=?"));
        return update.bind(name).bind(trial).run();
    });
}

Result<void> TrialRepository::setTeam(RecordId trial, RecordId team)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET team_id=? WHERE id=?"));
        return update.bindReference(team).bind(trial).run();
    });
}

Result<void> TrialRepository::setDate(RecordId trial, Instant date)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET date_ms=? WHERE id=?"));
        return update.bind(static_cast<std::int64_t>(date.time_since_epoch().count())).bind(trial).run();
    });
}

Result<void> TrialRepository::setNotes(RecordId trial, const std::string &notes)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(checkText(notesOfTrial(), notes));
        ODO_TRY(get(trial));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET notes=? WHERE id=?"));
        return update.bind(notes).bind(trial).run();
    });
}

Result<void> TrialRepository::setRobots(RecordId trial, const std::vector<RecordId> &robots)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection, QStringLiteral("DELETE FROM trial_robot WHERE trial_id=?"));
        ODO_TRY(remove.bind(trial).run());
        return addRobots(m_connection, trial, robots);
    });
}

Result<void> TrialRepository::setTask(RecordId trial, const std::string &task)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        const auto id = ODO_TRY(idOfName(m_connection, RecordKind::Task, task));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET task_id=? WHERE id=?"));
        return update.bindReference(id).bind(trial).run();
    });
}

Result<void> TrialRepository::setRange(RecordId trial, const std::optional<TimeSpan> &range)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        Statement update(m_connection,
                         QStringLiteral("UPDATE trial SET range_from_ns=?, range_to_ns=? WHERE id=?"));
        return update.bind(range).bind(trial).run();
    });
}

Result<bool> TrialRepository::isFileUsed(const std::string &path) const
{
    // A project that was renamed with its media folder names one file in two ways.
    const std::filesystem::path file = absolutePath(m_connection.file(), path);
    const std::string name = file.filename().string();
    bool isUsed = false;
    Statement select(m_connection,
                     QStringLiteral("SELECT path FROM recording WHERE substr(path, -length(?))=?"));
    auto read = select.bind(name).bind(name).eachRow([&](const Statement &row) -> Result<void> {
        isUsed = isUsed || absolutePath(m_connection.file(), row.text(0)) == file;
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return isUsed;
}

Result<std::vector<RecordingRecord>> TrialRepository::recordings(RecordId trial) const
{
    return recordingsOf(m_connection, trial);
}

Result<std::vector<RecordingRecord>> TrialRepository::allRecordings() const
{
    return recordingsWithoutTimes(m_connection);
}

Result<std::optional<RecordingRecord>> TrialRepository::newestRecording(RecordId camera) const
{
    return newestRecordingOf(m_connection, camera);
}

Result<void> TrialRepository::setFile(RecordId recording, const std::filesystem::path &file)
{
    Statement update(m_connection, QStringLiteral("UPDATE recording SET path=? WHERE id=?"));
    return update.bind(storedPath(m_connection.file(), file)).bind(recording).run();
}

Result<void> TrialRepository::setSync(const TrialRecord &trial,
                                      const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial.id));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET sync_method=?, sync_offset_s=?, "
                                                      "sync_offset_sigma_s=?, sync_score=?, sync_rate=?, "
                                                      "sync_rate_sigma=? WHERE id=?"));
        update.bind(trial.syncMethod)
            .bind(trial.syncOffsetS)
            .bind(trial.syncOffsetSigmaS)
            .bind(trial.syncScore)
            .bind(trial.syncRate)
            .bind(trial.syncRateSigma);
        ODO_TRY(update.bind(trial.id).run());
        for (const RecordingRecord &recording : recordings) {
            Statement its(m_connection,
                          QStringLiteral("UPDATE recording SET sync_method=?, start_offset_s=?, "
                                         "start_offset_sigma_s=?, clock_rate=? WHERE id=?"));
            its.bind(recording.syncMethod)
                .bind(recording.startOffsetS)
                .bind(recording.startOffsetSigmaS)
                .bind(recording.clockRate);
            ODO_TRY(its.bind(recording.id).run());
        }
        return {};
    });
}

// TrialRepository's part of what people do with trials through the year: stars, tags, archive and bin.

namespace {

/// NULL, or now.
Result<void> stamp(ProjectConnection &connection, const char *sql, RecordId trial, bool isSet)
{
    const auto now = instantNow();
    Statement update(connection, QString::fromLatin1(sql));
    return update.bindReference(isSet ? now.time_since_epoch().count() : 0).bind(trial).run();
}

} // namespace

Result<void> TrialRepository::setStarred(RecordId trial, bool starred)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET starred=? WHERE id=?"));
        return update.bind(starred ? 1 : 0).bind(trial).run();
    });
}

Result<void> TrialRepository::setTags(RecordId trial, const std::vector<std::string> &tags)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(get(trial));
        ODO_TRY(runFor(m_connection, "DELETE FROM trial_tag WHERE trial_id=?", trial));
        std::set<std::string> normalTags;
        std::ranges::transform(tags, std::inserter(normalTags, normalTags.end()), normalName);
        for (const std::string &tag : normalTags) {
            ODO_TRY(checkName(RecordKind::Tag, tag));
            Statement insert(m_connection, QStringLiteral("INSERT INTO trial_tag VALUES (?,?)"));
            ODO_TRY(insert.bind(trial).bind(tag).run());
        }
        return {};
    });
}

Result<void> TrialRepository::setVariables(RecordId trial,
                                           const std::map<std::string, std::string> &variables)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(trial));
        ODO_TRY(runFor(m_connection, "DELETE FROM trial_variable WHERE trial_id=?", trial));
        if (variables.size() > mostVariables)
            return fail(
                ErrorCode::InvalidInput, trialSubject(known.name),
                ODO_TEXT("project.too_many_variables", "a trial has %1 variables at most")(mostVariables),
                ODO_TEXT("project.remove_variables", "remove some of its variables"));
        for (const auto &[name, value] : variables) {
            ODO_TRY(checkName(RecordKind::Variable, name));
            ODO_TRY(checkName(RecordKind::Variable, value));
            Statement insert(m_connection, QStringLiteral("INSERT INTO trial_variable VALUES (?,?,?)"));
            ODO_TRY(insert.bind(trial).bind(normalName(name)).bind(normalName(value)).run());
        }
        return {};
    });
}

Result<std::vector<std::string>> TrialRepository::tags() const
{
    return textsOf(m_connection, QStringLiteral("SELECT DISTINCT tag FROM trial_tag ORDER BY tag"));
}

Result<void> TrialRepository::setArchived(RecordId trial, bool archived)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto known = get(trial); !known || known->archived.has_value() == archived)
            return withoutValue(known);
        return stamp(m_connection, "UPDATE trial SET archived_ms=? WHERE id=?", trial, archived);
    });
}

Result<void> TrialRepository::setBinned(RecordId trial, bool binned)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(trial);
        if (!known || known->binned.has_value() == binned)
            return withoutValue(known);
        if (known->unfinished)
            return fail(ErrorCode::InvalidInput, trialSubject(known->name),
                        ODO_TEXT("project.being_recorded", "it is being recorded"), endRecordingFirst());
        return stamp(m_connection, "UPDATE trial SET binned_ms=? WHERE id=?", trial, binned);
    });
}

Result<std::int64_t> TrialRepository::binnedBytes() const
{
    return m_connection.number(
        QStringLiteral("SELECT COALESCE(SUM(bytes), 0) FROM recording JOIN trial ON trial.id=trial_id "
                       "WHERE binned_ms IS NOT NULL"));
}

Result<std::vector<std::string>> TrialRepository::removeForGood(RecordId trial)
{
    return transact(m_connection, [&]() -> Result<std::vector<std::string>> {
        const auto known = ODO_TRY(get(trial));
        if (!known.binned)
            return fail(ErrorCode::InvalidInput, trialSubject(known.name),
                        ODO_TEXT("project.not_in_bin", "it is not in the bin"),
                        ODO_TEXT("project.put_into_bin_first", "move it to the bin first"));
        const auto recordings = ODO_TRY(this->recordings(trial));
        std::vector<std::string> files;
        for (const RecordingRecord &recording : recordings)
            files.push_back(recording.path);
        // The triggers that keep raw measurements let those of a removed trial go.
        for (const char *sql :
             {"UPDATE trial SET state='removed' WHERE id=?",
              "DELETE FROM observation_chunk WHERE series_id IN (SELECT observation_series.id FROM "
              "observation_series "
              "JOIN recording ON recording.id=recording_id WHERE trial_id=?)",
              "DELETE FROM series_in_force WHERE series_id IN (SELECT observation_series.id FROM "
              "observation_series "
              "JOIN recording ON recording.id=recording_id WHERE trial_id=?)",
              "DELETE FROM observation_series WHERE recording_id IN (SELECT id FROM recording WHERE "
              "trial_id=?)",
              "DELETE FROM raw_time_chunk WHERE recording_id IN (SELECT id FROM recording WHERE trial_id=?)",
              "DELETE FROM frame_time_chunk WHERE recording_id IN (SELECT id FROM recording WHERE "
              "trial_id=?)",
              "DELETE FROM pointed_out_robot WHERE recording_id IN (SELECT id FROM recording WHERE "
              "trial_id=?)",
              "DELETE FROM guidance WHERE recording_id IN (SELECT id FROM recording WHERE trial_id=?)",
              "DELETE FROM recording WHERE trial_id=?",
              "DELETE FROM analysis_view WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_chunk WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_digest WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_overrule WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM metric WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM spike WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM gate_passage WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM doubtful_name_robot WHERE analysis_id IN (SELECT id FROM analysis WHERE "
              "trial_id=?)",
              "DELETE FROM doubtful_name WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis WHERE trial_id=?",
              "DELETE FROM verdict_check WHERE trial_id=?",
              "DELETE FROM verdict WHERE trial_id=?",
              "DELETE FROM accepted_check WHERE trial_id=?",
              "DELETE FROM accepted_verdict WHERE trial_id=?",
              "DELETE FROM overrule WHERE trial_id=?",
              "DELETE FROM imported_track_chunk WHERE track_id IN (SELECT id FROM imported_track WHERE "
              "trial_id=?)",
              "DELETE FROM imported_track WHERE trial_id=?",
              "DELETE FROM truth WHERE trial_id=?",
              "DELETE FROM trial_tag WHERE trial_id=?",
              "DELETE FROM trial_variable WHERE trial_id=?",
              "DELETE FROM trial_robot WHERE trial_id=?",
              "DELETE FROM trial WHERE id=?"}) {
            ODO_TRY(runFor(m_connection, sql, trial));
        }
        return files;
    });
}

} // namespace odo
