// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>
#include <QStringList>
#include <functional>
#include <memory>

namespace odo {

class Job;
class Project;
class Workspace;

/// The same work on many trials, one after the other, with progress and cancel where every job has them. A
/// trial that fails is told at the end, and the next one begins; what was done before a cancel stays. GUI
/// thread.
class TrialBatch : public QObject
{
    Q_OBJECT
public:
    /// What is done with one trial.
    struct Work
    {
        QString words; ///< "Exporting %1 (%2 of %3)"
        std::function<std::shared_ptr<Job>(const std::string &trial)> make;
        std::function<Result<void>(Project &, Job &)> keep; ///< after each; may be empty
    };

    TrialBatch(Workspace &workspace, QObject *parent);
    bool isRunning() const { return !m_trials.isEmpty(); }
    /// Refused while another job runs.
    Result<void> start(const QStringList &trials, Work work);

Q_SIGNALS:
    /// done: of all; failures: a sentence each, empty when all went well.
    void ended(int done, int all, const QStringList &failures);

private:
    Result<void> startNext();
    void end();
    void goOn(const Error *error);

    Workspace &m_workspace;
    Work m_work;
    QStringList m_trials; ///< empty: nothing runs
    std::shared_ptr<Job> m_job;
    qsizetype m_next = 0;
    int m_done = 0;
    QStringList m_failures;
};

} // namespace odo
