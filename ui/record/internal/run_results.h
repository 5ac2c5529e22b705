// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/project/verdict_repository.h"
#include "core/workflow/job.h"
#include "core/workflow/record/live_tracking.h"
#include "ui/models/background_task.h"
#include "ui/views/widgets/card.h"

#include <QList>
#include <QStringList>
#include <deque>
#include <memory>
#include <vector>

class QLabel;
class QPushButton;

namespace odo {

class MetricGrid;
class Project;
class TrackJob;

/// What a run gave, as soon as it has ended: first from what was seen live, then from the recording itself.
class RunResultCard : public Card
{
    Q_OBJECT
public:
    explicit RunResultCard(QWidget *parent = nullptr);

    /// The metrics of one robot's run.
    struct Result
    {
        QString robot;
        std::vector<Metric> metrics;
        std::size_t spikes = 0;
    };
    void setWorking(const QString &trial);
    /// From live tracking, as long as there is no better.
    void setLiveResults(const QString &trial, const std::vector<Result> &results);
    /// From every frame of the recording, with the verdict on them.
    void setFinalResults(const QString &trial, const std::vector<Result> &results,
                         const TrialVerdict &verdict);
    /// No metrics, and why.
    void setFailure(const QString &trial, const QString &words);

    QString words() const;
    QString trial() const { return m_trial; }

Q_SIGNALS:
    void openRequested(const QString &trial);

private:
    void showMetrics(const QString &trial, const std::vector<Result> &results);

    QString m_trial;
    MetricGrid *m_grid;
    QLabel *m_words;
    QPushButton *m_open;
};

/// Gets the metrics of runs that have ended: at once from live tracking, then by ordinary tracking of the
/// recordings, one after the other; this yields while somebody records. Lives on the project's thread.
class RunMeasuring : public QObject
{
    Q_OBJECT
public:
    explicit RunMeasuring(Project &project, QObject *parent = nullptr);
    ~RunMeasuring() override;

    /// Of runs that have just ended; measuredLive() follows.
    void measureLive(const QString &trial, std::vector<LiveRun> runs, const std::optional<TaskRecord> &task);
    /// The trial is complete in the project; measured() or failed() follows. Of the last run measured live,
    /// only robots that were seen are tracked: one that never came must not spoil the others' metrics.
    void track(const QString &trial);
    /// Tracking takes what the machine has, and recording comes first.
    void setRecording(bool recording);
    bool isIdle() const { return m_waiting.empty() && !m_jobs.isRunning() && !m_live.isRunning(); }

Q_SIGNALS:
    void measuredLive(const QString &trial, const std::vector<odo::RunResultCard::Result> &results);
    void measured(const QString &trial, const std::vector<odo::RunResultCard::Result> &results,
                  const odo::TrialVerdict &verdict, const std::vector<odo::Message> &warnings);
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
    std::shared_ptr<TrackJob> m_job;
};

/// Has runs measured when they have ended, shows the metrics of the last one on its card, and reports each in
/// sentences. Lives on the project's thread; the card must outlive it.
class RunResults : public QObject
{
    Q_OBJECT
public:
    RunResults(Project &project, RunResultCard &card, QObject *parent = nullptr);

    /// A run has ended, as it was seen live; its recording is being completed.
    void takeEnded(const QString &trial, std::vector<LiveRun> runs, const std::optional<TaskRecord> &task);
    /// The recording is complete in the project.
    void takeRecorded(const QString &trial, const std::vector<Message> &warnings);
    /// There is no recording, and why.
    void takeGivenUp(const QString &trial, const Error &error);
    /// While somebody records, nothing is measured.
    void setRecording(bool recording) { m_measuring->setRecording(recording); }

Q_SIGNALS:
    /// The project has a new trial, or new metrics of one. The words contain the warnings.
    void changed(const QString &words, const std::vector<odo::Message> &warnings);
    /// Those on the card now.
    void shown(const std::vector<odo::RunResultCard::Result> &results);
    void failed(const odo::Error &error);

private:
    /// Another run may have ended since; then the card is about that one.
    bool isShown(const QString &trial) const { return m_card.trial() == trial; }
    void showFailure(const QString &trial, const QString &words);

    RunMeasuring *m_measuring;
    RunResultCard &m_card;
};

} // namespace odo
