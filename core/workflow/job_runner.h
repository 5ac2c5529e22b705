// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <thread>

namespace odo {

class Job;
class Project;

/// Runs one Job at a time for a window: prepare and commit on the runner's (the project's) thread, run on a thread of
/// its own. Signals are emitted on the runner's thread. The destructor cancels and waits.
class JobRunner : public QObject
{
    Q_OBJECT
public:
    explicit JobRunner(Project &project, QObject *parent = nullptr);
    ~JobRunner() override;

    bool isRunning() const { return m_job != nullptr; }
    /// False when another job runs. finished() is emitted in every other case.
    bool start(std::shared_ptr<Job> job);
    void cancel();

Q_SIGNALS:
    void progressed(double fraction, const QString &text);
    /// Once a job, after commit: no error on success. job is the one given to start.
    void finished(const std::shared_ptr<odo::Job> &job, const std::optional<odo::Error> &error);

private:
    void finish(const Result<void> &result);

    Project &m_project;
    std::shared_ptr<Job> m_job;
    CancelToken m_cancel;
    std::thread m_thread;
};

} // namespace odo
