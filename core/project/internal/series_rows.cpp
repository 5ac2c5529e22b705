// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_rows.h"

#include "core/analysis/profile.h"
#include "core/project/guidance_repository.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/trajectory/imported_track.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace odo {

// The observations, the imported tracks, the overrides and the truth of TrialRepository.

Result<void> TrialRepository::addObservations(const ObservationSeries &series)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement insert(m_connection,
                         QStringLiteral("INSERT INTO observation_series (recording_id, robot_id, "
                                        "algorithm) VALUES (?,?,?)"));
        ODO_TRY(insert.bind(series.recording).bind(series.robot).bind(series.algorithm).run());
        const RecordId id = insert.insertedId();
        const std::span<const Observation> all(series.observations);
        for (std::size_t start = 0; start < all.size(); start += rowsPerChunk) {
            const auto chunk = all.subspan(start, std::min(rowsPerChunk, all.size() - start));
            Statement row(m_connection, QStringLiteral("INSERT INTO observation_chunk VALUES (?,?,?)"));
            row.bind(id).bind(static_cast<std::int64_t>(start / rowsPerChunk)).bind(packObservations(chunk));
            ODO_TRY(row.run());
        }
        Statement inForce(m_connection, QStringLiteral("INSERT INTO series_in_force VALUES (?)"));
        return inForce.bind(id).run();
    });
}

namespace {

const QString currentSeries =
    QStringLiteral("SELECT id, algorithm FROM observation_series JOIN series_in_force ON series_id=id "
                   "WHERE recording_id=? AND robot_id=? %1 ORDER BY id DESC LIMIT 1");

} // namespace

Result<std::optional<std::string>> TrialRepository::currentAlgorithm(RecordId recording, RecordId robot) const
{
    Statement select(m_connection, currentSeries.arg(QString()));
    const auto found = ODO_TRY(select.bind(recording).bind(robot).firstRow());
    return found ? std::optional(select.text(1)) : std::nullopt;
}

Result<std::optional<ObservationSeries>>
TrialRepository::currentObservations(RecordId recording, RecordId robot, bool asTracked) const
{
    Statement select(
        m_connection,
        currentSeries.arg(asTracked
                              ? QStringLiteral("AND instr(algorithm, '%1')=0").arg(QLatin1String(handNote))
                              : QString()));
    const auto found = ODO_TRY(select.bind(recording).bind(robot).firstRow());
    if (!found)
        return std::nullopt;
    const RecordId id = select.integer(0);
    ObservationSeries series{recording, robot, select.text(1), {}};
    Statement chunks(
        m_connection,
        QStringLiteral("SELECT observations FROM observation_chunk WHERE series_id=? ORDER BY position"));
    const Message what = ODO_TEXT("project.observations_of_project", "observations %1 of the project")(id);
    auto read = chunks.bind(id).eachRow([&](const Statement &row) -> Result<void> {
        return unpackObservations(row.blob(0), what, series.observations);
    });
    if (!read)
        return tl::unexpected(read.error());
    return std::optional(std::move(series));
}

Result<void> TrialRepository::setManualOverrides(RecordId trial, RecordId robot,
                                                 const std::vector<ManualOverride> &overrides)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection,
                         QStringLiteral("DELETE FROM overrule WHERE trial_id=? AND robot_id=?"));
        ODO_TRY(remove.bind(trial).bind(robot).run());
        for (const ManualOverride &manualOverride : overrides) {
            Statement insert(m_connection, QStringLiteral("INSERT INTO overrule VALUES (?,?,?,?)"));
            insert.bind(trial).bind(robot).bind(manualOverride.frame).bind(manualOverride.isSpike ? 1 : 0);
            ODO_TRY(insert.run());
        }
        return {};
    });
}

Result<std::vector<ManualOverride>> TrialRepository::overrides(RecordId trial, RecordId robot) const
{
    std::vector<ManualOverride> overrides;
    Statement select(m_connection, QStringLiteral("SELECT frame, is_spike FROM overrule WHERE trial_id=? AND "
                                                  "robot_id=? ORDER BY frame"));
    auto read = select.bind(trial).bind(robot).eachRow([&](const Statement &row) -> Result<void> {
        overrides.push_back({row.integer(0), row.integer(1) != 0});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return overrides;
}

Result<void> TrialRepository::setPointedOut(RecordId trial, const std::vector<PointedOutRobot> &robots)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection, QStringLiteral("DELETE FROM pointed_out_robot WHERE recording_id IN "
                                                      "(SELECT id FROM recording WHERE trial_id=?)"));
        ODO_TRY(remove.bind(trial).run());
        for (const PointedOutRobot &one : robots) {
            Statement insert(m_connection,
                             QStringLiteral("INSERT INTO pointed_out_robot VALUES (?,?,?,?,?)"));
            insert.bind(one.recording)
                .bind(one.robot)
                .bind(one.frame)
                .bind(one.pixel.x())
                .bind(one.pixel.y());
            ODO_TRY(insert.run());
        }
        return {};
    });
}

