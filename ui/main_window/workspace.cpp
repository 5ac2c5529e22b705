// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/workspace.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/window_lock.h"
#include "core/workflow/hash_job.h"
#include "core/workflow/job.h"
#include "core/workflow/job_runner.h"
#include "core/workflow/recover_job.h"
#include "ui/models/background_task.h"

#include <algorithm>

namespace odo {
namespace {

tl::unexpected<Error> busy(const QString &what)
{
    return fail(ErrorCode::InvalidInput, what.toStdString(),
                Workspace::tr("another job is running").toStdString(),
                Workspace::tr("wait until it is done, or cancel it").toStdString());
}

} // namespace

Workspace::Workspace(QObject *parent) : QObject(parent) {}

Workspace::~Workspace() = default;

bool Workspace::isBusy() const
{
    return (m_runner && m_runner->isRunning()) || (m_making && m_making->isRunning());
}

Result<void> Workspace::open(const std::filesystem::path &file)
{
    if (isBusy())
        return busy(tr("cannot open another project"));
    auto opened = openFile(file);
    if (!opened)
        return tl::unexpected(opened.error());
    const QString words = opened->words;
    adopt(std::move(*opened));
    if (!words.isEmpty())
        Q_EMIT told(words);
    if (!isReadOnly())
        recoverTrials();
    return {};
}

Result<Workspace::Opened> Workspace::openFile(const std::filesystem::path &file)
{
    Opened opened;
    auto project = Project::open(file, Project::Access::ReadWrite);
    const bool isWritable = project || project.error().code != ErrorCode::ReadOnly;
    if (isWritable && !project)
        return tl::unexpected(project.error());
    if (isWritable) {
        std::error_code problem;
        const bool isThisOne = m_lock && std::filesystem::equivalent(file, m_project->file(), problem);
        auto lock = isThisOne ? std::move(m_lock) : WindowLock::take(file);
        if (lock)
            opened.lock = std::move(*lock);
        else
            opened.words =
                tr("%1: %2. Here it can only be looked at; to change it, close it there and open it here "
                   "again.")
                    .arg(QString::fromStdString(lock.error().what), QString::fromStdString(lock.error().why));
    }
    if (!opened.lock)
        project = Project::open(file, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    opened.project = std::move(*project);
    return opened;
}

void Workspace::recoverTrials()
{
    const auto trials = m_project->trials().names();
    if (!trials || std::ranges::none_of(*trials, &TrialName::unfinished))
        return makeHashes();
    const auto job = std::make_shared<RecoverJob>();
    const Result<void> started = start(job, tr("Completing a recording that was cut off"), [this, job] {
        QStringList words;
        for (const std::string &sentence : job->told())
            words << QString::fromStdString(sentence);
        if (!words.isEmpty())
            Q_EMIT told(words.join(u'\n'));
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
            start(std::make_shared<HashJob>(), tr("Making the hashes of new recordings"), nullptr);
        !started)
        Q_EMIT jobFailed(started.error());
}

Result<void> Workspace::create(const std::filesystem::path &file, const QString &title)
{
    if (isBusy())
        return busy(tr("cannot make another project"));
    Result<std::unique_ptr<Project>> project = Project::create(file, title.toStdString());
    if (!project)
        return tl::unexpected(project.error());
    auto lock = WindowLock::take(file);
    if (!lock)
        return tl::unexpected(lock.error());
    adopt({std::move(*lock), std::move(*project), {}});
    return {};
}

void Workspace::adopt(Opened next)
{
    Q_EMIT aboutToClose();
    m_runner.reset();
    m_project = std::move(next.project);
    m_lock = std::move(next.lock);
    m_runner = std::make_unique<JobRunner>(*m_project);
    connect(m_runner.get(), &JobRunner::progressed, this, &Workspace::jobProgressed);
    connect(m_runner.get(), &JobRunner::finished, this,
            [this](const std::shared_ptr<Job> &, const std::optional<Error> &error) { finishJob(error); });
    Q_EMIT opened();
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

Result<void> Workspace::start(std::shared_ptr<Job> job, const QString &words, Done done)
{
    if (!m_project)
        return fail(ErrorCode::InvalidInput, words.toStdString(), tr("no project is open").toStdString(),
                    tr("open or make a project first").toStdString());
    if (isBusy())
        return busy(words);
    m_done = std::move(done);
    m_runner->start(std::move(job));
    Q_EMIT jobStarted(words); // now that isBusy() says so; whatever the job reports is queued behind
    return {};
}

Result<void> Workspace::makeAndOpen(std::function<Result<std::filesystem::path>(const JobControl &)> make,
                                    const QString &words, Done whenOpen)
{
    if (isBusy())
        return busy(words);
    m_making = std::make_unique<BackgroundTask>();
    connect(m_making.get(), &BackgroundTask::progressed, this, &Workspace::jobProgressed);
    const auto file = std::make_shared<std::filesystem::path>();
    connect(m_making.get(), &BackgroundTask::finished, this,
            [this, file, whenOpen = std::move(whenOpen)](const std::optional<Error> &error) {
                finishJob(error);
                if (error)
                    return;
                if (const Result<void> isOpen = open(*file); !isOpen)
                    Q_EMIT jobFailed(isOpen.error());
                else if (whenOpen)
                    whenOpen();
            });
    m_making->start([file, make = std::move(make)](const JobControl &control) -> Result<void> {
        const Result<std::filesystem::path> made = make(control);
        if (!made)
            return tl::unexpected(made.error());
        *file = *made;
        return {};
    });
    Q_EMIT jobStarted(words);
    return {};
}

void Workspace::cancel()
{
    if (m_making)
        m_making->cancel();
    if (m_runner)
        m_runner->cancel();
}

} // namespace odo
