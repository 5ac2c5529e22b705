// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/workspace.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/project_rescue.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/backups.h"
#include "core/workflow/job.h"
#include "core/workflow/record/completed_recordings.h"
#include "ui/main_window/internal/project_watch.h"
#include "ui/main_window/preferences/backup_plan.h"
#include "ui/models/background_task.h"
#include "ui/models/shown_message.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

namespace odo {
namespace {

tl::unexpected<Error> busy(Message what)
{
    return fail(ErrorCode::InvalidInput, std::move(what), anotherJobRuns(), waitOrCancel());
}

Message restoringBackup()
{
    return ODO_TEXT("ui.restoring_backup", "Restoring the backup");
}

} // namespace

Workspace::Workspace(QObject *parent) : QObject(parent) {}

Workspace::~Workspace() = default;

bool Workspace::isBusy() const
{
    return (m_runner && m_runner->isRunning()) || (m_making && m_making->isRunning());
}

bool Workspace::isSaved() const
{
    return m_watch && m_watch->isSaved();
}

struct Workspace::Ready
{
    std::filesystem::path file;
    std::unique_ptr<WindowLock> lock; ///< null: for reading only, or it is the one that is open here
    bool isOpenHere = false;
    /// why it is read-only, if another window has it, or a warning about its location
    QString words = {};
    bool isCutOff = false, lacksHashes = false;
};

struct Workspace::Made
{
    Ready ready;
    std::filesystem::path written = {}; ///< created for it, kept in any case
    /// the project that failed to open, if an intact backup is beside it
    std::filesystem::path damaged = {};
};

Result<void> Workspace::open(const std::filesystem::path &file)
{
    if (isBusy())
        return busy(ODO_TEXT("ui.cannot_open_another", "cannot open another project"));
    auto ready = makeReady(file, openHere());
    return ready ? show(std::move(*ready)) : tl::unexpected(ready.error());
}

Result<void> Workspace::beginOpening(const std::filesystem::path &file, Done whenOpen)
{
    return begin([file](const JobControl &, Made &) -> Result<std::filesystem::path> { return file; },
                 ODO_TEXT("ui.opening", "Opening %1")(Named::file(file.filename())), std::move(whenOpen));
}

/// The file that is open for writing; empty: none.
std::filesystem::path Workspace::openHere() const
{
    return m_lock ? m_project->file() : std::filesystem::path();
}

/// On any thread.
Result<Workspace::Ready> Workspace::makeReady(const std::filesystem::path &file,
                                              const std::filesystem::path &openHere)
{
    Ready ready{file, nullptr, !openHere.empty() && files::isSame(file, openHere)};
    if (!ready.isOpenHere) {
        auto lock = WindowLock::take(file);
        if (lock)
            ready.lock = std::move(*lock);
        else if (lock.error().code == ErrorCode::AlreadyExists)
            ready.words = tr("%1: %2. It is read-only here; to change it, close it there and reopen it here.")
                              .arg(shownWords(lock.error().what), shownWords(lock.error().why));
    }
    const auto access = [&ready] {
        return ready.lock || ready.isOpenHere ? Project::Access::ReadWrite : Project::Access::ReadOnly;
    };
    auto project = Project::open(file, access());
    if (!project && project.error().code == ErrorCode::ReadOnly && access() == Project::Access::ReadWrite) {
        ready.lock.reset();
        ready.isOpenHere = false;
        project = Project::open(file, Project::Access::ReadOnly);
    }
    if (!project)
        return tl::unexpected(project.error());
    if (access() == Project::Access::ReadOnly)
        return ready;
    if (const auto warning = locationWarning(file))
        ready.words = shownWords(*warning);
    const auto trials = (*project)->trials().names();
    ready.isCutOff = trials && std::ranges::any_of(*trials, &TrialName::unfinished);
    HashJob hashes;
    ready.lacksHashes = hashes.prepare(**project) && hashes.isNeeded();
    return ready;
}

Result<void> Workspace::show(Ready ready)
{
    auto lock = ready.isOpenHere ? std::move(m_lock) : std::move(ready.lock);
    auto project =
        Project::openChecked(ready.file, lock ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project) {
        if (ready.isOpenHere)
            m_lock = std::move(lock);
        return tl::unexpected(project.error());
    }
    adopt(std::move(*project), std::move(lock));
    if (m_lock)
        backUp();
    if (!ready.words.isEmpty())
        Q_EMIT messageReady(ready.words);
    if (ready.isCutOff)
        recoverTrials();
    else if (ready.lacksHashes)
        makeHashes();
    return {};
}

void Workspace::recoverTrials()
{
    const auto job = std::make_shared<RecoverJob>();
    const Result<void> started =
        start(job, ODO_TEXT("ui.completing_recording", "Completing an interrupted recording"), [this, job] {
            QStringList words;
            for (const Message &sentence : job->problems())
                words << shownWords(sentence);
            if (!words.isEmpty())
                Q_EMIT messageReady(words.join(u'\n'));
            makeHashes();
        });
    if (!started)
        Q_EMIT jobFailed(started.error());
}

/// Of recordings that the window was closed upon.
void Workspace::makeHashes()
{
    HashJob look;
    if (!look.prepare(*m_project) || !look.isNeeded())
        return;
    if (const Result<void> started =
            start(std::make_shared<HashJob>(),
                  ODO_TEXT("ui.making_hashes", "Computing the hashes of new recordings"), nullptr);
        !started)
        Q_EMIT jobFailed(started.error());
}

Result<void> Workspace::create(const std::filesystem::path &file, const QString &title)
{
    if (isBusy())
        return busy(ODO_TEXT("ui.cannot_make_another", "cannot create another project"));
    std::unique_ptr<Project> project = ODO_TRY(Project::create(file, title.toStdString()));
    auto lock = ODO_TRY(WindowLock::take(file));
    adopt(std::move(project), std::move(lock));
    return {};
}

void Workspace::adopt(std::unique_ptr<Project> project, std::unique_ptr<WindowLock> lock)
{
    Q_EMIT aboutToClose();
    m_runner.reset();
    m_watch.reset();
    m_project = std::move(project);
    m_project->keepWritingWhenLost(); // it is rescued
    m_lock = std::move(lock);
    m_watch = std::make_unique<ProjectWatch>(*m_project, m_lock ? ProjectWatch::Access::ReadWrite
                                                                : ProjectWatch::Access::ReadOnly);
    connect(m_watch.get(), &ProjectWatch::changedOutside, this, &Workspace::changed);
    connect(m_watch.get(), &ProjectWatch::savedChanged, this, &Workspace::savedChanged);
    connect(m_watch.get(), &ProjectWatch::lost, this, &Workspace::lost, Qt::QueuedConnection);
    connect(m_watch.get(), &ProjectWatch::overwritten, this, &Workspace::overwritten, Qt::QueuedConnection);
    m_runner = std::make_unique<JobRunner>(*m_project);
    connect(m_runner.get(), &JobRunner::progressed, this, [this](double fraction, const Message &text) {
        Q_EMIT jobProgressed(fraction, shownWords(text));
    });
    connect(m_runner.get(), &JobRunner::finished, this,
            [this](const std::shared_ptr<Job> &, const std::optional<Error> &error) {
                if (!error)
                    Q_EMIT changed();
                finishJob(error);
            });
    Q_EMIT opened();
}

Result<std::filesystem::path> Workspace::rescue()
{
    auto file = ODO_TRY(rescueProject(*m_project));
    ODO_TRY(open(file));
    return file;
}

std::optional<std::filesystem::path> Workspace::movedTo() const
{
    auto location = m_project->currentLocation();
    const bool isWhole =
        location && !files::exists(m_project->mediaFolder()) && files::isFolder(mediaFolderOf(*location));
    return isWhole ? location : std::nullopt;
}

Result<void> Workspace::reopen()
{
    const std::filesystem::path file = m_project->file();
    close();
    m_lock.reset();
    return open(file);
}

void Workspace::close()
{
    Q_EMIT aboutToClose();
    m_runner.reset();
    m_watch.reset();
    m_project.reset();
}

void Workspace::finishJob(const std::optional<Error> &error)
{
    const Done done = std::exchange(m_done, nullptr);
    if (error) {
        Q_EMIT jobFailed(*error);
        return;
    }
    Q_EMIT jobDone();
    if (done)
        done();
}

Result<void> Workspace::start(std::shared_ptr<Job> job, const Message &words, Done done)
{
    if (!m_project)
        return fail(ErrorCode::InvalidInput, words, noProjectIsOpen(),
                    ODO_TEXT("ui.open_project_first", "open or create a project first"));
    if (isBusy())
        return busy(words);
    m_done = std::move(done);
    m_runner->start(std::move(job));
    Q_EMIT jobStarted(
        shownWords(words)); // now that isBusy() says so; whatever the job reports is queued behind
    return {};
}

Result<void> Workspace::makeAndOpen(std::function<Result<std::filesystem::path>(const JobControl &)> make,
                                    const Message &words, Done whenOpen)
{
    const auto noting = [make = std::move(make)](const JobControl &control, Made &made) {
        auto file = make(control);
        if (file)
            made.written = *file;
        return file;
    };
    return begin(noting, words, std::move(whenOpen));
}

Result<void> Workspace::begin(std::function<Result<std::filesystem::path>(const JobControl &, Made &)> find,
                              const Message &words, Done whenOpen)
{
    if (isBusy())
        return busy(words);
    m_making = std::make_unique<BackgroundTask>();
    connect(m_making.get(), &BackgroundTask::progressed, this, &Workspace::jobProgressed);
    const auto made = std::make_shared<Made>();
    connect(m_making.get(), &BackgroundTask::finished, this,
            [this, made, words, whenOpen = std::move(whenOpen)](const std::optional<Error> &error) {
                Ready ready = std::move(made->ready); // and with it the lock, whatever comes
                // Asked here, not on the task's thread: what is cancelled after that has ended does not open
                // either.
                const std::optional<Error> outcome =
                    !error && m_making->isCancelled() ? cancelled(words).value() : error;
                finishJob(outcome);
                if (outcome) {
                    if (!made->damaged.empty())
                        Q_EMIT backupFound(made->damaged);
                    if (outcome->code == ErrorCode::Cancelled && !made->written.empty())
                        Q_EMIT messageReady(
                            tr("“%1” was written before you cancelled. It was not opened.")
                                .arg(QString::fromStdString(made->written.filename().string())));
                    return;
                }
                if (const Result<void> shown = show(std::move(ready)); !shown)
                    Q_EMIT jobFailed(shown.error());
                else if (whenOpen)
                    whenOpen();
            });
    m_making->start([made, openHere = openHere(),
                     find = std::move(find)](const JobControl &control) -> Result<void> {
        const std::filesystem::path file = ODO_TRY(find(control, *made));
        auto looked = makeReady(file, openHere);
        if (!looked) {
            const bool isOpenHere = !openHere.empty() && files::isSame(file, openHere);
            return tl::unexpected(isOpenHere ? looked.error() : offeringABackup(looked.error(), file, *made));
        }
        made->ready = std::move(*looked);
        return {};
    });
    Q_EMIT jobStarted(shownWords(words));
    return {};
}

/// On any thread. The advice is then not to copy files by hand.
Error Workspace::offeringABackup(Error error, const std::filesystem::path &file, Made &made)
{
    if (error.code != ErrorCode::InvalidInput)
        return error;
    const auto backup = soundBackupOf(file);
    if (!backup)
        return error;
    made.damaged = file;
    const QDateTime written = QFileInfo(QString::fromStdString(backup->string())).lastModified();
    error.advice =
        ODO_TEXT("ui.backup_is_sound", "its backup of %1 is intact; it does not contain later changes")(
            QLocale().toString(written, QLocale::ShortFormat).toStdString());
    return error;
}

Result<void> Workspace::beginRestoring(const std::filesystem::path &file, Done whenOpen)
{
    const auto restored = std::make_shared<RestoredBackup>();
    const auto make = [file, restored](const JobControl &) -> Result<std::filesystem::path> {
        const auto lock = WindowLock::take(file); // nobody opens it meanwhile
        if (!lock)
            return tl::unexpected(lock.error());
        *restored = ODO_TRY(restoreBackup(file));
        return file;
    };
    return makeAndOpen(make, restoringBackup(), [this, restored, whenOpen = std::move(whenOpen)] {
        Q_EMIT messageReady(tr("The backup was restored. The damaged file is kept as “%1”.")
                                .arg(QString::fromStdString(restored->damaged.filename().string())));
        if (whenOpen)
            whenOpen();
    });
}

Result<void> Workspace::beginGoingBack(const std::filesystem::path &backup)
{
    const Message words = restoringBackup();
    if (isBusy())
        return busy(words);
    const auto copy = std::make_shared<std::unique_ptr<ReplacingCopy>>();
    m_making = std::make_unique<BackgroundTask>();
    connect(m_making.get(), &BackgroundTask::finished, this,
            [this, copy, words](const std::optional<Error> &error) {
                const std::optional<Error> outcome =
                    !error && m_making->isCancelled() ? cancelled(words).value() : error;
                finishJob(outcome);
                if (!outcome)
                    completeRestoring(**copy);
            });
    m_making->start([copy, backup, file = m_project->file()](const JobControl &) -> Result<void> {
        *copy = ODO_TRY(prepareGoingBack(backup, file));
        return {};
    });
    Q_EMIT jobStarted(shownWords(words));
    return {};
}

void Workspace::completeRestoring(ReplacingCopy &copy)
{
    Ready ready{m_project->file(), nullptr, true};
    m_project->emptyLog(); // so the file by itself is what the project was
    close();
    const auto kept = finishGoingBack(copy, ready.file, backupTime());
    if (kept)
        ready.words = tr("The backup was restored. What the project was before is kept as “%1”.")
                          .arg(QString::fromStdString(kept->filename().string()));
    else
        Q_EMIT jobFailed(kept.error()); // all is as before
    if (const Result<void> shown = show(std::move(ready)); !shown)
        Q_EMIT jobFailed(shown.error());
}

void Workspace::backUp()
{
    const BackupPlan plan = chosenBackupPlan();
    if (!plan.isDaily)
        return;
    auto *task = new BackgroundTask(this);
    connect(task, &BackgroundTask::finished, this, [this, task](const std::optional<Error> &error) {
        if (error)
            Q_EMIT messageReady(errorLine(*error));
        task->deleteLater();
    });
    task->start([file = m_project->file(), plan](const JobControl &) -> Result<void> {
        const auto project = ODO_TRY(Project::open(file, Project::Access::ReadOnly));
        ODO_TRY(backUpIfDue(*project, plan, backupTime()));
        return {};
    });
}

void Workspace::cancel()
{
    if (m_making)
        m_making->cancel();
    if (m_runner)
        m_runner->cancel();
}

} // namespace odo
