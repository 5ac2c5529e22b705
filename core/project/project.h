// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/project/records.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

class QSqlDatabase;

namespace odo {

class CameraRepository;
class LayoutRepository;
class RobotRepository;
class TeamRepository;
class ClassRepository;
class SchoolRepository;
class TaskRepository;
class TrialRepository;
class AnalysisRepository;
class VerdictRepository;
class GuidanceRepository;

/// One thing that `check` found.
struct ProjectProblem
{
    Message what, where, advice;
};

/// How often a project was changed, for comparing with an earlier state of the same Project.
struct ProjectState
{
    std::int64_t byOthers = 0; ///< goes on with what other connections stored, of this process too
    std::uint64_t here = 0;    ///< goes on with what connections of this process stored
    bool operator==(const ProjectState &) const = default;
};

/// An open project file: an SQLite connection, owned by the thread that opened it and used on no other.
/// Repositories are reached through it and live as long as it. Each of their changes is one transaction of
/// its own, unless it happens inside inTransaction.
class Project
{
public:
    enum class Access { ReadWrite, ReadOnly };

    /// Makes a new file with the current schema. AlreadyExists where a file of that name is; InvalidInput for
    /// a title that checkTitle() refuses; nothing is left behind on failure.
    static Result<std::unique_ptr<Project>> create(const std::filesystem::path &file,
                                                   const std::string &title);
    /// Opens a file; older schemas are migrated after a verified backup ("<name>.odo.bak-<version>"), before
    /// it is opened for reading as well. Errors: missing, not a project, corrupt, newer (NewerFormat), no
    /// write access, or of an older format without it (ReadOnly).
    static Result<std::unique_ptr<Project>> open(const std::filesystem::path &file, Access access);
    /// What can be checked of a file at once: that it is missing, no project, cut off, or of a newer
    /// Odograph.
    static Result<void> checkHeader(const std::filesystem::path &file);
    /// A file that open() has just checked and updated, on another thread. Quick.
    static Result<std::unique_ptr<Project>> openChecked(const std::filesystem::path &file, Access access);
    /// Once more a file that this program has open and keeps open meanwhile: for another thread, which must
    /// open it itself. As quick. Of all that a program has open of one file, one writes at a time; the others
    /// wait.
    static Result<std::unique_ptr<Project>> openAgain(const std::filesystem::path &file, Access access);
    ~Project();
    Project(const Project &) = delete;
    Project &operator=(const Project &) = delete;

    const std::filesystem::path &file() const;
    /// "<name>.media" beside the file, links to it followed; absolute; made when first needed by those who
    /// write there.
    std::filesystem::path mediaFolder() const;
    /// Absolute path of a recording.
    std::filesystem::path resolve(const RecordingRecord &recording) const;

    /// As a name is shown; of one without a title what its file is called.
    Result<std::string> title() const;
    /// As create(): the title must be one that checkTitle() allows.
    Result<void> setTitle(const std::string &title);

    CameraRepository &cameras();
    LayoutRepository &layouts();
    RobotRepository &robots();
    TeamRepository &teams();
    ClassRepository &classes();
    SchoolRepository &school();
    TaskRepository &tasks();
    TrialRepository &trials();
    AnalysisRepository &analyses();
    VerdictRepository &verdicts();
    GuidanceRepository &guidance();

    /// Runs work in one transaction that is rolled back when work fails; inside another one it is a savepoint
    /// of it.
    Result<void> inTransaction(const std::function<Result<void>()> &work);
    /// As inTransaction, of a change that a person made and can undo. words: what it does ("rename team
    /// Falcon"), also for the list of changes. Inside another change it is a part of that one; work that
    /// changes nothing leaves no trace. adding: what is done before in the same transaction and stays when
    /// work is undone, for raw measurements are never lost: an import puts its trial into the bin, and work
    /// takes it out. Observations stay, too, wherever they are added; undoing takes them out of force.
    Result<void> change(const Message &words, const std::function<Result<void>()> &work,
                        const std::function<Result<void>()> &adding = {});
    /// As change, for what cannot be undone because it was recorded or deleted for good: it is in the list of
    /// changes. Inside a change it is a part of that one.
    Result<void> note(const Message &words, const std::function<Result<void>()> &work);
    /// Undoes the last change of this session, or redoes it; returns its description. NotFound where there
    /// is none; InvalidInput, and nothing done, where what it concerns has been changed since in another way.
    Result<Message> undo();
    Result<Message> redo();
    /// Of what undo and redo would concern; empty: nothing.
    Message undoWords() const;
    Message redoWords() const;
    /// What was ever changed and when, the newest first.
    Result<std::vector<ChangeEntry>> changes() const;
    /// Whether the file is still where it was opened. One that was deleted, renamed or replaced since can be
    /// read here as long as it is open, and saveCopy rescues it; changes are refused, for they would be lost
    /// to whoever opens that path.
    bool isInPlace() const;
    /// From now on such changes are made: by who rescues the project then.
    void keepWritingWhenLost();
    /// Whether another file was copied over this one, or anything else wrote to it past SQLite, since it was
    /// opened for writing. What it held is gone, and nothing more is written to it here: open it again. False
    /// while somebody writes to it as this program does.
    bool isOverwritten() const;
    /// Where the file is now that was opened; nothing where it was deleted.
    std::optional<std::filesystem::path> currentLocation() const;
    /// Shows whether anything was changed since.
    Result<ProjectState> state() const;
    /// Writes what the log holds into the project file, without waiting for those who read: a copy of the
    /// file has it then. False where somebody still reads an older state, or another program writes.
    bool writeBack() const;
    /// As writeBack, but waits for those who read, and leaves an empty log.
    bool emptyLog() const;
    /// Copies the whole project to another file through SQLite's backup API.
    Result<void> saveCopy(const std::filesystem::path &file) const;
    /// Integrity of the database, references, files (present, size), and whether analyses are what they were
    /// when they were made, by their digests. withHashes, which takes as long as reading all recordings: the
    /// content of the files as well, and every metric recomputed from the stored positions. Cancelled.
    Result<std::vector<ProjectProblem>> check(bool withHashes, const JobControl &control = {}) const;

private:
    struct Impl;
    explicit Project(std::unique_ptr<Impl> impl);
    static Result<std::unique_ptr<Project>> connectTo(const std::filesystem::path &file, Access access,
                                                      bool writesBack);
    std::unique_ptr<Impl> m_impl;
};

/// Project::change of work that gives a Result with a value, which is passed on.
template <class Work>
auto changing(Project &project, const Message &words, const Work &work) -> decltype(work())
{
    std::optional<decltype(work())> outcome;
    const Result<void> done = project.change(words, [&]() -> Result<void> {
        outcome = work();
        return *outcome ? Result<void>() : tl::unexpected(outcome->error());
    });
    if (!done)
        return tl::unexpected(done.error());
    return std::move(*outcome);
}

} // namespace odo
