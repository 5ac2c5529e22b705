// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/run_measuring.h"

#include "core/workflow/track_job.h"
#include "ui/models/core_words.h"

#include <algorithm>

namespace odo {
namespace {

constexpr std::ptrdiff_t leastSightings = 10;

bool wasSeen(const LiveRun &run)
{
    return std::ranges::any_of(run.views, [](const ViewTrack &view) {
        return std::ranges::count_if(view.observations, &Observation::found) >= leastSightings;
    });
}

RunResultCard::Result resultOf(const std::string &robot, const Profile &profile)
{
    return {QString::fromStdString(robot), profile.metrics, profile.spikes.size()};
}

} // namespace

RunMeasuring::RunMeasuring(Project &project, QObject *parent) : QObject(parent), m_jobs(project)
{
    connect(&m_jobs, &JobRunner::finished, this,
            [this](const std::shared_ptr<Job> &, const std::optional<Error> &error) { finish(error); });
}

RunMeasuring::~RunMeasuring() = default;

void RunMeasuring::measureLive(const QString &trial, std::vector<LiveRun> runs,
                               const std::optional<TaskRecord> &task)
{
    m_seen = {trial, {}};
    for (const LiveRun &run : runs) {
        if (wasSeen(run))
            m_seen.robots.push_back(run.robot.name);
    }
    const auto results = std::make_shared<std::vector<RunResultCard::Result>>();
    const auto answered = std::make_shared<QMetaObject::Connection>();
    *answered = connect(&m_live, &BackgroundTask::finished, this, [this, trial, results, answered] {
        disconnect(*answered);
        if (!results->empty()) // else the recording may tell more
            Q_EMIT measuredLive(trial, *results);
    });
    const bool started =
        m_live.start([runs = std::move(runs), task, results](const JobControl &) -> Result<void> {
            for (const LiveRun &run : runs) {
                if (const auto analysis = analyseRun(run, {}, task))
                    results->push_back(resultOf(run.robot.name, analysis->profile));
            }
            return {};
        });
    if (!started)
        disconnect(*answered);
}

void RunMeasuring::track(const QString &trial)
{
    m_waiting.push_back(m_seen.trial == trial ? m_seen : Waiting{trial, {}});
    goOn();
}

void RunMeasuring::setRecording(bool recording)
{
    m_recording = recording;
    if (m_recording && m_jobs.isRunning()) {
        m_stepsBack = true;
        m_jobs.cancel();
    }
    goOn();
}

void RunMeasuring::goOn()
{
    if (m_recording || m_waiting.empty() || m_jobs.isRunning())
        return;
    TrackSettings settings;
    settings.robots = m_waiting.front().robots;
    m_job = std::make_shared<TrackJob>(m_waiting.front().trial.toStdString(), std::move(settings));
    m_jobs.start(m_job);
}

void RunMeasuring::finish(const std::optional<Error> &error)
{
    const std::shared_ptr<TrackJob> job = std::move(m_job);
    if (std::exchange(m_stepsBack, false) && error && error->code == ErrorCode::Cancelled)
        return goOn(); // it is still the first that waits
    const QString trial = m_waiting.front().trial;
    m_waiting.pop_front();
    if (error) {
        Q_EMIT failed(trial, *error);
    } else {
        std::vector<RunResultCard::Result> results;
        for (const TrackedRobot &robot : job->outcome().robots)
            results.push_back(resultOf(robot.name, robot.analysis.profile));
        QStringList warnings;
        for (const std::string &warning : job->outcome().warnings)
            warnings << shownWords(warning);
        Q_EMIT measured(trial, results, warnings);
    }
    goOn();
}

} // namespace odo
