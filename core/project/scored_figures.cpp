// SPDX-License-Identifier: GPL-3.0-or-later
// AnalysisRepository's part of scoring.
#include "core/project/connection.h"
#include "core/project/repositories.h"

#include <unordered_map>

namespace odo {

namespace {

/// hasCourse, of the table task.
const QString courseCondition = QStringLiteral(
    "(EXISTS (SELECT 1 FROM gate WHERE gate.task_id=task.id) OR EXISTS (SELECT 1 FROM zone WHERE zone.task_id=task.id) OR task.max_speed_m_s IS NOT NULL OR "
    "task.max_accel_m_s2 IS NOT NULL OR COALESCE(LENGTH(task.path_points), 0)>8)"); // 8 bytes: no points

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

Result<std::vector<ScoredFigures>> AnalysisRepository::scoredFigures(Instant from, Instant to) const
{
    std::vector<ScoredFigures> runs;
    std::unordered_map<RecordId, std::size_t> runOf; // by analysis
    Statement counts(
        m_connection,
        scoredAnalyses(
            QStringLiteral(
                "trial.id, analysis.robot_id, trial.task_id, "
                "CASE WHEN COALESCE(analysis.task_id, 0)=trial.task_id OR NOT %1 THEN 1 ELSE 0 END, "
                "(SELECT COUNT(*) FROM spike WHERE analysis_id=analysis.id), "
                "(SELECT COUNT(*) FROM spike WHERE analysis_id=analysis.id AND (flags & 6)<>0), "
                "(SELECT COUNT(DISTINCT gate) FROM gate_passage WHERE analysis_id=analysis.id)")
                .arg(courseCondition),
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
        return read ? Result<std::vector<ScoredFigures>>(runs) : tl::unexpected(read.error());
    Statement metrics(
        m_connection,
        scoredAnalyses(QStringLiteral("metric.name, unit, value, sigma"),
                       "JOIN metric ON metric.analysis_id=analysis.id AND metric.name IN "
                       "(SELECT scoring.metric FROM scoring WHERE scoring.task_id=trial.task_id)"));
    bindDates(metrics, from, to);
    read = metrics.eachRow([&](const Statement &row) -> Result<void> {
        if (const auto run = runOf.find(row.integer(0));
            run != runOf.end()) // not of one that came in between
            runs[run->second].metrics.push_back({row.name(1), row.name(2), row.real(3), row.optionalReal(4)});
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
            "SELECT DISTINCT trial.id, trial.name, task.name, binned_ms FROM trial JOIN task ON task.id=trial.task_id "
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
