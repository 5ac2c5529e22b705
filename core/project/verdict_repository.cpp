// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/verdict_repository.h"

#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"

#include <algorithm>

namespace odo {

namespace {

constexpr StoredWords<CheckLevel, 3> checkLevelWords{
    {{CheckLevel::Pass, "pass"}, {CheckLevel::Doubtful, "doubtful"}, {CheckLevel::Bad, "bad"}}};

} // namespace

std::string wordOf(CheckLevel level)
{
    return storedWord(checkLevelWords, level);
}

CheckLevel TrialVerdict::level() const
{
    const auto worst = std::ranges::max_element(checks, {}, &TrialCheck::level);
    return worst == checks.end() ? CheckLevel::Pass : worst->level;
}

bool TrialVerdict::isAccepted() const
{
    return acceptance && level() == CheckLevel::Doubtful &&
           std::ranges::all_of(checks, [this](const TrialCheck &check) {
               return check.level == CheckLevel::Pass ||
                      std::ranges::binary_search(acceptance->checks, check.code);
           });
}

namespace {

/// What verdicts follow from, of the table trial: the version of the checks, to be raised whenever they
/// change, the newest analysis of each robot, how the views are synchronised, and the latest check of the
/// position of a camera that was used.
const QString basisColumn = QStringLiteral(
    "('2|' || COALESCE((SELECT group_concat(newest.id || robot.name) FROM "
    "(SELECT MAX(id) AS id, robot_id FROM analysis WHERE trial_id=trial.id GROUP BY robot_id) AS newest "
    "JOIN robot ON robot.id=newest.robot_id), '') || '|' || "
    "COALESCE((SELECT group_concat(sync_method || start_offset_s || '±' || start_offset_sigma_s || '*' || "
    "clock_rate) FROM recording WHERE trial_id=trial.id), '') || '|' || "
    "COALESCE((SELECT group_concat(DISTINCT latest.id) FROM analysis "
    "JOIN analysis_view ON analysis_id=analysis.id "
    "JOIN registration_check AS latest ON latest.registration_id=analysis_view.registration_id "
    "WHERE analysis.trial_id=trial.id AND latest.outcome='camera' AND latest.id="
    "(SELECT MAX(id) FROM registration_check WHERE registration_id=latest.registration_id)), ''))");

/// As the first parameters of a statement.
void bindDates(Statement &statement, Instant from, Instant to)
{
    statement.bind(static_cast<std::int64_t>(from.time_since_epoch().count()));
    statement.bind(static_cast<std::int64_t>(to.time_since_epoch().count()));
}

Result<void> runWith(ProjectConnection &connection, const char *sql, RecordId id)
{
    return Statement(connection, QString::fromLatin1(sql)).bind(id).run();
}

Message reasonOfAcceptance()
{
    return ODO_TEXT("project.acceptance_reason", "reason for accepting the results");
}

} // namespace

std::string wordOf(const TrialVerdict &verdict)
{
    return verdict.isAccepted() ? "doubtful, accepted" : wordOf(verdict.level());
}

VerdictRepository::VerdictRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<std::string> VerdictRepository::basis(RecordId trial) const
{
    Statement select(m_connection, QStringLiteral("SELECT %1 FROM trial WHERE id=?").arg(basisColumn));
    const auto found = ODO_TRY(select.bind(trial).firstRow());
    return found ? select.text(0) : std::string();
}

Result<void> VerdictRepository::set(const StoredVerdict &stored)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(runWith(m_connection, "DELETE FROM verdict_check WHERE trial_id=?", stored.trial));
        ODO_TRY(runWith(m_connection, "DELETE FROM verdict WHERE trial_id=?", stored.trial));
        Statement insert(m_connection, QStringLiteral("INSERT INTO verdict VALUES (?,?)"));
        ODO_TRY(insert.bind(stored.trial).bind(stored.basis).run());
        for (std::size_t i = 0; i < stored.verdict.checks.size(); ++i) {
            const TrialCheck &check = stored.verdict.checks[i];
            Statement row(m_connection, QStringLiteral("INSERT INTO verdict_check VALUES (?,?,?,?,?)"));
            row.bind(stored.trial).bind(static_cast<std::int64_t>(i)).bind(check.code);
            ODO_TRY(row.bind(wordOf(check.level)).bind(check.text).run());
        }
        for (const auto &[analysis, metrics] : stored.lowerBounds) {
            ODO_TRY(runWith(m_connection, "UPDATE metric SET at_least=0 WHERE analysis_id=?", analysis));
            for (const std::string &metric : metrics) {
                Statement mark(m_connection,
                               QStringLiteral("UPDATE metric SET at_least=1 WHERE analysis_id=? AND name=?"));
                ODO_TRY(mark.bind(analysis).bind(metric).run());
            }
        }
        return {};
    });
}

