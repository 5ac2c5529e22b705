// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/hub_results.h"

#include "core/analysis/metric_table.h"
#include "core/project/names.h"
#include "core/school/internal/hub_queries.h"
#include "core/school/internal/hub_thread.h"
#include "core/school/internal/standing_marks.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace odo {

namespace {

std::string shownOf(const QVariant &value)
{
    return shownName(value.toString());
}

/// unit, value, sigma and at_least, from a column on.
std::optional<Metric> metricOf(const QSqlQuery &row, int column, const std::string &name)
{
    if (row.isNull(column + 1))
        return std::nullopt;
    std::optional<double> sigma;
    if (!row.isNull(column + 2))
        sigma = row.value(column + 2).toDouble();
    return Metric{name, shownOf(row.value(column)), row.value(column + 1).toDouble(), sigma,
                  row.value(column + 3).toBool()};
}

/// The runs of a task as they come, in the form in which those of a project are ranked.
class RunRows
{
public:
    explicit RunRows(StandingsChoice choice) : m_choice(std::move(choice)) {}

    void add(const QSqlQuery &row)
    {
        const std::string uuid = row.value(0).toString().toStdString();
        const auto [trial, isNew] = m_ids.try_emplace(uuid, RecordId(m_ids.size()) + 1);
        if (isNew) {
            addTrial(trial->second, uuid, row);
            m_standings.push_back(row.value(5).toString().toStdString());
        }
        const auto metric = metricOf(row, 6, m_choice.metric);
        if (metric)
            m_metrics.push_back({trial->second, robotId(shownOf(row.value(1))), *metric});
    }

    HubStandings standings() const
    {
        HubStandings result;
        std::vector<const TrialRecord *> counted;
        std::set<RecordId> doubtful;
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            const std::string &standing = m_standings[i];
            result.reading.leftOut += standing == standingWord::otherwise ? 1 : 0;
            result.reading.bad += standing == standingWord::bad ? 1 : 0;
            if (standing == standingWord::otherwise || standing == standingWord::bad)
                continue;
            counted.push_back(&m_trials[i]);
            if (standing == standingWord::doubtful)
                doubtful.insert(m_trials[i].id);
        }
        result.reading.trials = int(m_trials.size());
        result.reading.standings = standingsOf(counted, m_metrics, m_choice, doubtful);
        result.robots = m_robots;
        return result;
    }

private:
    void addTrial(RecordId id, const std::string &uuid, const QSqlQuery &row)
    {
        TrialRecord trial;
        trial.id = id;
        trial.name = uuid;
        trial.teamName = shownOf(row.value(2));
        trial.className = shownOf(row.value(3));
        trial.task = m_choice.task;
        trial.date = Instant(std::chrono::milliseconds(row.value(4).toLongLong()));
        if (!trial.teamName.empty())
            trial.team = m_teams.try_emplace({trial.teamName, trial.className}, RecordId(m_teams.size()) + 1)
                             .first->second;
        m_trials.push_back(std::move(trial));
    }

    RecordId robotId(const std::string &robot)
    {
        const auto known = std::ranges::find(m_robots, robot);
        if (known != m_robots.end())
            return RecordId(known - m_robots.begin()) + 1;
        m_robots.push_back(robot);
        return RecordId(m_robots.size());
    }

    const StandingsChoice m_choice;
    std::map<std::string, RecordId> m_ids;
    std::map<std::pair<std::string, std::string>, RecordId> m_teams;
    std::vector<TrialRecord> m_trials;
    std::vector<std::string> m_standings; ///< of each trial
    std::vector<TrialMetric> m_metrics;
    std::vector<std::string> m_robots;
};

HubRun runOf(const QSqlQuery &row, const std::string &metric)
{
    HubRun run;
    run.trial = row.value(0).toString().toStdString();
    run.robot = row.value(1).toString().toStdString();
    run.name = shownOf(row.value(2));
    run.team = shownOf(row.value(3));
    run.className = shownOf(row.value(4));
    run.task = shownOf(row.value(5));
    run.held = Instant(std::chrono::milliseconds(row.value(6).toLongLong()));
    run.durationS = row.value(7).toDouble();
    run.standing = row.value(8).toString().toStdString();
    run.metric = metricOf(row, 9, metric);
    run.bench = row.value(13).toString().toStdString();
    return run;
}

Result<std::string> newestTask(SchoolHub &hub, const StandingsChoice &choice)
{
    auto rows = ODO_TRY(hub.run(hubQueries::newestTask(choice.className)));
    return rows.next() ? rows.value(0).toString().toStdString() : std::string();
}

Result<std::string> usualMetric(SchoolHub &hub, const StandingsChoice &choice)
{
    auto rows = ODO_TRY(hub.run(hubQueries::metricNames(choice)));
    std::set<std::string> names;
    while (rows.next())
        names.insert(rows.value(0).toString().toStdString());
    if (names.contains(scoreMetric))
        return std::string(scoreMetric);
    for (const MetricKind &kind : metricKinds())
        if (names.contains(std::string(kind.id)))
            return std::string(kind.id);
    return names.empty() ? std::string() : *names.begin();
}

