// SPDX-License-Identifier: GPL-3.0-or-later
// TrialRepository's part of trials that are being recorded.
#include "core/project/analysis_digest.h"
#include "core/project/connection.h"
#include "core/project/named_rows.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/project/series_blobs.h"

#include <algorithm>

namespace odo {

namespace {

Result<void> removeRecording(ProjectConnection &connection, RecordId id)
{
    for (const char *sql :
         {"DELETE FROM raw_time_chunk WHERE recording_id=?",
          "DELETE FROM frame_time_chunk WHERE recording_id=?", "DELETE FROM recording WHERE id=?"}) {
        if (auto done = runFor(connection, sql, id); !done)
            return done;
    }
    return {};
}

Result<void> updateTrial(ProjectConnection &connection, const TrialRecord &trial)
{
    Statement update(
        connection,
        QStringLiteral(
            "UPDATE trial SET sync_method=?, sync_offset_s=?, sync_offset_sigma_s=?, sync_score=?, "
            "duration_s=?, state='complete' WHERE id=?"));
    update.bind(trial.syncMethod).bind(trial.syncOffsetS).bind(trial.syncOffsetSigmaS).bind(trial.syncScore);
    return update.bind(trial.durationS).bind(trial.id).run();
}

} // namespace

Result<TrialRecord> TrialRepository::begin(const TrialRecord &trial,
                                           const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<TrialRecord> {
        auto added = add(trial, recordings);
        if (!added)
            return added;
        Statement update(m_connection, QStringLiteral("UPDATE trial SET state='recording' WHERE id=?"));
        if (auto done = update.bind(added->id).run(); !done)
            return tl::unexpected(done.error());
        return get(added->id);
    });
}

Result<void> TrialRepository::appendRawTimes(RecordId recording, const RecordedTimes &times)
{
    if (times.pictures.empty() && times.readings.empty())
        return {};
    Statement insert(
        m_connection,
        QStringLiteral(
            "INSERT INTO raw_time_chunk SELECT ?, COUNT(*), ?, ? FROM raw_time_chunk WHERE recording_id=?"));
    insert.bind(recording).bind(packRawTimes(times.pictures)).bind(packClockReadings(times.readings));
    return insert.bind(recording).run();
}

Result<RecordedTimes> TrialRepository::rawTimes(RecordId recording) const
{
    RecordedTimes times;
    const std::string what = "raw times of recording " + std::to_string(recording);
    Statement select(
        m_connection,
        QStringLiteral(
            "SELECT pictures, readings FROM raw_time_chunk WHERE recording_id=? ORDER BY position"));
    auto read = select.bind(recording).eachRow([&](const Statement &row) -> Result<void> {
        if (auto pictures = unpackRawTimes(row.blob(0), what, times.pictures); !pictures)
            return pictures;
        return unpackClockReadings(row.blob(1), what, times.readings);
    });
    if (!read)
        return tl::unexpected(read.error());
    return times;
}

Result<void> TrialRepository::setDuration(RecordId trial, double durationS)
{
    Statement update(m_connection, QStringLiteral("UPDATE trial SET duration_s=? WHERE id=?"));
    return update.bind(durationS).bind(trial).run();
}

Result<void> TrialRepository::complete(const TrialRecord &trial,
                                       const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto before = get(trial.id);
        if (!before)
            return tl::unexpected(before.error());
        if (!before->unfinished)
            return fail(ErrorCode::InvalidInput, "trial '" + before->name + "'",
                        "its recording has ended already", "record another trial");
        const auto begun = this->recordings(trial.id);
        if (!begun)
            return tl::unexpected(begun.error());
        for (const RecordingRecord &recording : *begun) {
            if (std::ranges::find(recordings, recording.id, &RecordingRecord::id) != recordings.end())
                continue;
            if (auto removed = removeRecording(m_connection, recording.id); !removed)
                return removed;
        }
        for (const RecordingRecord &recording : recordings) {
            if (auto updated = updateRecording(m_connection, recording); !updated)
                return updated;
        }
        return updateTrial(m_connection, trial);
    });
}

Result<std::vector<RecordingRecord>> TrialRepository::unhashed() const
{
    std::vector<RecordingRecord> recordings;
    Statement select(
        m_connection,
        QStringLiteral("SELECT recording.id, trial_id, path, bytes FROM recording JOIN trial ON "
                       "trial.id=trial_id WHERE sha256='' AND state='complete' ORDER BY recording.id"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        RecordingRecord recording;
        recording.id = row.integer(0);
        recording.trial = row.integer(1);
        recording.path = row.text(2);
        recording.bytes = row.integer(3);
        recordings.push_back(std::move(recording));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return recordings;
}

Result<void> TrialRepository::setHash(RecordId recording, const std::string &sha256)
{
    return setRecordingHash(m_connection, recording, sha256);
}

Result<void> TrialRepository::removeUnfinished(RecordId trial)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = get(trial);
        if (!known)
            return tl::unexpected(known.error());
        if (!known->unfinished)
            return fail(ErrorCode::InvalidInput, "trial '" + known->name + "'",
                        "its recording has ended, and is kept", "leave it");
        const auto recordings = this->recordings(trial);
        if (!recordings)
            return tl::unexpected(recordings.error());
        for (const RecordingRecord &recording : *recordings) {
            if (auto removed = removeRecording(m_connection, recording.id); !removed)
                return removed;
        }
        if (auto removed = runFor(m_connection, "DELETE FROM trial_robot WHERE trial_id=?", trial); !removed)
            return removed;
        return runFor(m_connection, "DELETE FROM trial WHERE id=?", trial);
    });
}

} // namespace odo
