// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include "core/base/file_system.h"
#include "core/files/output_file.h"
#include "core/project/class_repository.h"
#include "core/project/guidance_repository.h"
#include "core/project/internal/change_journal.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/opening_check.h"
#include "core/project/internal/project_check.h"
#include "core/project/internal/schema.h"
#include "core/project/names.h"
#include "core/project/new_file.h"
#include "core/project/project_rescue.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/project/school_repository.h"
#include "core/project/verdict_repository.h"

namespace odo {

namespace {

Result<std::unique_ptr<ProjectConnection>> connect(const std::filesystem::path &file, Project::Access access)
{
    return access == Project::Access::ReadWrite ? ProjectConnection::open(file, DatabaseAccess::ReadWrite)
                                                : ProjectConnection::openForReading(file);
}

Result<void> setProperty(ProjectConnection &connection, const char *name, const std::string &value)
{
    Statement remove(connection, QStringLiteral("DELETE FROM property WHERE name=?"));
    ODO_TRY(remove.bind(std::string(name)).run());
    Statement insert(connection, QStringLiteral("INSERT INTO property VALUES (?,?)"));
    return insert.bind(std::string(name)).bind(value).run();
}

/// A new database in the rollback journal's mode, so that its header is in the file from the first moment.
Result<void> makeDatabase(const std::filesystem::path &file, const std::string &title)
{
    const auto connection = ODO_TRY(ProjectConnection::open(file, DatabaseAccess::ReadWrite));
    const QString id = QStringLiteral("PRAGMA application_id=%1").arg(projectApplicationId);
    ODO_TRY(connection->execute(id));
    const Migrator &migrator = projectMigrator();
    ODO_TRY(migrator.create(*connection, migrator.newestVersion()));
    ODO_TRY(setProperty(*connection, "title", normalName(title)));
    return connection->beginHistory();
}

} // namespace

struct Project::Impl
{
    Impl(std::unique_ptr<ProjectConnection> opened, bool isToWriteBack)
        : connection(std::move(opened)), cameras(*connection), layouts(*connection), robots(*connection),
          teams(*connection), classes(*connection), school(*connection), tasks(*connection),
          trials(*connection), analyses(*connection), verdicts(*connection), guidance(*connection),
          journal(*connection), writesBack(isToWriteBack)
    {
        if (connection->access() == DatabaseAccess::ReadWrite)
            connection->watchForOverwriting();
    }

