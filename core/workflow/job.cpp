// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/job.h"

#include "core/base/job_control.h"
#include "core/base/shortage.h"

namespace odo {

Result<void> runToEnd(Job &job, Project &project, const JobControl &control)
{
    return orShortage(cannotDoThis(), [&]() -> Result<void> {
        ODO_TRY(job.prepare(project));
        {
            const CancelScope scope(&control.cancel);
            ODO_TRY(job.run(control));
        }
        return job.commit(project);
    });
}

JobRunner::JobRunner(Project &project, QObject *parent) : QObject(parent), m_project(project) {}

JobRunner::~JobRunner()
{
    m_cancel.cancel();
    if (m_thread.joinable())
        m_thread.join();
}

bool JobRunner::start(std::shared_ptr<Job> job)
{
    if (m_job)
        return false;
    if (m_thread.joinable())
        m_thread.join();
    m_job = std::move(job);
    m_cancel = CancelToken();
    // Queued, so that the caller always hears of the end after start has returned.
    const auto finishLater = [this](const Result<void> &result) {
        callLater(this, [this, result] { finish(result); });
    };
    if (const auto prepared = orShortage(cannotDoThis(), [this] { return m_job->prepare(m_project); });
        !prepared) {
        finishLater(prepared);
        return true;
    }
    JobControl control{m_cancel, [this](double fraction, const Message &text) {
                           callLater(this, [this, fraction, text] { Q_EMIT progressed(fraction, text); });
                       }};
    auto thread = startThread(cannotDoThis(), [worker = m_job, control, finishLater] {
        finishLater(orShortage(cannotDoThis(), [&] {
            const CancelScope scope(&control.cancel);
            return worker->run(control);
        }));
    });
    if (thread)
        m_thread = std::move(*thread);
    else
        finishLater(tl::unexpected(thread.error()));
    return true;
}

void JobRunner::cancel()
{
    m_cancel.cancel();
}

void JobRunner::finish(const Result<void> &result)
{
    if (m_thread.joinable())
        m_thread.join();
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    const Result<void> outcome =
        result ? orShortage(cannotDoThis(), [&] { return job->commit(m_project); }) : result;
    Q_EMIT finished(job, outcome ? std::nullopt : std::optional<Error>(outcome.error()));
}

} // namespace odo
