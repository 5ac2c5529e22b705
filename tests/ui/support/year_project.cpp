// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/year_project.h"

#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"
#include "tests/ui/support/stored_example.h"

#include <QStringList>
#include <map>

namespace odo::test {

namespace {

constexpr int teamCount = 24, classCount = 4, taskCount = 6;
const char *const tags[] = {"wet floor", "new wheels", "final"};

/// Columns that a copy has otherwise, as SQL.
using Overrides = std::map<QString, QString>;

/// Copies the rows of a table for which a condition holds.
class RowCopier
{
public:
    explicit RowCopier(ProjectConnection &connection) : m_connection(connection) {}

    Result<void> copy(const QString &table, const QString &condition, const Overrides &overrides)
    {
        QStringList values;
        const auto columns = columnsOf(table);
        if (!columns)
            return tl::unexpected(columns.error());
        for (const QString &column : *columns)
            values << (overrides.contains(column) ? overrides.at(column) : column);
        return m_connection.execute(QStringLiteral("INSERT INTO %1 (%2) SELECT %3 FROM %1 WHERE %4")
                                        .arg(table, columns->join(u','), values.join(u','), condition));
    }

private:
    Result<QStringList> columnsOf(const QString &table)
    {
        if (const auto known = m_columns.find(table); known != m_columns.end())
            return known->second;
        QStringList columns;
        Statement select(m_connection, QStringLiteral("SELECT name FROM pragma_table_info('%1')").arg(table));
        auto read = select.eachRow([&columns](const Statement &row) -> Result<void> {
            columns << QString::fromStdString(row.text(0));
            return {};
        });
        if (!read)
            return tl::unexpected(read.error());
        return m_columns[table] = columns;
    }

