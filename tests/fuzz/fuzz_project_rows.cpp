// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/change_journal.h"
#include "core/project/internal/connection.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/read_project.h"
#include "tests/fuzz/sqlite_memory.h"
#include "tests/project/sample_records.h"

#include <fuzzer/FuzzedDataProvider.h>

namespace {

using namespace odo;

struct Column
{
    QString table, name;
};

/// A filled project that stays open. What a run changes in it is taken back afterwards, which costs far less
/// than a file of its own: so the rows of a sound project get values that no Odograph would have written.
class OpenProject
{
public:
    OpenProject() : m_file(m_place.holding(nullptr, 0))
    {
        fuzz::givePlainMemoryToSqlite();
        std::filesystem::remove(m_file);
        RecordSource source(7);
        {
            const auto project = Project::create(m_file, "title").value();
            const FilledProject filled = fill(*project, source).value();
            addTheRest(*project, filled, source);
        }
        m_connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite).value();
        execute("PRAGMA foreign_keys=OFF");
        execute("PRAGMA ignore_check_constraints=ON");
        for (const QString &trigger : names("SELECT name FROM sqlite_master WHERE type='trigger'"))
            execute("DROP TRIGGER " + trigger.toUtf8());
        for (const QString &table : names("SELECT name FROM sqlite_master WHERE type='table'")) {
            for (const QString &column :
                 names("SELECT name FROM pragma_table_info('" + table.toUtf8() + "')"))
                m_columns.push_back({table, column});
        }
        m_repositories.emplace(*m_connection);
        m_ids = fuzz::idsOf(*m_repositories);
    }

    void change(FuzzedDataProvider &data)
    {
        const Column &column = m_columns[data.ConsumeIntegralInRange<std::size_t>(0, m_columns.size() - 1)];
        const QString where = QStringLiteral(" WHERE rowid=(SELECT rowid FROM %1 LIMIT 1 OFFSET %2)")
                                  .arg(column.table)
                                  .arg(data.ConsumeIntegral<std::uint8_t>() % 4);
        const QString set =
            QStringLiteral("UPDATE OR IGNORE %1 SET %2=?").arg(column.table, column.name) + where;
        switch (data.ConsumeIntegralInRange(0, 5)) {
        case 0:
            return run(Statement(*m_connection, set).bind(data.ConsumeIntegral<std::int64_t>()));
        case 1:
            return run(Statement(*m_connection, set).bind(std::int64_t(data.ConsumeIntegral<std::int8_t>())));
        case 2: {
            const auto number = data.ConsumeFloatingPoint<double>();
            return run(Statement(*m_connection, set).bind(std::isfinite(number) ? number : 1e308));
        }
        case 3:
            return run(Statement(*m_connection, set).bind(data.ConsumeRandomLengthString(64)));
        case 4:
            return run(Statement(*m_connection, set).bind(mutated(column, where, data)));
        default: {
            Statement remove(*m_connection, QStringLiteral("DELETE FROM ") + column.table + where);
            return run(remove);
        }
        }
    }

    struct Repositories
    {
        explicit Repositories(ProjectConnection &c)
            : m_cameras(c), m_layouts(c), m_robots(c), m_teams(c), m_classes(c), m_tasks(c), m_trials(c),
              m_analyses(c)
        {
        }
        CameraRepository &cameras() { return m_cameras; }
        LayoutRepository &layouts() { return m_layouts; }
        RobotRepository &robots() { return m_robots; }
        TeamRepository &teams() { return m_teams; }
        ClassRepository &classes() { return m_classes; }
        TaskRepository &tasks() { return m_tasks; }
        TrialRepository &trials() { return m_trials; }
        AnalysisRepository &analyses() { return m_analyses; }

    private:
        CameraRepository m_cameras;
        LayoutRepository m_layouts;
        RobotRepository m_robots;
        TeamRepository m_teams;
        ClassRepository m_classes;
        TaskRepository m_tasks;
        TrialRepository m_trials;
        AnalysisRepository m_analyses;
    };

    static constexpr std::size_t readerCount = fuzz::readers<Repositories>.size() + 1;

