// SPDX-License-Identifier: GPL-3.0-or-later
// TrialRepository's part of what people do with trials through the year: stars, tags, archive and bin.
#include "core/base/without_value.h"
#include "core/project/connection.h"
#include "core/project/instant_now.h"
#include "core/project/named_rows.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace odo {

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
        if (auto known = get(trial); !known)
            return tl::unexpected(known.error());
        Statement update(m_connection, QStringLiteral("UPDATE trial SET starred=? WHERE id=?"));
        return update.bind(starred ? 1 : 0).bind(trial).run();
    });
}

Result<void> TrialRepository::setTags(RecordId trial, const std::vector<std::string> &tags)
{
    return transact(m_connection, [&]() -> Result<void> {
        if (auto known = get(trial); !known)
            return tl::unexpected(known.error());
        if (auto removed = runFor(m_connection, "DELETE FROM trial_tag WHERE trial_id=?", trial); !removed)
            return removed;
        std::set<std::string> normalTags;
        std::ranges::transform(tags, std::inserter(normalTags, normalTags.end()), normalName);
        for (const std::string &tag : normalTags) {
            if (auto valid = checkName("tag", tag); !valid)
                return valid;
            Statement insert(m_connection, QStringLiteral("INSERT INTO trial_tag VALUES (?,?)"));
            if (auto done = insert.bind(trial).bind(tag).run(); !done)
                return done;
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
            return fail(ErrorCode::InvalidInput, "trial '" + known->name + "'", "it is being recorded",
                        "end its recording first");
        return stamp(m_connection, "UPDATE trial SET binned_ms=? WHERE id=?", trial, binned);
    });
}

Result<std::int64_t> TrialRepository::binnedBytes() const
{
    return m_connection.number(QStringLiteral("SELECT COALESCE(SUM(bytes), 0) FROM recording JOIN trial ON trial.id=trial_id "
                                              "WHERE binned_ms IS NOT NULL"));
}

Result<std::vector<std::string>> TrialRepository::removeForGood(RecordId trial)
{
    return transact(m_connection, [&]() -> Result<std::vector<std::string>> {
        const auto known = get(trial);
        if (!known)
            return tl::unexpected(known.error());
        if (!known->binned)
            return fail(ErrorCode::InvalidInput, "trial '" + known->name + "'", "it is not in the bin",
                        "put it into the bin first");
        const auto recordings = this->recordings(trial);
        if (!recordings)
            return tl::unexpected(recordings.error());
        std::vector<std::string> files;
        for (const RecordingRecord &recording : *recordings)
            files.push_back(recording.path);
        // The triggers that keep raw measurements let those of a removed trial go.
        for (const char *sql :
             {"UPDATE trial SET state='removed' WHERE id=?",
              "DELETE FROM observation_chunk WHERE series_id IN (SELECT observation_series.id FROM "
              "observation_series "
              "JOIN recording ON recording.id=recording_id WHERE trial_id=?)",
              "DELETE FROM observation_series WHERE recording_id IN (SELECT id FROM recording WHERE "
              "trial_id=?)",
              "DELETE FROM raw_time_chunk WHERE recording_id IN (SELECT id FROM recording WHERE trial_id=?)",
              "DELETE FROM frame_time_chunk WHERE recording_id IN (SELECT id FROM recording WHERE "
              "trial_id=?)",
              "DELETE FROM pointed_out_robot WHERE recording_id IN (SELECT id FROM recording WHERE trial_id=?)",
              "DELETE FROM recording WHERE trial_id=?",
              "DELETE FROM analysis_view WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_chunk WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_digest WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis_overrule WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM metric WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM spike WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM gate_passage WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM doubtful_name_robot WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM doubtful_name WHERE analysis_id IN (SELECT id FROM analysis WHERE trial_id=?)",
              "DELETE FROM analysis WHERE trial_id=?", "DELETE FROM overrule WHERE trial_id=?",
              "DELETE FROM imported_track_chunk WHERE track_id IN (SELECT id FROM imported_track WHERE trial_id=?)",
              "DELETE FROM imported_track WHERE trial_id=?", "DELETE FROM truth WHERE trial_id=?", "DELETE FROM trial_tag WHERE trial_id=?",
              "DELETE FROM trial_robot WHERE trial_id=?", "DELETE FROM trial WHERE id=?"}) {
            if (auto done = runFor(m_connection, sql, trial); !done)
                return tl::unexpected(done.error());
        }
        return files;
    });
}

} // namespace odo