    std::unique_ptr<ProjectConnection> connection;
    CameraRepository cameras;
    LayoutRepository layouts;
    RobotRepository robots;
    TeamRepository teams;
    ClassRepository classes;
    SchoolRepository school;
    TaskRepository tasks;
    TrialRepository trials;
    AnalysisRepository analyses;
    VerdictRepository verdicts;
    GuidanceRepository guidance;
    ChangeJournal journal;
    bool writesBack; ///< the log, when it is closed
};

Project::Project(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

Project::~Project()
{
    if (m_impl->writesBack)
        emptyLog();
}

Result<std::unique_ptr<Project>> Project::create(const std::filesystem::path &file, const std::string &title)
{
    const Message what = projectSubject(file);
    ODO_TRY(checkTitle(title));
    ODO_TRY(checkNewProject(file, what));
    {
        NewFile newFile(file, what);
        ODO_TRY(newFile.prepare());
        if (auto made = makeDatabase(newFile.temporary(), title); !made)
            return fail(made.error().code, what, made.error().why, made.error().advice);
        ODO_TRY(newFile.publish());
    }
    return open(file, Access::ReadWrite);
}

Result<void> Project::checkHeader(const std::filesystem::path &file)
{
    return checkFileHeader(file, projectMigrator().newestVersion());
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
    return fail(
        ErrorCode::ReadOnly, writing.error().what,
        ODO_TEXT("project.older_format",
                 "it has the older format %1 and must be updated before Odograph can read it, but %2")(
            version, writing.error().why),
        ODO_TEXT("project.copy_with_videos",
                 "copy it with its videos to a folder that you may write to, and open the copy"));
}

bool isReady(const ProjectConnection &connection)
{
    Statement mode(connection, QStringLiteral("PRAGMA journal_mode"));
    const auto version = connection.number(QStringLiteral("PRAGMA user_version"));
    return version && *version == projectMigrator().newestVersion() && mode.firstRow().value_or(false) &&
           mode.text(0) == "wal";
}

/// Brings it up to date, while other processes that would do the same wait.
Result<void> makeReady(ProjectConnection &connection)
{
    constexpr std::chrono::seconds longestMigration{60};
    if (isReady(connection))
        return {};
    const auto turn = ODO_TRY(connection.takeTurn(longestMigration));
    ODO_TRY(connection.execute(QStringLiteral("PRAGMA journal_mode=WAL")));
    return projectMigrator().migrate(connection);
}

} // namespace

Result<std::unique_ptr<Project>> Project::open(const std::filesystem::path &file, Access access)
{
    const Migrator &migrator = projectMigrator();
    if (auto sound = checkFileHeader(file, migrator.newestVersion()); !sound)
        return tl::unexpected(namingABackup(sound.error(), file));
    ODO_TRY(checkLog(file));
    auto connection = connect(file, access);
    if (!connection)
        return tl::unexpected(namingABackup(connection.error(), file));
    // Nothing is written before it is certain that this is a sound project.
    const auto version = checkContent(**connection, migrator);
    if (!version && (*connection)->access() == DatabaseAccess::Immutable && hasLog(file)) {
        connection->reset();
        return open(file, access); // another process with write access has started one
    }
    if (!version)
        return tl::unexpected(namingABackup(version.error(), file));
    if (access == Access::ReadWrite) {
        ODO_TRY(makeReady(**connection));
    } else if (*version != migrator.newestVersion()) {
        connection->reset();
        ODO_TRY(bringUpToDate(file, *version));
        return connectTo(file, access, false);
    }
    return std::unique_ptr<Project>(
        new Project(std::make_unique<Impl>(std::move(*connection), access == Access::ReadWrite)));
}

Result<std::unique_ptr<Project>> Project::openChecked(const std::filesystem::path &file, Access access)
{
    return connectTo(file, access, access == Access::ReadWrite);
}

Result<std::unique_ptr<Project>> Project::openAgain(const std::filesystem::path &file, Access access)
{
    return connectTo(file, access, false); // who keeps it open writes it back
}

Result<std::unique_ptr<Project>> Project::connectTo(const std::filesystem::path &file, Access access,
                                                    bool writesBack)
{
    if (auto isFile = checkIsFile(file); !isFile) // SQLite would make a file that has gone meanwhile
        return tl::unexpected(isFile.error());
    auto connection = ODO_TRY(connect(file, access));
    return std::unique_ptr<Project>(new Project(std::make_unique<Impl>(std::move(connection), writesBack)));
}

const std::filesystem::path &Project::file() const
{
    return m_impl->connection->file();
}

std::filesystem::path Project::mediaFolder() const
{
    return mediaFolderOf(file());
}

std::filesystem::path Project::resolve(const RecordingRecord &recording) const
{
    return absolutePath(file(), recording.path);
}

Result<std::string> Project::title() const
{
    Statement select(*m_impl->connection, QStringLiteral("SELECT value FROM property WHERE name='title'"));
    const auto found = ODO_TRY(select.firstRow());
    const std::string title = found ? select.name(0) : std::string();
    // another program, or an older one, gave it none
    return normalName(title).empty() ? titleFromName(file()) : title;
}

Result<void> Project::setTitle(const std::string &title)
{
    ODO_TRY(checkTitle(title));
    return transact(*m_impl->connection,
                    [&] { return setProperty(*m_impl->connection, "title", normalName(title)); });
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
SchoolRepository &Project::school()
{
    return m_impl->school;
}

TaskRepository &Project::tasks()
{
    return m_impl->tasks;
}
TrialRepository &Project::trials()
{
    return m_impl->trials;
}
VerdictRepository &Project::verdicts()
{
    return m_impl->verdicts;
}

GuidanceRepository &Project::guidance()
{
    return m_impl->guidance;
}

AnalysisRepository &Project::analyses()
{
    return m_impl->analyses;
}

Result<void> Project::inTransaction(const std::function<Result<void>()> &work)
{
    return transact(*m_impl->connection, work);
}

Result<void> Project::change(const Message &words, const std::function<Result<void>()> &work,
                             const std::function<Result<void>()> &adding)
{
    return m_impl->journal.make(words, work, adding);
}

Result<void> Project::note(const Message &words, const std::function<Result<void>()> &work)
{
    return m_impl->journal.note(words, work);
}

Result<Message> Project::undo()
{
    return m_impl->journal.undo();
}

Result<Message> Project::redo()
{
    return m_impl->journal.redo();
}

Message Project::undoWords() const
{
    return m_impl->journal.undoWords();
}

Message Project::redoWords() const
{
    return m_impl->journal.redoWords();
}

Result<std::vector<ChangeEntry>> Project::changes() const
{
    return changeEntries(*m_impl->connection);
}

bool Project::isInPlace() const
{
    return m_impl->connection->isInPlace();
}

void Project::keepWritingWhenLost()
{
    m_impl->connection->keepWritingWhenLost();
}

bool Project::isOverwritten() const
{
    return m_impl->connection->isOverwritten();
}

std::optional<std::filesystem::path> Project::currentLocation() const
{
    return m_impl->connection->currentLocation();
}

Result<ProjectState> Project::state() const
{
    const ProjectConnection &connection = *m_impl->connection;
    const auto others = ODO_TRY(connection.number(QStringLiteral("PRAGMA data_version")));
    return ProjectState{others, connection.writeTurn().changesHere()};
}

bool Project::writeBack() const
{
    return m_impl->connection->checkpoint(ProjectConnection::Checkpoint::Passing);
}

bool Project::emptyLog() const
{
    return m_impl->connection->checkpoint(ProjectConnection::Checkpoint::Emptying);
}

Result<void> Project::saveCopy(const std::filesystem::path &file) const
{
    return copyDatabase(*m_impl->connection, file);
}

Result<std::vector<ProjectProblem>> Project::check(bool withHashes, const JobControl &control) const
{
    // Repositories are reached through a Project that may be changed; checking only reads.
    auto &self = const_cast<Project &>(*this); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
    return checkProject(self, *m_impl->connection, withHashes, control);
}

} // namespace odo
