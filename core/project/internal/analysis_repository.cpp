// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"
#include "core/analysis/motion_stretches.h"
#include "core/analysis/task.h"
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/analysis_range.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/series_rows.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <unordered_map>
#include <utility>

namespace odo {

namespace {

const QString newestColumns = QStringLiteral(
    "SELECT analysis.id, trial_id, robot_id, robot.name, made_ms, software_version, smoother, "
    "max_speed_m_s, max_accel_m_s2, longest_bridged_gap_ns, analysis.height_m, height_estimated, "
    "mean_view_disagreement_m, task_id, range_from_ns, range_to_ns FROM analysis JOIN robot ON "
    "robot.id=robot_id WHERE analysis.id IN "
    "(SELECT MAX(id) FROM analysis WHERE trial_id=? GROUP BY robot_id) ORDER BY robot_id");

Message analyseAgain()
{
    return ODO_TEXT("project.analyse_again", "reanalyse the trial");
}

Message lengthsDiffer()
{
    return ODO_TEXT("project.lengths_differ", "samples and profile differ in length");
}

Result<void> checkAnalysis(const AnalysisRecord &analysis, std::size_t samples)
{
    const auto refuse = [](Message why) {
        return fail(ErrorCode::InvalidInput, ODO_TEXT("project.an_analysis", "analysis of a trial"),
                    std::move(why), analyseAgain());
    };
    const Profile &profile = analysis.profile;
    if (samples != profile.points.size())
        return refuse(lengthsDiffer());
    if (samples > maxBlobRows)
        return refuse(hasTooManySamples());
    if (!analysis.registrations.empty() && analysis.registrations.size() != analysis.views.size())
        return refuse(ODO_TEXT("project.views_differ", "views and registrations differ in number"));
    return {};
}

Result<RecordId> addRow(ProjectConnection &connection, const AnalysisRecord &analysis)
{
    Statement insert(
        connection,
        QStringLiteral("INSERT INTO analysis (trial_id, robot_id, made_ms, software_version, smoother, "
                       "max_speed_m_s, max_accel_m_s2, longest_bridged_gap_ns, height_m, "
                       "height_estimated, mean_view_disagreement_m, task_id, range_from_ns, range_to_ns) "
                       "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
    const AnalysisOptions &options = analysis.options;
    insert.bind(analysis.trial).bind(analysis.robot);
    insert.bind(static_cast<std::int64_t>(analysis.made.time_since_epoch().count()))
        .bind(analysis.softwareVersion);
    insert.bind(storedWord(smootherWords, options.smoother))
        .bind(options.maxSpeedMps)
        .bind(options.maxAccelMps2);
    insert.bind(static_cast<std::int64_t>(options.longestBridgedGap.count())).bind(analysis.profile.heightM);
    insert.bind(analysis.profile.heightEstimated ? 1 : 0).bind(analysis.profile.meanViewDisagreementM);
    insert.bindReference(analysis.task).bind(analysis.range);
    ODO_TRY(insert.run());
    return insert.insertedId();
}

Result<void> addViews(ProjectConnection &connection, RecordId id, const AnalysisRecord &analysis)
{
    for (std::size_t i = 0; i < analysis.views.size(); ++i) {
        Statement insert(connection, QStringLiteral("INSERT INTO analysis_view VALUES (?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(analysis.views[i]);
        insert.bindReference(analysis.registrations.empty() ? 0 : analysis.registrations[i]);
        ODO_TRY(insert.run());
    }
    return {};
}

Result<void> addOverrides(ProjectConnection &connection, RecordId id,
                          const std::vector<ManualOverride> &overrides)
{
    for (const ManualOverride &manualOverride : overrides) {
        Statement insert(connection, QStringLiteral("INSERT INTO analysis_overrule VALUES (?,?,?)"));
        ODO_TRY(insert.bind(id).bind(manualOverride.frame).bind(manualOverride.isSpike ? 1 : 0).run());
    }
    return {};
}

Result<void> addMetrics(ProjectConnection &connection, RecordId id, const Profile &profile)
{
    for (std::size_t i = 0; i < profile.metrics.size(); ++i) {
        const Metric &metric = profile.metrics[i];
        if (!std::isfinite(metric.value) || (metric.sigma && !std::isfinite(*metric.sigma)))
            return fail(ErrorCode::InvalidInput, ODO_TEXT("project.metric", "metric '%1'")(metric.name),
                        ODO_TEXT("project.not_finite", "it is not a finite number"), analyseAgain());
        Statement insert(connection, QStringLiteral("INSERT INTO metric VALUES (?,?,?,?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(metric.name).bind(metric.unit);
        ODO_TRY(insert.bind(metric.value).bind(metric.sigma).bind(metric.isAtLeast ? 1 : 0).run());
    }
    return {};
}

Result<void> addSpikes(ProjectConnection &connection, RecordId id, const std::vector<Spike> &spikes)
{
    for (std::size_t i = 0; i < spikes.size(); ++i) {
        const Spike &spike = spikes[i];
        Statement insert(connection, QStringLiteral("INSERT INTO spike VALUES (?,?,?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(spike.sampleIndex);
        insert.bind(static_cast<std::int64_t>(spike.time.count()))
            .bind(static_cast<std::int64_t>(spike.flags));
        ODO_TRY(insert.bind(spike.reason).run());
    }
    return {};
}

Result<void> addPassages(ProjectConnection &connection, RecordId id, const std::vector<GatePassage> &passages)
{
    for (std::size_t i = 0; i < passages.size(); ++i) {
        const GatePassage &passage = passages[i];
        Statement insert(connection, QStringLiteral("INSERT INTO gate_passage VALUES (?,?,?,?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(passage.gate);
        insert.bind(storedWord(gateRoleWords, passage.role));
        insert.bind(static_cast<std::int64_t>(passage.time.count())).bind(passage.sigmaS);
        ODO_TRY(insert.bind(passage.commonSigmaS).run());
    }
    return {};
}

Result<void> addSeries(ProjectConnection &connection, RecordId id, const Profile &profile,
                       const SampleSource &samples)
{
    const std::span<const ProfilePoint> points(profile.points);
    for (std::size_t start = 0; start == 0 || start < points.size(); start += rowsPerChunk) {
        const std::size_t count = std::min(rowsPerChunk, points.size() - start);
        const auto chunk = ODO_TRY(samples.chunk(start, count));
        Statement insert(connection, QStringLiteral("INSERT INTO analysis_chunk VALUES (?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(start / rowsPerChunk));
        ODO_TRY(insert.bind(packSamples(chunk)).bind(packPoints(points.subspan(start, count))).run());
    }
    return {};
}

/// The series and spikes of the whole run.
Result<void> addRun(ProjectConnection &connection, RecordId id, const AnalysisRecord &analysis,
                    const SampleSource &samples)
{
    if (!analysis.range) {
        ODO_TRY(addSpikes(connection, id, analysis.profile.spikes));
        return addSeries(connection, id, analysis.profile, samples);
    }
    const Profile whole = wholeRun(analysis.profile, analysis.outside);
    ODO_TRY(addSpikes(connection, id, whole.spikes));
    return addSeries(connection, id, whole, sourceOf(whole.samples));
}

Result<AnalysisRecord> analysisOf(const Statement &row)
{
    AnalysisRecord analysis;
    analysis.id = row.integer(0);
    analysis.trial = row.integer(1);
    analysis.robot = row.integer(2);
    analysis.robotName = row.name(3);
    analysis.made = Instant(std::chrono::milliseconds(row.integer(4)));
    analysis.softwareVersion = row.name(5);
    const auto smoother = ODO_TRY(fromStoredWord(
        smootherWords, row.text(6), ODO_TEXT("project.analysis_number", "analysis %1")(analysis.id)));
    analysis.options.smoother = smoother;
    analysis.options.maxSpeedMps = row.real(7);
    analysis.options.maxAccelMps2 = row.real(8);
    analysis.options.longestBridgedGap = Nanoseconds(row.integer(9));
    analysis.profile.heightM = row.real(10);
    analysis.profile.heightEstimated = row.integer(11) != 0;
    analysis.profile.meanViewDisagreementM = row.real(12);
    analysis.task = row.integer(13);
    analysis.range = row.span(14);
    return analysis;
}

Result<void> readMetrics(const ProjectConnection &connection, AnalysisRecord &into)
{
    Statement select(
        connection,
        QStringLiteral(
            "SELECT name, unit, value, sigma, at_least FROM metric WHERE analysis_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.profile.metrics.push_back(
            {row.name(0), row.name(1), row.real(2), row.optionalReal(3), row.integer(4) != 0});
        return {};
    });
}

Result<void> readPassages(const ProjectConnection &connection, AnalysisRecord &into)
{
    Statement select(connection,
                     QStringLiteral("SELECT gate, role, time_ns, sigma_s, common_sigma_s FROM gate_passage "
                                    "WHERE analysis_id=? ORDER BY position"));
    return select.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        const auto role = ODO_TRY(fromStoredWord(gateRoleWords, row.text(1), gateSubject(row.name(0))));
        into.profile.passages.push_back(
            {row.name(0), role, Nanoseconds(row.integer(2)), row.real(3), row.real(4)});
        return {};
    });
}

Result<void> readDecisions(const ProjectConnection &connection, AnalysisRecord &into)
{
    Statement views(connection, QStringLiteral("SELECT name, registration_id FROM analysis_view "
                                               "WHERE analysis_id=? ORDER BY position"));
    auto read = views.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.views.push_back(row.name(0));
        into.registrations.push_back(row.integer(1));
        return {};
    });
    if (!read)
        return read;
    Statement overrides(connection, QStringLiteral("SELECT frame, is_spike FROM analysis_overrule "
                                                   "WHERE analysis_id=? ORDER BY frame"));
    read = overrides.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.options.overrides.push_back({row.integer(0), row.integer(1) != 0});
        return {};
    });
    if (!read)
        return read;
    Statement spikes(connection, QStringLiteral("SELECT sample_index, time_ns, flags, reason FROM spike "
                                                "WHERE analysis_id=? ORDER BY position"));
    return spikes.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.profile.spikes.push_back({row.integer(0), Nanoseconds(row.integer(1)),
                                       static_cast<SampleFlags>(row.integer(2)), row.message(3)});
        return {};
    });
}

Result<void> readSeries(const ProjectConnection &connection, AnalysisRecord &into)
{
    const Message what = ODO_TEXT("project.analysis_of_project", "analysis %1 of the project")(into.id);
    const auto damaged = [&what](Message why) {
        return fail(ErrorCode::InvalidInput, what, std::move(why), analyseAgain());
    };
    std::vector<Sample> samples;
    std::vector<ProfilePoint> points;
    Statement length(connection, QStringLiteral("SELECT COUNT(*) FROM analysis_chunk WHERE analysis_id=?"));
    ODO_TRY(length.bind(into.id).firstRow());
    if (length.integer(0) == 0)
        return damaged(ODO_TEXT("project.series_missing", "its series are missing"));
    const auto most = std::min<std::int64_t>(length.integer(0) * rowsPerChunk, maxBlobRows);
    samples.reserve(static_cast<std::size_t>(most));
    points.reserve(static_cast<std::size_t>(most));
    Statement select(
        connection,
        QStringLiteral("SELECT samples, points FROM analysis_chunk WHERE analysis_id=? ORDER BY position"));
    auto read = select.bind(into.id).eachRow([&](const Statement &row) -> Result<void> {
        ODO_TRY(unpackSamples(row.blob(0), what, samples));
        ODO_TRY(unpackPoints(row.blob(1), what, points));
        if (samples.size() != points.size())
            return damaged(lengthsDiffer());
        return samples.size() > maxBlobRows ? damaged(hasTooManySamples()) : Result<void>();
    });
    if (!read)
        return read;
    const auto count = static_cast<std::int64_t>(samples.size());
    for (const Spike &spike : into.profile.spikes) {
        if (spike.sampleIndex < 0 || spike.sampleIndex >= count)
            return damaged(ODO_TEXT("project.spike_without_sample", "a spike refers to a missing sample"));
    }
    into.profile.samples = std::move(samples);
    into.profile.points = std::move(points);
    if (into.range)
        into.outside = cutToRange(into.profile, *into.range);
    if (into.range && into.profile.samples.empty())
        return damaged(ODO_TEXT("project.range_without_sample", "no sample is within its range"));
    if (!into.range)
        measureGaps(validInstants(into.profile.samples, into.profile.points), into.profile);
    markLowerBounds(into.profile.metrics, into.profile.gaps);
    return {};
}

} // namespace

AnalysisRepository::AnalysisRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<AnalysisRecord> AnalysisRepository::add(AnalysisRecord analysis, const SampleSource &samples)
{
    return transact(m_connection, [&]() -> Result<AnalysisRecord> {
        const SampleSource source = samples.chunk ? samples : sourceOf(analysis.profile.samples);
        ODO_TRY(checkAnalysis(analysis, source.count));
        const auto id = ODO_TRY(addRow(m_connection, analysis));
        ODO_TRY(addViews(m_connection, id, analysis));
        ODO_TRY(addOverrides(m_connection, id, analysis.options.overrides));
        ODO_TRY(addMetrics(m_connection, id, analysis.profile));
        ODO_TRY(addPassages(m_connection, id, analysis.profile.passages));
        ODO_TRY(addAmbiguousNames(m_connection, id,
                                  analysis.range ? analysis.allAmbiguousNames : analysis.ambiguousNames));
        ODO_TRY(addRun(m_connection, id, analysis, source));
        ODO_TRY(writeDigests(m_connection, id));
        analysis.id = id;
        analysis.proof = AnalysisRecord::Proof::Holds;
        return std::move(analysis);
    });
}

Result<std::vector<AnalysisRecord>> AnalysisRepository::current(RecordId trial) const
{
    auto analyses = ODO_TRY(currentMetrics(trial));
    AnalysisDigests digests(m_connection);
    for (AnalysisRecord &analysis : analyses) {
        const auto compared = ODO_TRY(digests.compare(analysis.id, shownDigestParts));
        if (compared.isKept)
            analysis.proof =
                compared.changed.empty() ? AnalysisRecord::Proof::Holds : AnalysisRecord::Proof::Broken;
        ODO_TRY(readDecisions(m_connection, analysis));
        ODO_TRY(readSeries(m_connection, analysis));
        analysis.ambiguousNames = ODO_TRY(ambiguousNames(analysis.id));
        if (analysis.range)
            analysis.allAmbiguousNames = analysis.ambiguousNames;
        if (analysis.range)
            keepWithin(*analysis.range, analysis.ambiguousNames);
    }
    return analyses;
}

Result<std::vector<AmbiguousName>> AnalysisRepository::ambiguousNames(RecordId analysis) const
{
    return readAmbiguousNames(m_connection, analysis);
}

Result<std::map<RecordId, std::vector<std::string>>> AnalysisRepository::trialsByRegistration() const
{
    std::map<RecordId, std::vector<std::string>> trials;
    Statement select(
        m_connection,
        QStringLiteral("SELECT DISTINCT registration_id, trial.name FROM analysis_view "
                       "JOIN analysis ON analysis.id=analysis_id JOIN trial ON trial.id=trial_id "
                       "WHERE registration_id IS NOT NULL AND analysis.id IN "
                       "(SELECT MAX(id) FROM analysis GROUP BY trial_id, robot_id) ORDER BY trial.name"));
    auto read = select.eachRow([&trials](const Statement &row) -> Result<void> {
        trials[row.integer(0)].push_back(row.name(1));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return trials;
}

Result<std::vector<TrialMetric>> AnalysisRepository::trialMetrics(const std::string &metric, Instant from,
                                                                  Instant to) const
{
    std::vector<TrialMetric> trialMetrics;
    Statement select(
        m_connection,
        QStringLiteral("SELECT trial.id, robot_id, unit, value, sigma, at_least FROM trial "
                       "JOIN analysis ON analysis.trial_id=trial.id JOIN metric ON analysis_id=analysis.id "
                       "WHERE date_ms>=? AND date_ms<=? AND metric.name=? AND analysis.id="
                       "(SELECT MAX(newer.id) FROM analysis AS newer WHERE newer.trial_id=trial.id "
                       "AND newer.robot_id=analysis.robot_id) ORDER BY date_ms, trial.id, robot_id"));
    select.bind(static_cast<std::int64_t>(from.time_since_epoch().count()));
    select.bind(static_cast<std::int64_t>(to.time_since_epoch().count()));
    auto read = select.bind(metric).eachRow([&](const Statement &row) -> Result<void> {
        trialMetrics.push_back(
            {row.integer(0),
             row.integer(1),
             {metric, row.name(2), row.real(3), row.optionalReal(4), row.integer(5) != 0}});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return trialMetrics;
}

Result<std::int64_t> AnalysisRepository::countWithoutDigest() const
{
    return m_connection.number(QStringLiteral(
        "SELECT COUNT(*) FROM (SELECT MAX(id) AS newest FROM analysis GROUP BY trial_id, robot_id) "
        "WHERE NOT EXISTS (SELECT 1 FROM analysis_digest WHERE analysis_id=newest)"));
}

Result<std::vector<std::string>> AnalysisRepository::metricNames() const
{
    return textsOf(m_connection, QStringLiteral("SELECT DISTINCT name FROM metric ORDER BY name"));
}

Result<std::vector<AnalysisRecord>> AnalysisRepository::currentMetrics(RecordId trial) const
{
    std::vector<AnalysisRecord> analyses;
    Statement select(m_connection, newestColumns);
    auto read = select.bind(trial).eachRow([&](const Statement &row) -> Result<void> {
        auto analysis = ODO_TRY(analysisOf(row));
        ODO_TRY(readMetrics(m_connection, analysis));
        ODO_TRY(readPassages(m_connection, analysis));
        analyses.push_back(std::move(analysis));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return analyses;
}

// AnalysisRepository's part of scoring.

namespace {

/// hasCourse, of the table task.
const QString courseCondition = QStringLiteral(
    "(EXISTS (SELECT 1 FROM gate WHERE gate.task_id=task.id) OR EXISTS (SELECT 1 FROM zone WHERE "
    "zone.task_id=task.id) OR task.max_speed_m_s IS NOT NULL OR "
    "task.max_accel_m_s2 IS NOT NULL OR COALESCE(LENGTH(task.path_points), 0)>8)"); // 8 bytes: no points

/// Of a spike, that it is within the range of its analysis.
const QString spikeInRange = QStringLiteral(
    "(analysis.range_from_ns IS NULL OR time_ns BETWEEN analysis.range_from_ns AND analysis.range_to_ns)");

/// Newest analyses of the trials of scored tasks, between two dates that are its first parameters.
QString scoredAnalyses(const QString &columns, const char *joined)
{
    return QStringLiteral("SELECT analysis.id, %1 FROM trial JOIN analysis ON analysis.trial_id=trial.id "
                          "JOIN task ON task.id=trial.task_id %2 "
                          "WHERE date_ms>=? AND date_ms<=? AND trial.task_id IN (SELECT task_id FROM "
                          "scoring) AND analysis.id="
                          "(SELECT MAX(newer.id) FROM analysis AS newer WHERE newer.trial_id=trial.id AND "
                          "newer.robot_id=analysis.robot_id) ORDER BY analysis.id")
        .arg(columns, QLatin1String(joined));
}

void bindDates(Statement &statement, Instant from, Instant to)
{
    statement.bind(static_cast<std::int64_t>(from.time_since_epoch().count()));
    statement.bind(static_cast<std::int64_t>(to.time_since_epoch().count()));
}

} // namespace

Result<std::vector<ScoredMetrics>> AnalysisRepository::scoredMetrics(Instant from, Instant to) const
{
    std::vector<ScoredMetrics> runs;
    std::unordered_map<RecordId, std::size_t> runOf; // by analysis
    Statement counts(
        m_connection,
        scoredAnalyses(
            QStringLiteral(
                "trial.id, analysis.robot_id, trial.task_id, "
                "CASE WHEN COALESCE(analysis.task_id, 0)=trial.task_id OR NOT %1 THEN 1 ELSE 0 END, "
                "(SELECT COUNT(*) FROM spike WHERE analysis_id=analysis.id AND %2), "
                "(SELECT COUNT(*) FROM spike WHERE analysis_id=analysis.id AND (flags & 6)<>0 AND %2), "
                "(SELECT COUNT(DISTINCT gate) FROM gate_passage WHERE analysis_id=analysis.id)")
                .arg(courseCondition, spikeInRange),
            ""));
    static_assert((flagBit(SampleFlag::SpeedLimit) | flagBit(SampleFlag::AccelerationLimit)) == 6);
    bindDates(counts, from, to);
    auto read = counts.eachRow([&](const Statement &row) -> Result<void> {
        runOf.emplace(row.integer(0), runs.size());
        runs.push_back({row.integer(1),
                        row.integer(2),
                        row.integer(3),
                        row.integer(4) != 0,
                        {{"spikes", "1", row.real(5), {}},
                         {"limit_breaches", "1", row.real(6), {}},
                         {"gates_passed", "1", row.real(7), {}}}});
        return {};
    });
    if (!read || runs.empty())
        return read ? Result<std::vector<ScoredMetrics>>(runs) : tl::unexpected(read.error());
    Statement metrics(
        m_connection,
        scoredAnalyses(QStringLiteral("metric.name, unit, value, sigma, at_least"),
                       "JOIN metric ON metric.analysis_id=analysis.id AND metric.name IN "
                       "(SELECT scoring.metric FROM scoring WHERE scoring.task_id=trial.task_id)"));
    bindDates(metrics, from, to);
    read = metrics.eachRow([&](const Statement &row) -> Result<void> {
        if (const auto run = runOf.find(row.integer(0));
            run != runOf.end()) // not of one that came in between
            runs[run->second].metrics.push_back(
                {row.name(1), row.name(2), row.real(3), row.optionalReal(4), row.integer(5) != 0});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return runs;
}

Result<std::vector<OtherwiseMeasured>> AnalysisRepository::trialsMeasuredOtherwise() const
{
    std::vector<OtherwiseMeasured> trials;
    Statement select(
        m_connection,
        QStringLiteral(
            "SELECT DISTINCT trial.id, trial.name, task.name, binned_ms FROM trial JOIN task ON "
            "task.id=trial.task_id "
            "JOIN analysis ON analysis.trial_id=trial.id WHERE COALESCE(analysis.task_id, 0)<>trial.task_id "
            "AND %1 AND analysis.id=(SELECT MAX(newer.id) FROM analysis AS newer WHERE "
            "newer.trial_id=trial.id AND newer.robot_id=analysis.robot_id) ORDER BY trial.id")
            .arg(courseCondition));
    auto read = select.eachRow([&trials](const Statement &row) -> Result<void> {
        trials.push_back({row.integer(0), row.name(1), row.name(2), row.optionalReal(3).has_value()});
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return trials;
}

} // namespace odo