Result<HubStandings> readStandings(SchoolHub &hub, StandingsChoice choice)
{
    if (choice.task.empty()) {
        auto task = ODO_TRY(newestTask(hub, choice));
        choice.task = std::move(task);
    }
    if (choice.metric.empty()) {
        auto metric = ODO_TRY(usualMetric(hub, choice));
        choice.metric = std::move(metric);
    }
    auto rows = ODO_TRY(hub.run(hubQueries::standings(choice)));
    RunRows runs(std::move(choice));
    while (rows.next())
        runs.add(rows);
    return runs.standings();
}

Result<std::vector<HubRun>> readRuns(SchoolHub &hub, const HubRunFilter &filter, bool withNames,
                                     const HubRun *after, int most)
{
    std::vector<HubRun> runs;
    for (const auto search : {hubQueries::TextSearch::InNewest, hubQueries::TextSearch::InAll}) {
        runs.clear();
        auto rows = ODO_TRY(hub.run(hubQueries::runs(filter, search, withNames, after, most)));
        while (rows.next())
            runs.push_back(runOf(rows, filter.metric));
        if (filter.search.empty() || int(runs.size()) == most)
            break;
    }
    return runs;
}

Result<std::optional<HubTrial>> readTrial(SchoolHub &hub, const std::string &trial)
{
    auto rows = ODO_TRY(hub.run(hubQueries::document(trial)));
    if (!rows.next())
        return std::nullopt;
    HubTrial found;
    found.document.kind = ODO_TRY(schoolKindOf(rows.value(0).toString().toStdString()));
    found.document.name = shownOf(rows.value(1));
    found.owner = rows.value(2).toString().toStdString();
    found.document.sha256 = rows.value(3).toString().toStdString();
    found.document.body = rows.value(4).toByteArray();
    return found;
}

} // namespace

HubResults::HubResults(std::unique_ptr<HubThread> hub, std::string role)
    : m_hub(std::move(hub)), m_role(std::move(role))
{
}

HubResults::~HubResults() = default;

template <class Work>
auto HubResults::ask(const Work &work, const JobControl &control)
{
    using Outcome = decltype(work(std::declval<SchoolHub &>()));
    return m_hub->call<Outcome>(
        [work, lost = m_hub->lostConnection()](std::unique_ptr<SchoolHub> &hub) {
            return hub ? work(*hub) : Outcome(tl::unexpected(lost)); // after a call that nobody waited for
        },
        control, [] {});
}

Result<std::unique_ptr<HubResults>> HubResults::connect(const HubAddress &address, const JobControl &control)
{
    auto thread = std::make_unique<HubThread>(address);
    const auto open = [address](std::unique_ptr<SchoolHub> &hub) -> Result<std::string> {
        auto ready = ODO_TRY(connectReady(address));
        ODO_TRY(ready.hub->run({QStringLiteral("SET default_transaction_read_only = on")}));
        ODO_TRY(ready.hub->run({QStringLiteral("SET statement_timeout = '15s'")}));
        hub = std::move(ready.hub);
        return std::move(ready.role);
    };
    auto role = ODO_TRY(thread->call<Result<std::string>>(open, control, [] {}));
    return std::unique_ptr<HubResults>(new HubResults(std::move(thread), std::move(role)));
}

Result<std::int64_t> HubResults::state()
{
    return ask([](SchoolHub &hub) -> Result<std::int64_t> {
        auto rows = ODO_TRY(hub.run(hubQueries::resultState()));
        return rows.next() ? rows.value(0).toLongLong() : 0;
    });
}

Result<HubStandings> HubResults::standings(StandingsChoice choice)
{
    return ask([choice = std::move(choice)](SchoolHub &hub) { return readStandings(hub, choice); });
}

Result<std::vector<HubRun>> HubResults::runs(const HubRunFilter &filter, int most, const HubRun *after,
                                             const JobControl &control)
{
    const auto last = after ? std::optional(*after) : std::nullopt;
    return ask(
        [filter, most, last, withNames = mayReadTrials()](SchoolHub &hub) {
            return readRuns(hub, filter, withNames, last ? &*last : nullptr, most);
        },
        control);
}

Result<std::vector<std::string>> HubResults::benches(const JobControl &control)
{
    if (!mayReadTrials())
        return std::vector<std::string>();
    return ask(
        [](SchoolHub &hub) -> Result<std::vector<std::string>> {
            auto rows = ODO_TRY(hub.run(hubQueries::benches()));
            std::vector<std::string> all;
            while (rows.next())
                all.push_back(rows.value(0).toString().toStdString());
            return all;
        },
        control);
}

Result<std::int64_t> HubResults::revisionOf(const std::string &trial)
{
    return ask([trial](SchoolHub &hub) -> Result<std::int64_t> {
        auto rows = ODO_TRY(hub.run(hubQueries::revision(trial)));
        return rows.next() ? rows.value(0).toLongLong() : 0;
    });
}

Result<std::optional<HubTrial>> HubResults::trial(const std::string &trial)
{
    return ask([trial](SchoolHub &hub) { return readTrial(hub, trial); });
}

} // namespace odo
