// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include "core/project/change_journal.h"
#include "core/project/class_repository.h"
#include "core/project/connection.h"
#include "core/project/file_header.h"
#include "core/project/names.h"
#include "core/project/new_file.h"
#include "core/project/project_check.h"
#include "core/project/quick_check.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/project/schema.h"
#include "core/project/sound_backup.h"
#include "core/project/step_limit.h"

#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <set>

namespace odo {

namespace {

/// Larger files are looked through only by Project::check: reading them at every start would be slow.
constexpr std::uintmax_t quickCheckBytes = 64 * 1024 * 1024;
/// More than the fullest file of that size takes; a file may be made so that reading it does not end.
constexpr std::int64_t mostOpeningSteps = 500'000'000;

std::filesystem::path beside(const std::filesystem::path &file, const char *suffix)
{
    std::filesystem::path other = file;
    other += suffix;
    return other;
}

using Schema = std::set<std::string>;

/// The schema as SQLite keeps it: one text for each table, index, trigger and view; the first so many of them.
Result<Schema> schemaOf(const ProjectConnection &connection, std::size_t most)
{
    Schema schema;
    Statement select(connection, QStringLiteral("SELECT type, name, sql FROM sqlite_master LIMIT ?"));
    auto read = select.bind(static_cast<std::int64_t>(most)).eachRow([&schema](const Statement &row) -> Result<void> {
        schema.insert(row.text(0) + ' ' + row.text(1) + ' ' + row.text(2));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return schema;
}

/// What a project of that version has. Kept, because making it takes longer than to look through a small project. Any thread.
Result<Schema> expectedSchema(const Migrator &migrator, int version)
{
    static std::mutex mutex;
    static std::map<int, Schema> known;
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(version); found != known.end())
        return found->second;
    const auto reference = ProjectConnection::open(":memory:", DatabaseAccess::ReadWrite);
    if (!reference)
        return tl::unexpected(reference.error());
    if (auto made = migrator.create(**reference, version); !made)
        return tl::unexpected(made.error());
    auto schema = schemaOf(**reference, std::numeric_limits<std::int64_t>::max());
    if (schema)
        known.emplace(version, *schema);
    return schema;
}

/// A project may come from anyone: views, triggers or checks in it that are not ours would be a program that we run.
Result<void> checkSchema(const ProjectConnection &connection, const Migrator &migrator, int version)
{
    const auto expected = expectedSchema(migrator, version);
    if (!expected)
        return tl::unexpected(expected.error());
    const auto found = schemaOf(connection, expected->size() + 1);
    if (!found)
        return tl::unexpected(found.error());
    if (*expected != *found)
        return fail(ErrorCode::InvalidInput, connection.displayName(),
                    "its tables are not those of a project", "restore it from a backup copy");
    return {};
}

/// Whether the disk gives all of it, whatever it is.
bool canBeRead(const std::filesystem::path &file)
{
    std::ifstream input(file, std::ios::binary);
    std::vector<char> block(1 << 16);
    while (input.read(block.data(), static_cast<std::streamsize>(block.size()))) {
    }
    return input.eof() && !input.bad();
}

Result<void> quickCheck(const ProjectConnection &connection)
{
    std::error_code problem;
    if (std::filesystem::file_size(connection.file(), problem) > quickCheckBytes)
        return {};
    // What the disk fails to give looks like damage to SQLite: so it is asked once more.
    for (int attempt = 0; attempt < 2; ++attempt) {
        const auto sound = passesQuickCheck(connection);
        if (!sound)
            return tl::unexpected(sound.error());
        if (*sound)
            return {};
        if (!canBeRead(connection.file()))
            return fail(ErrorCode::Io, connection.displayName(), "the disk could not be read, and nothing was changed",
                        "check the disk, and copy the project to another one");
    }
    return fail(ErrorCode::InvalidInput, connection.displayName(), "the file is damaged", "restore it from a backup copy");
}

/// The version of the schema, when the file is whole and holds nothing but that schema. The schema comes first, for looking through
/// the rest evaluates the checks in it.
Result<int> checkContent(const ProjectConnection &connection, const Migrator &migrator)
{
    const StepLimit limit(connection, mostOpeningSteps);
    const auto version = migrator.knownVersion(connection);
    if (!version)
        return version;
    if (auto ours = checkSchema(connection, migrator, *version); !ours)
        return tl::unexpected(ours.error());
    if (auto sound = quickCheck(connection); !sound)
        return tl::unexpected(sound.error());
    return version;
}

DatabaseAccess databaseAccess(const std::filesystem::path &file, Project::Access access)
{
    if (access == Project::Access::ReadWrite)
        return DatabaseAccess::ReadWrite;
    std::error_code problem;
    return std::filesystem::exists(beside(file, "-wal"), problem) ? DatabaseAccess::ReadOnly
                                                                  : DatabaseAccess::Immutable;
}

Result<void> setProperty(ProjectConnection &connection, const char *name, const std::string &value)
{
    Statement remove(connection, QStringLiteral("DELETE FROM property WHERE name=?"));
    if (auto done = remove.bind(std::string(name)).run(); !done)
        return done;
    Statement insert(connection, QStringLiteral("INSERT INTO property VALUES (?,?)"));
    return insert.bind(std::string(name)).bind(value).run();
}

/// A new database in the rollback journal's mode, so that its header is in the file from the first moment.
Result<void> makeDatabase(const std::filesystem::path &file, const std::string &title)
{
    const auto connection = ProjectConnection::open(file, DatabaseAccess::ReadWrite);
    if (!connection)
        return tl::unexpected(connection.error());
    const QString id = QStringLiteral("PRAGMA application_id=%1").arg(projectApplicationId);
    if (auto done = (*connection)->execute(id); !done)
        return done;
    const Migrator migrator(projectMigrations());
    if (auto made = migrator.create(**connection, migrator.newestVersion()); !made)
        return made;
    return setProperty(**connection, "title", title);
}

} // namespace

struct Project::Impl
{
    explicit Impl(std::unique_ptr<ProjectConnection> opened)
        : connection(std::move(opened)), cameras(*connection), layouts(*connection), robots(*connection),
          teams(*connection), classes(*connection), tasks(*connection), trials(*connection), analyses(*connection),
          journal(*connection)
    {
    }