Result<std::vector<PointedOutRobot>> TrialRepository::pointedOut(RecordId trial) const
{
    std::vector<PointedOutRobot> robots;
    Statement select(
        m_connection,
        QStringLiteral(
            "SELECT robot_id, recording_id, frame, x_px, y_px FROM pointed_out_robot JOIN recording ON "
            "recording.id = recording_id WHERE trial_id=? ORDER BY recording_id, robot_id, frame"));
    auto read = select.bind(trial).eachRow([&](const Statement &row) -> Result<void> {
        robots.push_back({row.integer(0), row.integer(1), row.integer(2), {row.real(3), row.real(4)}});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return robots;
}

namespace {

Message trackSubject(const ImportedTrack &track)
{
    return ODO_TEXT("project.track", "track '%1'")(Named::file(track.file));
}

tl::unexpected<Error> refusedTrack(const ImportedTrack &track, Message why)
{
    return fail(ErrorCode::InvalidInput, trackSubject(track), std::move(why),
                ODO_TEXT("project.import_another_file", "import another file"));
}

/// before: the time of the sample before them.
Result<void> checkSamples(const ImportedTrack &track, const std::vector<Sample> &samples,
                          std::optional<Nanoseconds> before)
{
    for (const Sample &sample : samples) {
        if (before && sample.time <= *before)
            return refusedTrack(track, ODO_TEXT("project.times_do_not_rise", "its times do not increase"));
        before = sample.time;
        if ((sample.position && !sample.position->allFinite()) || !sample.covariance.allFinite() ||
            !sample.commonCovariance.allFinite())
            return refusedTrack(track, ODO_TEXT("project.position_no_number",
                                                "a position or its covariance is not a number"));
    }
    return {};
}

Result<void> addTrackChunks(ProjectConnection &connection, RecordId id, const ImportedTrack &track,
                            const SampleSource &samples)
{
    std::optional<Nanoseconds> before;
    for (std::size_t start = 0; start < samples.count; start += rowsPerChunk) {
        const auto chunk = ODO_TRY(samples.chunk(start, std::min(rowsPerChunk, samples.count - start)));
        ODO_TRY(checkSamples(track, chunk, before));
        before = chunk.back().time;
        Statement insert(connection, QStringLiteral("INSERT INTO imported_track_chunk VALUES (?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(start / rowsPerChunk));
        ODO_TRY(insert.bind(packSamples(chunk)).run());
    }
    return {};
}

} // namespace

Result<void> TrialRepository::addImportedTrack(const ImportedTrack &track, const SampleSource &samples)
{
    const SampleSource source = samples.chunk ? samples : sourceOf(track.samples);
    if (source.count == 0)
        return refusedTrack(track, ODO_TEXT("project.no_samples", "it has no samples"));
    if (source.count > maxBlobRows)
        return refusedTrack(track, hasTooManySamples());
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(checkName(RecordKind::Track, track.file));
        ODO_TRY(checkText(ODO_TEXT("project.track_reading", "reading of a track"), track.reading.english()));
        Statement insert(
            m_connection,
            QStringLiteral(
                "INSERT INTO imported_track (trial_id, robot_id, imported_ms, file, sha256, bytes, "
                "format, reading) VALUES (?,?,?,?,?,?,?,?)"));
        insert.bind(track.trial).bind(track.robot);
        insert.bind(static_cast<std::int64_t>(track.imported.time_since_epoch().count()))
            .bind(track.file)
            .bind(track.sha256);
        ODO_TRY(insert.bind(track.bytes).bind(track.format).bind(track.reading).run());
        return addTrackChunks(m_connection, insert.insertedId(), track, source);
    });
}

namespace {

/// Its id and all but the samples.
Result<std::optional<std::pair<RecordId, ImportedTrack>>> newestTrack(const ProjectConnection &connection,
                                                                      RecordId trial, RecordId robot)
{
    Statement select(
        connection,
        QStringLiteral("SELECT id, imported_ms, file, sha256, bytes, format, reading FROM imported_track "
                       "WHERE trial_id=? AND robot_id=? ORDER BY id DESC LIMIT 1"));
    const auto found = ODO_TRY(select.bind(trial).bind(robot).firstRow());
    if (!found)
        return std::nullopt;
    ImportedTrack track{trial,
                        robot,
                        Instant(std::chrono::milliseconds(select.integer(1))),
                        select.text(2),
                        select.text(3),
                        select.integer(4),
                        select.text(5),
                        select.message(6),
                        {}};
    return std::pair(select.integer(0), std::move(track));
}

} // namespace

Result<std::optional<ImportedTrack>> TrialRepository::currentImportedTrack(RecordId trial, RecordId robot,
                                                                           bool withSamples) const
{
    auto newest = ODO_TRY(newestTrack(m_connection, trial, robot));
    if (!newest)
        return std::nullopt;
    const RecordId id = newest->first;
    ImportedTrack &track = newest->second;
    NoiseLevel noise;
    std::size_t count = 0;
    Statement chunks(
        m_connection,
        QStringLiteral("SELECT samples FROM imported_track_chunk WHERE track_id=? ORDER BY position"));
    auto read = chunks.bind(id).eachRow([&](const Statement &row) -> Result<void> {
        std::vector<Sample> chunk;
        ODO_TRY(unpackSamples(row.blob(0), trackSubject(track), chunk));
        count += chunk.size();
        if (count > maxBlobRows)
            return refusedTrack(track, hasTooManySamples());
        noise.add(chunk);
        if (withSamples)
            track.samples.insert(track.samples.end(), chunk.begin(), chunk.end());
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    track.noiseM = noise.sigmaM();
    return std::optional(std::move(track));
}

Result<void> TrialRepository::setTruth(const TruthSeries &truth)
{
    const std::size_t count = truth.times.size();
    for (const auto *series : {&truth.positions, &truth.velocities, &truth.accelerations}) {
        if (series->size() != count)
            return fail(ErrorCode::InvalidInput, ODO_TEXT("project.truth", "truth of a trial"),
                        ODO_TEXT("project.series_differ", "its series differ in length"),
                        ODO_TEXT("project.give_whole_truth",
                                 "give position, velocity and acceleration for each time"));
    }
    return transact(m_connection, [&]() -> Result<void> {
        Statement remove(m_connection, QStringLiteral("DELETE FROM truth WHERE trial_id=? AND robot_id=?"));
        ODO_TRY(remove.bind(truth.trial).bind(truth.robot).run());
        Statement insert(m_connection, QStringLiteral("INSERT INTO truth VALUES (?,?,?)"));
        return insert.bind(truth.trial).bind(truth.robot).bind(packTruth(truth)).run();
    });
}

Result<std::optional<TruthSeries>> TrialRepository::truth(RecordId trial, RecordId robot) const
{
    Statement select(m_connection,
                     QStringLiteral("SELECT series FROM truth WHERE trial_id=? AND robot_id=?"));
    const auto found = ODO_TRY(select.bind(trial).bind(robot).firstRow());
    if (!found)
        return std::nullopt;
    TruthSeries truth;
    truth.trial = trial;
    truth.robot = robot;
    ODO_TRY(
        unpackTruth(select.blob(0), ODO_TEXT("project.truth_of_trial", "truth of trial %1")(trial), truth));
    return std::optional(std::move(truth));
}

Result<void> addAmbiguousNames(ProjectConnection &connection, RecordId analysis,
                               const std::vector<AmbiguousName> &ambiguities)
{
    for (std::size_t i = 0; i < ambiguities.size(); ++i) {
        const AmbiguousName &ambiguity = ambiguities[i];
        const auto position = static_cast<std::int64_t>(i);
        Statement insert(connection, QStringLiteral("INSERT INTO doubtful_name VALUES (?,?,?,?)"));
        insert.bind(analysis).bind(position).bind(static_cast<std::int64_t>(ambiguity.from.count()));
        ODO_TRY(insert.bind(static_cast<std::int64_t>(ambiguity.to.count())).run());
        for (const RecordId other : ambiguity.others) {
            Statement insertOther(connection,
                                  QStringLiteral("INSERT INTO doubtful_name_robot VALUES (?,?,?)"));
            ODO_TRY(insertOther.bind(analysis).bind(position).bind(other).run());
        }
    }
    return {};
}

Result<std::vector<AmbiguousName>> readAmbiguousNames(const ProjectConnection &connection, RecordId analysis)
{
    std::vector<AmbiguousName> ambiguities;
    std::optional<std::int64_t> last;
    Statement select(
        connection,
        QStringLiteral(
            "SELECT doubtful_name.position, from_ns, to_ns, robot_id, robot.name FROM doubtful_name "
            "LEFT JOIN doubtful_name_robot USING (analysis_id, position) "
            "LEFT JOIN robot ON robot.id=robot_id WHERE analysis_id=? "
            "ORDER BY doubtful_name.position, robot_id"));
    auto read = select.bind(analysis).eachRow([&](const Statement &row) -> Result<void> {
        if (last != row.integer(0)) {
            // so that times can be subtracted
            constexpr std::int64_t latest = std::numeric_limits<std::int64_t>::max() / 2;
            const Nanoseconds from(std::clamp<std::int64_t>(row.integer(1), 0, latest)),
                to(std::clamp<std::int64_t>(row.integer(2), 0, latest));
            ambiguities.push_back({std::min(from, to), std::max(from, to), {}, {}});
        }
        last = row.integer(0);
        if (row.integer(3) != 0) {
            ambiguities.back().others.push_back(row.integer(3));
            ambiguities.back().otherNames.push_back(row.name(4));
        }
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return ambiguities;
}

} // namespace odo
