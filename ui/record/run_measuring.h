// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job_runner.h"
#include "core/workflow/live_tracking.h"
#include "ui/models/background_task.h"
#include "ui/record/run_result_card.h"

#include <QStringList>
#include <deque>
#include <memory>

namespace odo {

class Project;

/// Gets the figures of runs that have ended: at once from what was seen live, then by the ordinary tracking
/// of the recordings, one after the other, which steps back while somebody records. Lives on the project's
/// thread.
class RunMeasuring : public QObject
{
    Q_OBJECT
public:
    explicit RunMeasuring(Project &project, QObject *parent = nullptr);
    ~RunMeasuring() override;

    /// Of runs that have just ended; measuredLive() follows.
    void measureLive(const QString &trial, std::vector<LiveRun> runs, const std::optional<TaskRecord> &task);
    /// The trial is complete in the project; measured() or failed() follows. Of the run that was measured
    /// live last, only robots that were seen are looked for: one that never came must not spoil the others'
    /// figures.
    void track(const QString &trial);
    /// Tracking takes what the machine has, and recording comes first.
    void setRecording(bool recording);
    bool isIdle() const { return m_waiting.empty() && !m_jobs.isRunning() && !m_live.isRunning(); }

Q_SIGNALS:
    void measuredLive(const QString &trial, const std::vector<odo::RunResultCard::Result> &results);
    void measured(const QString &trial, const std::vector<odo::RunResultCard::Result> &results,
                  const QStringList &warnings);
    void failed(const QString &trial, const odo::Error &error);

private:
    void goOn();
    void finish(const std::optional<Error> &error);

    BackgroundTask m_live;
    JobRunner m_jobs;
    struct Waiting
    {
        QString trial;
        std::vector<std::string> robots;
    };
    Waiting m_seen;                ///< of the run that was measured live last: the robots that were seen
    std::deque<Waiting> m_waiting; ///< the first one is being tracked, if any is
    bool m_recording = false, m_stepsBack = false;
    std::shared_ptr<class TrackJob> m_job;
};

} // namespace odo