    /// which: below readerCount.
    void read(std::size_t which)
    {
        if (which < fuzz::readers<Repositories>.size())
            return fuzz::readers<Repositories>[which](*m_repositories, m_ids);
        static_cast<void>(changeEntries(*m_connection));
    }

    void execute(const QByteArray &sql)
    {
        if (const auto done = m_connection->execute(QString::fromUtf8(sql)); !done) {
            std::fprintf(stderr, "%s: %s\n", sql.constData(), done.error().message().c_str());
            std::abort();
        }
    }

private:
    static void run(Statement &statement) { static_cast<void>(statement.run()); }

    QStringList names(const QByteArray &sql)
    {
        QStringList found;
        Statement select(*m_connection, QString::fromUtf8(sql));
        static_cast<void>(select.eachRow([&found](const Statement &row) -> Result<void> {
            found += QString::fromStdString(row.text(0));
            return {};
        }));
        return found;
    }

    /// What is there with some bytes replaced, or cut.
    QByteArray mutated(const Column &column, const QString &where, FuzzedDataProvider &data)
    {
        Statement select(*m_connection,
                         QStringLiteral("SELECT %2 FROM %1").arg(column.table, column.name) + where);
        const auto found = select.firstRow();
        QByteArray bytes = found && *found ? select.blob(0) : QByteArray();
        if (data.ConsumeBool())
            bytes.truncate(data.ConsumeIntegralInRange<qsizetype>(0, bytes.size()));
        const auto at = data.ConsumeIntegralInRange<qsizetype>(0, bytes.size());
        const auto fresh = data.ConsumeRandomLengthString(32);
        bytes.replace(at, std::min<qsizetype>(bytes.size() - at, static_cast<qsizetype>(fresh.size())),
                      QByteArray::fromStdString(fresh));
        return bytes;
    }

    /// What the sample has not: a trial that is being recorded, a track from elsewhere, marks.
    static void addTheRest(Project &project, const FilledProject &filled, RecordSource &source)
    {
        TrialRecord trial;
        trial.name = "unfinished";
        const TrialRecord begun =
            project.trials().begin(trial, {source.recording(project.cameras().find("A")->id, 0)}).value();
        RecordedTimes times;
        times.frames = {{1, Nanoseconds(10), Nanoseconds(20)}, {2, Nanoseconds(30), Nanoseconds(40)}};
        times.readings = {{Nanoseconds(5), Nanoseconds(6), Nanoseconds(7)}};
        const auto recordings = project.trials().recordings(begun.id).value();
        static_cast<void>(project.trials().appendRawTimes(recordings.front().id, times));
        trial.name = "imported";
        const TrialRecord bare = project.trials().add(trial, {}).value();
        ImportedTrack track;
        track.trial = bare.id;
        track.robot = filled.robot;
        track.file = "x.csv";
        track.format = "csv";
        for (int i = 0; i < 5; ++i) {
            track.samples.emplace_back();
            track.samples.back().time = Nanoseconds(i);
            track.samples.back().position = Eigen::Vector2d(i, 1);
        }
        static_cast<void>(project.trials().addImportedTrack(track));
        static_cast<void>(project.trials().setTags(filled.trial, {"tag"}));
        static_cast<void>(project.trials().setManualOverrides(filled.trial, filled.robot, {{3, true}}));
        static_cast<void>(
            project.tasks().setScoring(project.tasks().find("line")->id, {{"duration", 1, 10, 5}}));
    }

    fuzz::File m_place{".odo"};
    const std::filesystem::path m_file;
    std::unique_ptr<ProjectConnection> m_connection;
    std::vector<Column> m_columns;
    std::optional<Repositories> m_repositories;
    fuzz::Ids m_ids; ///< as they were before anything was changed
};

} // namespace

/// Rows of a project with values of any type and size, read in the way that the last byte names.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    static OpenProject project;
    FuzzedDataProvider data(bytes, count);
    const auto reader = data.ConsumeIntegralInRange<std::size_t>(0, OpenProject::readerCount - 1);
    project.execute("BEGIN");
    for (int changes = 0; changes < 3 && data.remaining_bytes() > 0; ++changes)
        project.change(data);
    project.read(reader);
    project.execute("ROLLBACK");
    return 0;
}