Result<std::map<RecordId, TrialVerdict>> VerdictRepository::all(Instant from, Instant to) const
{
    std::map<RecordId, TrialVerdict> verdicts;
    Statement select(
        m_connection,
        QStringLiteral("SELECT trial.id, code, level, words FROM trial "
                       "JOIN verdict ON verdict.trial_id=trial.id LEFT JOIN verdict_check ON "
                       "verdict_check.trial_id=trial.id AND level<>'pass' "
                       "WHERE date_ms>=? AND date_ms<=? AND verdict.basis=%1 ORDER BY trial.id, position")
            .arg(basisColumn));
    bindDates(select, from, to);
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        TrialVerdict &verdict = verdicts[row.integer(0)];
        if (const std::string code = row.name(1); !code.empty()) {
            const auto level = ODO_TRY(fromStoredWord(checkLevelWords, row.text(2),
                                                      ODO_TEXT("project.verdict", "verdict on a trial")));
            verdict.checks.push_back({code, level, row.message(3)});
        }
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    ODO_TRY(readAcceptances(verdicts));
    return verdicts;
}

/// Few are accepted: all of them are read.
Result<void> VerdictRepository::readAcceptances(std::map<RecordId, TrialVerdict> &verdicts) const
{
    Statement select(m_connection,
                     QStringLiteral("SELECT trial_id, accepted_ms, reason, code FROM accepted_verdict "
                                    "LEFT JOIN accepted_check USING (trial_id) ORDER BY trial_id, code"));
    return select.eachRow([&](const Statement &row) -> Result<void> {
        const auto verdict = verdicts.find(row.integer(0));
        if (verdict == verdicts.end())
            return {};
        auto &acceptance = verdict->second.acceptance;
        if (!acceptance)
            acceptance = {row.text(2), Instant(std::chrono::milliseconds(row.integer(1))), {}};
        acceptance->checks.push_back(row.name(3));
        return {};
    });
}

Result<std::vector<RecordId>> VerdictRepository::missing(Instant from, Instant to) const
{
    std::vector<RecordId> trials;
    Statement select(
        m_connection,
        QStringLiteral("SELECT trial.id FROM trial LEFT JOIN verdict ON verdict.trial_id=trial.id "
                       "WHERE date_ms>=? AND date_ms<=? AND verdict.basis IS NOT %1 AND EXISTS "
                       "(SELECT 1 FROM analysis WHERE analysis.trial_id=trial.id) "
                       "ORDER BY date_ms DESC, trial.id DESC")
            .arg(basisColumn));
    bindDates(select, from, to);
    auto read = select.eachRow([&trials](const Statement &row) -> Result<void> {
        trials.push_back(row.integer(0));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return trials;
}

Result<std::optional<VerdictAcceptance>> VerdictRepository::acceptance(RecordId trial) const
{
    std::map<RecordId, TrialVerdict> verdicts{{trial, {}}};
    ODO_TRY(readAcceptances(verdicts));
    return verdicts[trial].acceptance;
}

Result<void> VerdictRepository::setAcceptance(RecordId trial,
                                              const std::optional<VerdictAcceptance> &acceptance)
{
    return transact(m_connection, [&]() -> Result<void> {
        ODO_TRY(runWith(m_connection, "DELETE FROM accepted_check WHERE trial_id=?", trial));
        ODO_TRY(runWith(m_connection, "DELETE FROM accepted_verdict WHERE trial_id=?", trial));
        if (!acceptance)
            return {};
        const std::string reason = normalName(acceptance->reason);
        if (reason.empty())
            return fail(ErrorCode::InvalidInput, reasonOfAcceptance(),
                        ODO_TEXT("project.reason_is_blank", "it is blank"),
                        ODO_TEXT("project.say_why", "write why the results can be used"));
        ODO_TRY(checkText(reasonOfAcceptance(), reason));
        Statement insert(m_connection, QStringLiteral("INSERT INTO accepted_verdict VALUES (?,?,?)"));
        insert.bind(trial).bind(static_cast<std::int64_t>(acceptance->made.time_since_epoch().count()));
        ODO_TRY(insert.bind(reason).run());
        for (const std::string &code : acceptance->checks) {
            Statement check(m_connection,
                            QStringLiteral("INSERT OR IGNORE INTO accepted_check VALUES (?,?)"));
            ODO_TRY(check.bind(trial).bind(code).run());
        }
        return {};
    });
}

} // namespace odo
