// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/job_runner.h"

#include "core/workflow/call_later.h"
#include "core/workflow/job.h"


namespace odo {

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
    if (const auto prepared = m_job->prepare(m_project); !prepared) {
        // Queued, so that the caller always hears of the end after start has returned.
        callLater(this, [this, prepared] { finish(prepared); });
        return true;
    }
    JobControl control{m_cancel, [this](double fraction, const std::string &text) {
                           const QString words = QString::fromStdString(text);
                           callLater(this, [this, fraction, words] { Q_EMIT progressed(fraction, words); });
                       }};
    m_thread = std::thread([this, worker = m_job, control] {
        const Result<void> result = worker->run(control);
        callLater(this, [this, result] { finish(result); });
    });
    return true;
}

void JobRunner::cancel() { m_cancel.cancel(); }

void JobRunner::finish(const Result<void> &result)
{
    if (m_thread.joinable())
        m_thread.join();
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    const Result<void> outcome = result ? job->commit(m_project) : result;
    Q_EMIT finished(job, outcome ? std::nullopt : std::optional<Error>(outcome.error()));
}

} // namespace odo
