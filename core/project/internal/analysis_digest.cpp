// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/analysis_digest.h"

#include "core/base/sha256.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"

#include <bit>
#include <map>
#include <sqlite3.h>
#include <utility>

namespace odo {

namespace {

/// Rows that a digest goes over: of each, those of another statement that belong to it (by the first column,
/// which is not digested itself).
struct DigestedRows
{
    const char *rows, *chunks;
    /// joined a format that had digests already: where there are none, the digest is as it was without them
    bool isLater = false;
};

/// ?1 is the analysis, or the first column of the row that the chunks belong to.
std::vector<DigestedRows> rowsOf(DigestPart part)
{
    switch (part) {
    case DigestPart::Measurements:
        return {
            {"SELECT series.id, recording.position, series.algorithm FROM analysis JOIN recording ON "
             "recording.trial_id=analysis.trial_id "
             "JOIN observation_series AS series ON series.id=(SELECT MAX(id) FROM observation_series JOIN "
             "series_in_force ON series_id=id WHERE "
             "recording_id=recording.id AND robot_id=analysis.robot_id) WHERE analysis.id=?1 ORDER BY "
             "recording.position",
             "SELECT NULL, position, observations FROM observation_chunk WHERE series_id=?1 ORDER BY "
             "position"},
            {"SELECT track.id, file, sha256, bytes, format, reading FROM analysis JOIN imported_track AS "
             "track ON track.id="
             "(SELECT MAX(id) FROM imported_track WHERE trial_id=analysis.trial_id AND "
             "robot_id=analysis.robot_id) WHERE analysis.id=?1",
             "SELECT NULL, position, samples FROM imported_track_chunk WHERE track_id=?1 ORDER BY position"}};
    case DigestPart::Recordings:
        return {
            {"SELECT recording.id, position, sha256, bytes, width_px, height_px, frames_per_second, "
             "start_offset_s, start_offset_sigma_s, "
             "clock_rate, recording.sync_method FROM analysis JOIN recording ON "
             "recording.trial_id=analysis.trial_id "
             "WHERE analysis.id=?1 ORDER BY position",
             "SELECT NULL, position, times FROM frame_time_chunk WHERE recording_id=?1 ORDER BY position"}};
    case DigestPart::Registrations:
        return {{"SELECT registration.id, position, qw, qx, qy, qz, x_m, y_m, z_m, pose_covariance, rms_px, "
                 "rms_m, verdict, width_px, "
                 "height_px, fx_px, fy_px, cx_px, cy_px, model, distortion, covariance FROM analysis_view "
                 "JOIN registration ON "
                 "registration.id=registration_id JOIN lens ON lens.id=COALESCE((SELECT lens_id FROM "
                 "intrinsics WHERE "
                 "intrinsics.id=registration.intrinsics_id), assumed_lens_id) WHERE analysis_id=?1 ORDER BY "
                 "position",
                 "SELECT NULL, position, label, u_px, v_px FROM registration_pixel WHERE registration_id=?1 "
                 "ORDER BY position"}};
    case DigestPart::Task:
        return {{"SELECT task.id, template, path_points, path_closed, task.max_speed_m_s, "
                 "task.max_accel_m_s2 FROM analysis JOIN task "
                 "ON task.id=task_id WHERE analysis.id=?1",
                 "SELECT NULL, position, name, role, from_x_m, from_y_m, to_x_m, to_y_m FROM gate WHERE "
                 "task_id=?1 ORDER BY position"},
                {"SELECT task_id, zone.position, zone.name, rule, corners FROM analysis JOIN zone USING "
                 "(task_id) WHERE analysis.id=?1 "
                 "ORDER BY zone.position",
                 nullptr}};
    case DigestPart::Positions:
        return {{"SELECT NULL, position, samples, points FROM analysis_chunk WHERE analysis_id=?1 ORDER BY "
                 "position",
                 nullptr}};
    case DigestPart::Results:
        return {
            {"SELECT NULL, trial_id, robot_id, made_ms, software_version, smoother, max_speed_m_s, "
             "max_accel_m_s2, longest_bridged_gap_ns, "
             "height_m, height_estimated, mean_view_disagreement_m, task_id FROM analysis WHERE id=?1",
             nullptr},
            {"SELECT NULL, position, name, registration_id FROM analysis_view WHERE analysis_id=?1 ORDER BY "
             "position",
             nullptr},
            {"SELECT NULL, frame, is_spike FROM analysis_overrule WHERE analysis_id=?1 ORDER BY frame",
             nullptr},
            {"SELECT NULL, position, name, unit, value, sigma FROM metric WHERE analysis_id=?1 ORDER BY "
             "position",
             nullptr},
            {"SELECT NULL, position, sample_index, time_ns, flags, reason FROM spike WHERE analysis_id=?1 "
             "ORDER BY position",
             nullptr},
            {"SELECT NULL, position, gate, role, time_ns, sigma_s, common_sigma_s FROM gate_passage WHERE "
             "analysis_id=?1 ORDER BY position",
             nullptr},
            {"SELECT NULL, doubtful_name.position, from_ns, to_ns, robot_id FROM doubtful_name LEFT JOIN "
             "doubtful_name_robot "
             "USING (analysis_id, position) WHERE analysis_id=?1 ORDER BY doubtful_name.position, robot_id",
             nullptr, true},
            // Where migrations digest, formats before 19 have no such columns: the names are then the outer
            // ones.
            {"SELECT NULL, first, last FROM (SELECT (SELECT range_from_ns FROM analysis WHERE id=?1) AS "
             "first, (SELECT range_to_ns FROM analysis WHERE id=?1) AS last FROM (SELECT NULL AS "
             "range_from_ns, NULL AS range_to_ns)) WHERE COALESCE(first, last) IS NOT NULL",
             nullptr, true}};
    }
    return {};
}

/// The words that are stored; a published one is never changed.
const char *storedPart(DigestPart part)
{
    switch (part) {
    case DigestPart::Measurements:
        return "measurements";
    case DigestPart::Recordings:
        return "recordings";
    case DigestPart::Registrations:
        return "registrations";
    case DigestPart::Task:
        return "task";
    case DigestPart::Positions:
        return "positions";
    case DigestPart::Results:
        return "results";
    }
    return "";
}

/// Each value with its type and length in front, so that no two rows give the same bytes.
void addValue(Sha256 &hash, sqlite3_stmt *row, int column)
{
    const int type = sqlite3_column_type(row, column);
    const auto addBytes = [&](const void *bytes, std::uint64_t count) {
        const std::uint64_t head = std::uint64_t(type) << 56 | count;
        std::array<unsigned char, 8> littleEndian{};
        for (std::size_t i = 0; i < littleEndian.size(); ++i)
            littleEndian[i] = static_cast<unsigned char>(head >> (8 * i));
        hash.add(littleEndian.data(), littleEndian.size());
        hash.add(bytes, count);
    };
    const auto addNumber = [&](std::uint64_t bits) {
        std::array<unsigned char, 8> littleEndian{};
        for (std::size_t i = 0; i < littleEndian.size(); ++i)
            littleEndian[i] = static_cast<unsigned char>(bits >> (8 * i));
        addBytes(littleEndian.data(), littleEndian.size());
    };
    switch (type) {
    case SQLITE_INTEGER:
        return addNumber(static_cast<std::uint64_t>(sqlite3_column_int64(row, column)));
    case SQLITE_FLOAT:
        return addNumber(std::bit_cast<std::uint64_t>(sqlite3_column_double(row, column)));
    case SQLITE_NULL:
        return addBytes(nullptr, 0);
    default:
        const void *bytes =
            type == SQLITE_TEXT ? sqlite3_column_text(row, column) : sqlite3_column_blob(row, column);
        return addBytes(bytes, static_cast<std::uint64_t>(sqlite3_column_bytes(row, column)));
    }
}

struct Finalize
{
    void operator()(sqlite3_stmt *statement) const { sqlite3_finalize(statement); }
};
using Prepared = std::unique_ptr<sqlite3_stmt, Finalize>;

} // namespace

struct AnalysisDigests::Queries
{
    const ProjectConnection &connection;
    std::map<const char *, Prepared> prepared; ///< by the text, which is a constant

