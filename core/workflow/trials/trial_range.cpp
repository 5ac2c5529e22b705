// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/trials/trial_range.h"

#include "core/analysis/range/run_range.h"
#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/track_job.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double roundingS = 0.0005; // of times as they are shown

MessageArgument seconds(Nanoseconds time)
{
    return quantity(toSeconds(time), 3, "s");
}

Message rangeSubject(const std::string &trial)
{
    return ODO_TEXT("workflow.range_of_trial", "range of trial '%1'")(Named::trial(trial));
}

Message chooseOtherRange()
{
    return ODO_TEXT("workflow.choose_other_range", "choose another range");
}

Result<TimeSpan> spanOf(const TrialRecord &trial, const RangeSeconds &given)
{
    const Message what = rangeSubject(trial.name);
    if (!(given.from < given.to))
        return fail(ErrorCode::WrongCall, what,
                    ODO_TEXT("workflow.range_is_reversed", "its start %1 is not before its end %2")(
                        quantity(given.from, 3, "s"), quantity(given.to, 3, "s")),
                    ODO_TEXT("workflow.give_start_first", "give the start first, then a later end"));
    if (given.from < 0 || given.to > trial.durationS + roundingS)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.range_outside_trial", "%1 to %2 is not within the trial's time")(
                        quantity(given.from, 3, "s"), quantity(given.to, 3, "s")),
                    ODO_TEXT("workflow.choose_range_within",
                             "choose a range from 0 to %1")(quantity(trial.durationS, 3, "s")));
    const TimeSpan span{fromSeconds(given.from), fromSeconds(std::min(given.to, trial.durationS))};
    if (span.begin < span.end)
        return span;
    return fail(ErrorCode::InvalidInput, what,
                ODO_TEXT("workflow.range_without_sample", "it contains no sample"), chooseOtherRange());
}

Result<TimeSpan> spanOfMotion(const TrialRecord &trial, const std::vector<AnalysisRecord> &analyses)
{
    const Message what = rangeSubject(trial.name);
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(), trackItFirst());
    std::optional<TimeSpan> motion;
    for (const AnalysisRecord &analysis : analyses) {
        const auto its = motionSpan(wholeRun(analysis.profile, analysis.outside));
        if (its && motion)
            motion = TimeSpan{std::min(motion->begin, its->begin), std::max(motion->end, its->end)};
        else if (its)
            motion = its;
    }
    if (motion)
        return *motion;
    return fail(ErrorCode::Undetermined, what, ODO_TEXT("workflow.no_motion", "no robot moves in it"),
                ODO_TEXT("workflow.give_range_in_seconds", "give its start and end in seconds"));
}

/// That each robot that was measured has a position in it; before the first analysis, that the first view has
/// a frame in it.
Result<void> checkHoldsSamples(Project &project, const TrialRecord &trial, const TimeSpan &range,
                               const std::vector<AnalysisRecord> &analyses)
{
    for (const AnalysisRecord &analysis : analyses) {
        Profile part = wholeRun(analysis.profile, analysis.outside);
        cutToRange(part, range);
        if (!hasValidPoint(part))
            return nothingMeasuredInRange(analysis.robotName, trial.name, range);
    }
    if (!analyses.empty())
        return {};
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    const bool hasFrame =
        recordings.empty() || std::ranges::any_of(recordings.front().frameTimes,
                                                  [&](Nanoseconds time) { return range.contains(time); });
    if (hasFrame)
        return {};
    return fail(ErrorCode::InvalidInput, rangeSubject(trial.name),
                ODO_TEXT("workflow.range_without_sample", "it contains no sample"), chooseOtherRange());
}

} // namespace

Result<std::optional<TimeSpan>> resolveRange(Project &project, const TrialRecord &trial,
                                             const RangeChoice &choice)
{
    if (trial.unfinished)
        return fail(ErrorCode::InvalidInput, rangeSubject(trial.name),
                    ODO_TEXT("workflow.copied_while_recorded", "its recording has not ended"),
                    endRecordingFirst());
    if (std::holds_alternative<WholeRun>(choice))
        return std::optional<TimeSpan>();
    // What it was given is checked before anything is read.
    const auto *given = std::get_if<RangeSeconds>(&choice);
    std::optional<TimeSpan> range;
    if (given)
        range = ODO_TRY(spanOf(trial, *given));
    const auto analyses = ODO_TRY(project.analyses().current(trial.id));
    if (!given)
        range = ODO_TRY(spanOfMotion(trial, analyses));
    ODO_TRY(checkHoldsSamples(project, trial, *range, analyses));
    return range;
}

RangeJob::RangeJob(std::string trial, RangeChoice choice) : m_trial(std::move(trial)), m_choice(choice) {}

RangeJob::~RangeJob() = default;

Result<void> RangeJob::prepare(Project &project)
{
    const auto trial = ODO_TRY(project.trials().find(m_trial));
    m_id = trial.id;
    m_range = ODO_TRY(resolveRange(project, trial, m_choice));
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
    m_isSet = trial.range == m_range &&
              std::ranges::all_of(analyses, [&](const AnalysisRecord &one) { return one.range == m_range; });
    if (m_isSet || analyses.empty())
        return {};
    TrackSettings settings;
    settings.again = true;
    settings.range = m_range;
    for (const AnalysisRecord &analysis : analyses)
        settings.robots.push_back(analysis.robotName);
    m_analysis = std::make_unique<TrackJob>(m_trial, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> RangeJob::run(const JobControl &control)
{
    return m_analysis ? m_analysis->run(control) : Result<void>();
}

Result<void> RangeJob::commit(Project &project)
{
    if (m_isSet)
        return {};
    return project.change(rangeChange(m_trial, m_choice), [&]() -> Result<void> {
        ODO_TRY(project.trials().setRange(m_id, m_range));
        return m_analysis ? m_analysis->commit(project) : Result<void>();
    });
}

Message rangeChange(const std::string &trial, const RangeChoice &choice)
{
    const MessageArgument name = Named::trial(trial);
    return std::holds_alternative<WholeRun>(choice)
               ? ODO_TEXT("workflow.clear_range", "remove the range of %1")(name)
               : ODO_TEXT("workflow.set_range", "set the range of %1")(name);
}

tl::unexpected<Error> nothingMeasuredInRange(const std::string &robot, const std::string &trial,
                                             const TimeSpan &range)
{
    return fail(ErrorCode::InvalidInput, rangeSubject(trial),
                ODO_TEXT("workflow.not_measured_in_range", "it contains no sample of robot '%1' (%2 to %3)")(
                    Named::robot(robot), seconds(range.begin), seconds(range.end)),
                chooseOtherRange());
}

} // namespace odo
