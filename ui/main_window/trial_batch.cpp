// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/trial_batch.h"

#include "core/workflow/job.h"
#include "ui/main_window/workspace.h"
#include "ui/models/error_words.h"

namespace odo {

TrialBatch::TrialBatch(Workspace &workspace, QObject *parent) : QObject(parent), m_workspace(workspace)
{
    // Queued: the workspace is free for the next job when the signal of the last one is over.
    connect(
        &m_workspace, &Workspace::jobDone, this, [this] { goOn(nullptr); }, Qt::QueuedConnection);
    connect(
        &m_workspace, &Workspace::jobFailed, this, [this](const Error &error) { goOn(&error); },
        Qt::QueuedConnection);
    connect(&m_workspace, &Workspace::aboutToClose, this, [this] {
        m_trials.clear();
        m_job.reset();
    });
}

Result<void> TrialBatch::start(const QStringList &trials, Work work)
{
    if (m_workspace.isBusy() || isRunning())
        return fail(ErrorCode::InvalidInput, tr("many trials").toStdString(),
                    tr("another job is running").toStdString(),
                    tr("wait until it is done, or cancel it").toStdString());
    m_work = std::move(work);
    m_trials = trials;
    m_next = 0;
    m_done = 0;
    m_failures.clear();
    auto started = startNext();
    if (!started)
        m_trials.clear();
    return started;
}

Result<void> TrialBatch::startNext()
{
    const QString &trial = m_trials.at(m_next++);
    m_job = m_work.make(trial.toStdString());
    return m_workspace.start(
        m_job, m_work.words.arg(trial, QString::number(m_next), QString::number(m_trials.size())), nullptr);
}

void TrialBatch::goOn(const Error *error)
{
    if (!isRunning() || !m_job)
        return;
    const bool isCancelled = error && error->code == ErrorCode::Cancelled;
    if (error && !isCancelled) {
        m_failures << errorLine(*error);
    } else if (!error) {
        const Result<void> kept = m_work.keep ? m_work.keep(*m_workspace.project(), *m_job) : Result<void>();
        if (kept)
            ++m_done;
        else
            m_failures << errorLine(kept.error());
    }
    m_job.reset();
    if (isCancelled || m_next == m_trials.size())
        return end();
    if (const Result<void> started = startNext(); !started) {
        m_failures << errorLine(started.error());
        end();
    }
}

void TrialBatch::end()
{
    const int all = static_cast<int>(m_trials.size());
    m_trials.clear();
    Q_EMIT ended(m_done, all, m_failures);
}

} // namespace odo
