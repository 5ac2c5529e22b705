// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace odo {

class BackgroundTask;
class Job;
class JobRunner;
class Project;
class ProjectWatch;
class ReplacingCopy;
class WindowLock;

/// The project that the window shows, if any, and the one job that may run on it. GUI thread.
class Workspace : public QObject
{
    Q_OBJECT
public:
    /// What to do with a job that came to a good end; called on the GUI thread.
    using Done = std::function<void()>;

    explicit Workspace(QObject *parent = nullptr);
    ~Workspace() override;

    Project *project() const { return m_project.get(); }
    bool isReadOnly() const { return !m_lock; }
    bool isBusy() const;
    /// All changes are in the project file, so that a copy of it has them.
    bool isSaved() const;

    /// Starts to open for writing or, if the folder is write-protected or another window has the project, for
    /// reading; checks and migrates the file on a thread of its own. Like makeAndOpen.
    Result<void> beginOpening(const std::filesystem::path &file, Done whenOpen = {});
    /// As beginOpening, but waits: where no window is on screen. The project that was open stays when it
    /// fails.
    Result<void> open(const std::filesystem::path &file);
    /// Makes a project and opens it.
    Result<void> create(const std::filesystem::path &file, const QString &title);

    /// Starts a job on the open project. Refused while another one runs.
    Result<void> start(std::shared_ptr<Job> job, const Message &words, Done done);
    /// Makes a project, on a thread of its own, and opens it when it is done; then whenOpen is called. The
    /// project that is open stays until then, or when it fails. Refused while a job runs. Trials of the
    /// opened project whose recording was cut off are completed by a job, and hashes that are missing are
    /// made.
    Result<void> makeAndOpen(std::function<Result<std::filesystem::path>(const JobControl &)> make,
                             const Message &words, Done whenOpen = {});
    /// Puts a copy of its newest sound backup in the place of a damaged project, which is kept beside it, and
    /// opens that. As makeAndOpen.
    Result<void> beginRestoring(const std::filesystem::path &file, Done whenOpen);
    /// Restores one of the backups of the open project; what it was until then becomes a backup. A copy of
    /// the backup is made on a thread of its own, and only then is the project closed and opened again.
    Result<void> beginGoingBack(const std::filesystem::path &backup);
    void cancel();
    /// For a project whose file was deleted, renamed or replaced: copies what is in it to a new file beside
    /// it, and opens that. Gives the new file.
    Result<std::filesystem::path> rescue();
    /// Where the project's file and its media folder were moved to, as those of that name; nothing where not
    /// both of them were.
    std::optional<std::filesystem::path> movedTo() const;
    /// For a project whose file another program wrote over: closes it and opens what the file holds now.
    /// Where that cannot be opened no project is open afterwards.
    Result<void> reopen();

Q_SIGNALS:
    /// Something was done on opening that the user should know.
    void messageReady(const QString &words);
    void aboutToClose(); ///< project() is still the old one
    void opened();
    void changed(); ///< by a job that ran on it, or by another program
    void savedChanged();
    void lost(); ///< the project's file was deleted, renamed or replaced; again and again until it is rescued
    void overwritten(); ///< another program wrote over the project's file; likewise, until it is opened again
    void jobStarted(const QString &words);
    void jobProgressed(double fraction, const QString &text);
    /// Every job ends with one of these; a cancelled one fails with ErrorCode::Cancelled.
    void jobDone();
    void jobFailed(const odo::Error &error);
    /// Behind the failure to open a project that is damaged: beginRestoring would do.
    void backupFound(const std::filesystem::path &project);

private:
    /// A checked project, to be opened again by the thread that shows it.
    struct Ready;
    /// What a job on a thread of its own leaves for this one.
    struct Made;
    /// Finds or makes a project on a thread of its own, and opens it.
    Result<void> begin(std::function<Result<std::filesystem::path>(const JobControl &, Made &)> find,
                       const Message &words, Done whenOpen);
    static Result<Ready> makeReady(const std::filesystem::path &file, const std::filesystem::path &openHere);
    std::filesystem::path openHere() const;
    static Error offeringABackup(Error error, const std::filesystem::path &file, Made &made);
    Result<void> show(Ready ready);
    void completeRestoring(ReplacingCopy &copy);
    void close();
    /// As the preferences ask for it, in the background: it is no job.
    void backUp();
    void recoverTrials();
    void makeHashes();
    void finishJob(const std::optional<Error> &error);
    void adopt(std::unique_ptr<Project> project, std::unique_ptr<WindowLock> lock);

    std::unique_ptr<WindowLock> m_lock; ///< null: the project can only be read
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ProjectWatch> m_watch;
    std::unique_ptr<JobRunner> m_runner; ///< after the project: it must end before it
    std::unique_ptr<BackgroundTask> m_making;
    Done m_done;
};

} // namespace odo
