// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/synchronise_job.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/track_job.h"

#include <algorithm>

namespace odo {

namespace {

/// "B 0.1200 s later, C not synchronised"
MessageArgument stepsText(const std::vector<RegisteredView> &views)
{
    std::vector<Message> parts;
    for (const RegisteredView &view : views) {
        const RecordingRecord &recording = view.recording;
        if (recording.position == 0)
            continue;
        const MessageArgument name = Named::camera(recording.cameraName);
        if (isStepMeasured(recording) || recording.syncMethod == "told")
            parts.push_back(ODO_TEXT("workflow.view_begun_later",
                                     "%1 %2 later")(name, quantity(recording.startOffsetS, 4, "s")));
        else
            parts.push_back(ODO_TEXT("workflow.view_not_synchronised", "%1 not synchronised")(name));
    }
    return joined(std::move(parts), Join::Comma);
}

tl::unexpected<Error> cannotBeSynchronised(const std::string &trial, Message why)
{
    return fail(ErrorCode::InvalidInput, trialSubject(trial), std::move(why),
                ODO_TEXT("workflow.choose_trial_of_views", "choose a trial of two views or more"));
}

} // namespace

SynchroniseJob::SynchroniseJob(std::string trial, std::vector<ViewStep> steps)
    : m_request{std::move(trial), std::move(steps), SyncRequest::Otherwise::Fail}
{
}

SynchroniseJob::~SynchroniseJob() = default;

Result<void> SynchroniseJob::prepare(Project &project)
{
    m_trial = ODO_TRY(project.trials().find(m_request.trial));
    m_request.trial = m_trial.name;
    if (m_trial.unfinished)
        return cannotBeSynchronised(m_trial.name,
                                    ODO_TEXT("workflow.is_being_recorded", "it is being recorded"));
    if (m_trial.viewCount < 2)
        return cannotBeSynchronised(m_trial.name,
                                    ODO_TEXT("workflow.has_no_two_views", "it does not have two views"));
    m_request.steps = ODO_TRY(
        stepsFor(trialSubject(m_trial.name), std::size_t(m_trial.viewCount), std::move(m_request.steps)));
    m_views = ODO_TRY(registeredViews(project, m_trial));
    m_before = m_views;
    m_request.microphones = ODO_TRY(microphonePositions(project, m_views));
    if (auto robots = robotsToTrack(project, m_trial, {}))
        m_request.robots = std::move(*robots);
    return prepareAnalysis(project);
}

Result<void> SynchroniseJob::prepareAnalysis(Project &project)
{
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(m_trial.id));
    const auto pointedOut = ODO_TRY(project.trials().pointedOut(m_trial.id));
    const auto guidance = ODO_TRY(project.guidance().of(m_trial.id));
    m_request.mayTakeFields = analyses.empty() && pointedOut.empty() && !haveFrames(guidance);
    if (analyses.empty())
        return {};
    TrackSettings settings;
    settings.again = true;
    for (const AnalysisRecord &analysis : analyses)
        settings.robots.push_back(analysis.robotName);
    m_analysis = std::make_unique<TrackJob>(m_trial.name, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> SynchroniseJob::run(const JobControl &control)
{
    constexpr double synchronising = 0.9; // as a part of the work
    if (isAnythingSought(m_request))
        ODO_TRY(checkRecordings(m_views, control));
    m_warnings = ODO_TRY(synchroniseViews(m_views, m_request, m_trial, partOf(control, 0, synchronising)));
    std::ranges::move(ODO_TRY(commonTimeWarnings(trialSubject(m_trial.name), recordings())),
                      std::back_inserter(m_warnings));
    if (!m_analysis)
        return {};
    m_analysis->synchroniseAs(recordings());
    ODO_TRY(m_analysis->run(partOf(control, synchronising, 1)));
    if (control.isCancelled())
        return cancelled(trialSubject(m_trial.name));
    std::ranges::copy(m_analysis->outcome().warnings, std::back_inserter(m_warnings));
    return {};
}

Result<void> SynchroniseJob::commit(Project &project)
{
    const Message words = ODO_TEXT("workflow.synchronise_trial", "synchronise %1: %2 (before: %3)")(
        Named::trial(m_trial.name), stepsText(m_views), stepsText(m_before));
    return project.change(words, [&]() -> Result<void> {
        ODO_TRY(project.trials().setSync(m_trial, recordings()));
        ODO_TRY(project.trials().setFrameTimes(retimedRecordings(m_before, m_views)));
        return m_analysis ? m_analysis->commit(project) : Result<void>();
    });
}

std::vector<RecordingRecord> SynchroniseJob::recordings() const
{
    return recordingsOf(m_views);
}

} // namespace odo