    tl::unexpected<Error> failure() const
    {
        return fail(ErrorCode::InvalidInput, connection.subject(), fileIsDamaged(), restoreFile());
    }

    /// Calls the function for each row.
    template <class Take>
    Result<void> each(const char *sql, RecordId id, const Take &take)
    {
        Prepared &known = prepared[sql];
        if (!known) {
            sqlite3_stmt *fresh = nullptr;
            if (sqlite3_prepare_v3(connection.handle(), sql, -1, SQLITE_PREPARE_PERSISTENT, &fresh,
                                   nullptr) != SQLITE_OK)
                return failure();
            known.reset(fresh);
        }
        sqlite3_stmt *const statement = known.get();
        sqlite3_bind_int64(statement, 1, id);
        Result<void> outcome;
        int code = SQLITE_ROW;
        while (outcome && (code = sqlite3_step(statement)) == SQLITE_ROW)
            outcome = take(statement);
        sqlite3_reset(statement);
        return outcome && code != SQLITE_DONE ? failure() : outcome;
    }

    Result<void> addRows(Sha256 &hash, const DigestedRows &rows, RecordId id)
    {
        bool isBegun = !rows.isLater;
        return each(rows.rows, id, [&](sqlite3_stmt *row) -> Result<void> {
            if (!std::exchange(isBegun, true))
                hash.add("", 1);
            for (int column = 1; column < sqlite3_column_count(row); ++column)
                addValue(hash, row, column);
            if (rows.chunks == nullptr)
                return {};
            return addRows(hash, {rows.chunks, nullptr}, sqlite3_column_int64(row, 0));
        });
    }
};

AnalysisDigests::AnalysisDigests(const ProjectConnection &connection) : m_queries(new Queries{connection, {}})
{
}

AnalysisDigests::~AnalysisDigests() = default;

Result<std::string> AnalysisDigests::make(RecordId analysis, DigestPart part)
{
    Sha256 hash;
    for (const DigestedRows &rows : rowsOf(part)) {
        // Where one kind of rows ends and the next begins.
        if (!rows.isLater)
            hash.add("", 1);
        ODO_TRY(m_queries->addRows(hash, rows, analysis));
    }
    return hash.hex();
}

Result<AnalysisDigests::Outcome> AnalysisDigests::compare(RecordId analysis,
                                                          std::span<const DigestPart> parts)
{
    std::map<std::string, std::string> stored;
    auto read =
        m_queries->each("SELECT part, sha256 FROM analysis_digest WHERE analysis_id=?1", analysis,
                        [&](sqlite3_stmt *row) -> Result<void> {
                            const auto text = [row](int column) {
                                const auto *characters =
                                    reinterpret_cast<const char *>(sqlite3_column_text(row, column));
                                return characters != nullptr ? std::string(characters) : std::string();
                            };
                            stored.emplace(text(0), text(1));
                            return {};
                        });
    if (!read)
        return tl::unexpected(read.error());
    Outcome outcome;
    outcome.isKept = !stored.empty();
    for (const DigestPart part : parts) {
        if (!outcome.isKept)
            break;
        const auto now = ODO_TRY(make(analysis, part));
        if (now != stored[storedPart(part)])
            outcome.changed.push_back(part);
    }
    return outcome;
}

namespace {

Result<void> writeDigest(ProjectConnection &connection, AnalysisDigests &digests, RecordId analysis,
                         DigestPart part)
{
    const auto made = ODO_TRY(digests.make(analysis, part));
    Statement insert(connection, QStringLiteral("INSERT OR REPLACE INTO analysis_digest VALUES (?,?,?)"));
    return insert.bind(analysis).bind(std::string(storedPart(part))).bind(made).run();
}

} // namespace

Result<void> writeDigests(ProjectConnection &connection, RecordId analysis)
{
    AnalysisDigests digests(connection);
    for (const DigestPart part : allDigestParts)
        ODO_TRY(writeDigest(connection, digests, analysis, part));
    return {};
}

Result<void> keepDigestsRight(ProjectConnection &connection, const std::vector<DigestedPart> &parts,
                              const std::function<Result<void>()> &work)
{
    return transact(connection, [&]() -> Result<void> {
        AnalysisDigests digests(connection);
        std::vector<DigestedPart> right;
        for (const DigestedPart &one : parts) {
            const auto compared = ODO_TRY(digests.compare(one.analysis, std::array{one.part}));
            if (compared.isKept && compared.changed.empty())
                right.push_back(one);
        }
        ODO_TRY(work());
        for (const auto &[analysis, part] : right)
            ODO_TRY(writeDigest(connection, digests, analysis, part));
        return {};
    });
}

Result<void> setRecordingHash(ProjectConnection &connection, RecordId recording, const std::string &sha256)
{
    return transact(connection, [&]() -> Result<void> {
        std::vector<DigestedPart> parts;
        Statement analyses(
            connection,
            QStringLiteral(
                "SELECT analysis.id FROM analysis JOIN recording ON recording.trial_id=analysis.trial_id "
                "WHERE recording.id=?"));
        auto read = analyses.bind(recording).eachRow([&parts](const Statement &row) -> Result<void> {
            parts.push_back({row.integer(0), DigestPart::Recordings});
            return {};
        });
        if (!read)
            return read;
        return keepDigestsRight(connection, parts, [&] {
            Statement update(connection, QStringLiteral("UPDATE recording SET sha256=? WHERE id=?"));
            return update.bind(sha256).bind(recording).run();
        });
    });
}

} // namespace odo