    ProjectConnection &m_connection;
    std::map<QString, QStringList> m_columns;
};

/// The rows that are copied.
struct Source
{
    std::int64_t trial = 0, analysis = 0;
    std::int64_t recordings[2] = {};
};

Result<void> copyTrial(RowCopier &rows, ProjectConnection &connection, const Source &source, int number)
{
    const auto text = [](std::int64_t value) { return QString::number(value); };
    constexpr int firstId = 1'000'000;
    const QString id = text(firstId + number), ofTrial = QStringLiteral("trial_id=") + text(source.trial);
    const QString team = QStringLiteral("(SELECT id FROM team WHERE name='Team %1')").arg(number % teamCount);
    const QString task = QStringLiteral("(SELECT id FROM task WHERE name='Task %1')").arg(number % taskCount);
    std::vector<Result<void>> done;
    done.push_back(
        rows.copy(QStringLiteral("trial"), QStringLiteral("id=") + text(source.trial),
                  {{QStringLiteral("id"), id},
                   {QStringLiteral("name"), QStringLiteral("'Run %1'").arg(number)},
                   {QStringLiteral("team_id"), team},
                   {QStringLiteral("task_id"), task},
                   {QStringLiteral("notes"), QStringLiteral("'battery %1 per cent'").arg(number % 101)},
                   {QStringLiteral("date_ms"), QStringLiteral("date_ms+60000*%1").arg(number)}}));
    done.push_back(rows.copy(QStringLiteral("trial_robot"), ofTrial, {{QStringLiteral("trial_id"), id}}));
    for (int view = 0; view < 2; ++view) {
        const QString recording = text(firstId + 2 * number + view), old = text(source.recordings[view]);
        done.push_back(rows.copy(QStringLiteral("recording"), QStringLiteral("id=") + old,
                                 {{QStringLiteral("id"), recording},
                                  {QStringLiteral("trial_id"), id},
                                  {QStringLiteral("sha256"), u'\'' + QString(64, u'0') + u'\''}}));
        done.push_back(rows.copy(QStringLiteral("frame_time_chunk"), QStringLiteral("recording_id=") + old,
                                 {{QStringLiteral("recording_id"), recording}}));
    }
    done.push_back(rows.copy(QStringLiteral("analysis"), QStringLiteral("id=") + text(source.analysis),
                             {{QStringLiteral("id"), id}, {QStringLiteral("trial_id"), id}}));
    for (const char *table : {"analysis_view", "analysis_chunk", "spike"})
        done.push_back(rows.copy(QString::fromLatin1(table),
                                 QStringLiteral("analysis_id=") + text(source.analysis),
                                 {{QStringLiteral("analysis_id"), id}}));
    done.push_back(
        rows.copy(QStringLiteral("metric"), QStringLiteral("analysis_id=") + text(source.analysis),
                  {{QStringLiteral("analysis_id"), id},
                   {QStringLiteral("value"), QStringLiteral("value*%1").arg(1 + number % 97 * 1e-3)}}));
    if (number % 5 == 0)
        done.push_back(connection.execute(QStringLiteral("INSERT INTO trial_tag VALUES (%1,'%2')")
                                              .arg(id, QLatin1String(tags[number % 3]))));
    for (const Result<void> &each : done)
        if (!each)
            return each;
    return {};
}

Result<Source> addLists(const std::filesystem::path &file)
{
    const auto opened = Project::open(file, Project::Access::ReadWrite);
    if (!opened)
        return tl::unexpected(opened.error());
    Project &project = **opened;
    const auto added = project.inTransaction([&]() -> Result<void> {
        for (int i = 0; i < teamCount; ++i)
            if (auto team = project.teams().add(
                    {0, "Team " + std::to_string(i), "Class " + std::to_string(i % classCount), ""});
                !team)
                return tl::unexpected(team.error());
        for (int i = 0; i < taskCount; ++i) {
            TaskRecord task;
            task.name = "Task " + std::to_string(i);
            if (auto stored = project.tasks().add(task); !stored)
                return tl::unexpected(stored.error());
        }
        return {};
    });
    if (!added)
        return tl::unexpected(added.error());
    const auto trial = project.trials().find("Trial 1");
    if (!trial)
        return tl::unexpected(trial.error());
    const auto recordings = project.trials().recordings(trial->id);
    const auto analyses = project.analyses().currentMetrics(trial->id);
    if (!recordings || !analyses)
        return tl::unexpected(recordings ? analyses.error() : recordings.error());
    return Source{trial->id, analyses->at(0).id, {recordings->at(0).id, recordings->at(1).id}};
}

/// As if each had been analysed by this version: all are doubtful, which a list takes longest to read.
Result<void> addVerdicts(ProjectConnection &connection)
{
    VerdictRepository verdicts(connection);
    const auto trials = verdicts.missing(Instant::min(), Instant::max());
    if (!trials)
        return tl::unexpected(trials.error());
    for (const RecordId trial : *trials) {
        const auto basis = verdicts.basis(trial);
        if (!basis)
            return tl::unexpected(basis.error());
        const TrialVerdict doubtful{
            {{"few_spikes", CheckLevel::Doubtful, foreignWords("9 spikes in 99 positions")}}, {}};
        if (auto set = verdicts.set({trial, doubtful, *basis, {}}); !set)
            return set;
    }
    return {};
}

} // namespace

Result<std::filesystem::path> makeYearProject(const std::filesystem::path &folder, int trials)
{
    auto made = storeExample(folder, {.frames = samplesOfATrial, .widthPx = 320, .heightPx = 180});
    if (!made)
        return made;
    const std::filesystem::path file = folder / yearProjectName;
    // The recordings keep their place: they are in example.media.
    std::filesystem::rename(*made, file);
    const auto source = addLists(file);
    if (!source)
        return tl::unexpected(source.error());
    const auto connection = ProjectConnection::open(file, DatabaseAccess::ReadWrite);
    if (!connection)
        return tl::unexpected(connection.error());
    for (const char *pragma : {"PRAGMA journal_mode=OFF", "PRAGMA synchronous=OFF"})
        if (auto set = (*connection)->execute(QString::fromLatin1(pragma)); !set)
            return tl::unexpected(set.error());
    RowCopier rows(**connection);
    const auto copied = transact(**connection, [&]() -> Result<void> {
        for (int number = 3; number < trials; ++number) // the example has three
            if (auto done = copyTrial(rows, **connection, *source, number); !done)
                return done;
        return addVerdicts(**connection);
    });
    if (!copied)
        return tl::unexpected(copied.error());
    return file;
}

} // namespace odo::test