    std::unique_ptr<ProjectConnection> connection;
    CameraRepository cameras;
    LayoutRepository layouts;
    RobotRepository robots;
    TeamRepository teams;
    ClassRepository classes;
    TaskRepository tasks;
    TrialRepository trials;
    AnalysisRepository analyses;
    ChangeJournal journal;
    bool writesBack = false; ///< the log, when it is closed
};

Project::Project(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

Project::~Project()
{
    if (m_impl->writesBack)
        m_impl->connection->checkpoint();
}

Result<std::unique_ptr<Project>> Project::create(const std::filesystem::path &file, const std::string &title)
{
    const std::string what = "project '" + file.string() + "'";
    if (auto valid = checkText("title of the project", title); !valid)
        return tl::unexpected(valid.error());
    {
        NewFile newFile(file, what);
        if (auto ready = newFile.prepare(); !ready)
            return tl::unexpected(ready.error());
        if (auto made = makeDatabase(newFile.temporary(), title); !made)
            return fail(made.error().code, what, made.error().why, made.error().advice);
        if (auto published = newFile.publish(); !published)
            return tl::unexpected(published.error());
    }
    return open(file, Access::ReadWrite);
}

Result<void> Project::checkHeader(const std::filesystem::path &file)
{
    return checkFileHeader(file, Migrator(projectMigrations()).newestVersion());
}

namespace {

/// For one that is only to be read.
Result<void> bringUpToDate(const std::filesystem::path &file, int version)
{
    const auto writing = Project::open(file, Project::Access::ReadWrite);
    if (writing)
        return {};
    if (writing.error().code != ErrorCode::ReadOnly)
        return tl::unexpected(writing.error());
    return fail(ErrorCode::ReadOnly, writing.error().what,
                "it has the older format " + std::to_string(version) +
                    " and must be brought up to date before it can be read, but " + writing.error().why,
                "copy it with its videos to a folder that you may write to, and open the copy");
}

} // namespace

Result<std::unique_ptr<Project>> Project::open(const std::filesystem::path &file, Access access)
{
    const Migrator migrator(projectMigrations());
    if (auto sound = checkFileHeader(file, migrator.newestVersion()); !sound)
        return tl::unexpected(namingABackup(sound.error(), file));
    auto connection = ProjectConnection::open(file, databaseAccess(file, access));
    if (!connection)
        return tl::unexpected(namingABackup(connection.error(), file));
    // Nothing is written before it is certain that this is a sound project.
    const auto version = checkContent(**connection, migrator);
    if (!version)
        return tl::unexpected(namingABackup(version.error(), file));
    if (access == Access::ReadWrite) {
        if (auto done = (*connection)->execute(QStringLiteral("PRAGMA journal_mode=WAL")); !done)
            return tl::unexpected(done.error());
        if (auto migrated = migrator.migrate(**connection); !migrated)
            return tl::unexpected(migrated.error());
    } else if (*version != migrator.newestVersion()) {
        connection->reset();
        if (auto migrated = bringUpToDate(file, *version); !migrated)
            return tl::unexpected(migrated.error());
        return connectTo(file, access, false);
    }
    auto impl = std::make_unique<Impl>(std::move(*connection));
    impl->writesBack = access == Access::ReadWrite;
    return std::unique_ptr<Project>(new Project(std::move(impl)));
}

Result<std::unique_ptr<Project>> Project::openChecked(const std::filesystem::path &file, Access access)
{
    return connectTo(file, access, access == Access::ReadWrite);
}

Result<std::unique_ptr<Project>> Project::openAgain(const std::filesystem::path &file, Access access)
{
    return connectTo(file, access, false); // who keeps it open writes it back
}

Result<std::unique_ptr<Project>> Project::connectTo(const std::filesystem::path &file, Access access, bool writesBack)
{
    if (auto sound = checkHeader(file); !sound) // SQLite would make a file that has gone meanwhile
        return tl::unexpected(sound.error());
    auto connection = ProjectConnection::open(file, databaseAccess(file, access));
    if (!connection)
        return tl::unexpected(connection.error());
    auto impl = std::make_unique<Impl>(std::move(*connection));
    impl->writesBack = writesBack;
    return std::unique_ptr<Project>(new Project(std::move(impl)));
}

const std::filesystem::path &Project::file() const
{
    return m_impl->connection->file();
}

std::filesystem::path Project::mediaFolder() const
{
    std::filesystem::path folder = file();
    return folder.replace_extension(".media");
}

std::filesystem::path Project::resolve(const RecordingRecord &recording) const
{
    return absolutePath(file(), recording.path);
}

Result<std::string> Project::title() const
{
    Statement select(*m_impl->connection, QStringLiteral("SELECT value FROM property WHERE name='title'"));
    const auto found = select.firstRow();
    if (!found)
        return tl::unexpected(found.error());
    return *found ? select.text(0) : std::string();
}

Result<void> Project::setTitle(const std::string &title)
{
    if (auto valid = checkText("title of the project", title); !valid)
        return valid;
    return transact(*m_impl->connection, [&] { return setProperty(*m_impl->connection, "title", title); });
}

CameraRepository &Project::cameras()
{
    return m_impl->cameras;
}
LayoutRepository &Project::layouts()
{
    return m_impl->layouts;
}
RobotRepository &Project::robots()
{
    return m_impl->robots;
}
TeamRepository &Project::teams()
{
    return m_impl->teams;
}
ClassRepository &Project::classes()
{
    return m_impl->classes;
}
TaskRepository &Project::tasks()
{
    return m_impl->tasks;
}
TrialRepository &Project::trials()
{
    return m_impl->trials;
}
AnalysisRepository &Project::analyses()
{
    return m_impl->analyses;
}

Result<void> Project::inTransaction(const std::function<Result<void>()> &work)
{
    return transact(*m_impl->connection, work);
}

Result<void> Project::change(const std::string &words, const std::function<Result<void>()> &work)
{
    return m_impl->journal.make(words, work);
}

Result<void> Project::note(const std::string &words, const std::function<Result<void>()> &work)
{
    return m_impl->journal.note(words, work);
}

Result<std::string> Project::undo()
{
    return m_impl->journal.undo();
}

Result<std::string> Project::redo()
{
    return m_impl->journal.redo();
}

std::string Project::undoWords() const
{
    return m_impl->journal.undoWords();
}

std::string Project::redoWords() const
{
    return m_impl->journal.redoWords();
}

Result<std::vector<ChangeEntry>> Project::changes() const
{
    return changeEntries(*m_impl->connection);
}

Result<void> Project::saveCopy(const std::filesystem::path &file) const
{
    return copyDatabase(*m_impl->connection, file);
}

Result<std::vector<ProjectProblem>> Project::check(bool withHashes) const
{
    // Repositories are reached through a Project that may be changed; checking only reads.
    return checkProject(const_cast<Project &>(*this), *m_impl->connection, withHashes);
}

} // namespace odo
