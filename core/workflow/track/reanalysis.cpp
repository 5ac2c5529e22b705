// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/reanalysis.h"

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"
#include "core/trajectory/analyser.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/track_job.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odo {

namespace {

Result<AnalysisRecord> chosenAnalysis(const std::vector<AnalysisRecord> &analyses,
                                      const OverrideRequest &request)
{
    const Message what = trialSubject(request.trial);
    std::vector<std::string> names;
    for (const AnalysisRecord &analysis : analyses) {
        if (analysis.robotName == request.robot || (request.robot.empty() && analyses.size() == 1))
            return analysis;
        names.push_back(analysis.robotName);
    }
    if (analyses.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(),
                    ODO_TEXT("workflow.run_track_first", "run odograph track first"));
    if (request.robot.empty())
        return fail(ErrorCode::Undetermined, what, severalRobots(names),
                    ODO_TEXT("workflow.choose_with_robot", "choose one with --robot"));
    return fail(ErrorCode::NotFound, what, robotNotTracked(request.robot, names),
                ODO_TEXT("workflow.track_or_choose_with_robot", "track it, or choose another with --robot"));
}

/// The sample as the request named it.
Message sampleSubject(const OverrideRequest &request)
{
    const MessageArgument trial = Named::trial(request.trial);
    return request.frame
               ? ODO_TEXT("workflow.frame_of_trial", "frame %1 of trial '%2'")(*request.frame, trial)
               : ODO_TEXT("workflow.time_of_trial",
                          "%1 of trial '%2'")(quantity(request.timeS.value_or(0), 3, "s"), trial);
}

Result<Sample> chosenSample(const std::vector<Sample> &samples, const OverrideRequest &request)
{
    const Message what = sampleSubject(request);
    if (samples.empty())
        return fail(ErrorCode::NotFound, what, ODO_TEXT("workflow.no_sample", "the analysis has no sample"),
                    trackTrialAgain());
    const auto distance = [&](const Sample &sample) {
        return request.frame ? std::abs(static_cast<double>(sample.frame - *request.frame))
                             : std::abs(toSeconds(sample.time) - *request.timeS);
    };
    const auto nearest =
        std::min_element(samples.begin(), samples.end(),
                         [&](const Sample &a, const Sample &b) { return distance(a) < distance(b); });
    const double interval = toSeconds(samples.back().time - samples.front().time) /
                            static_cast<double>(std::max<std::size_t>(samples.size() - 1, 1));
    if (distance(*nearest) > (request.frame ? 0 : interval))
        return fail(ErrorCode::NotFound, what, noSuchFrame(),
                    request.frame ? chooseFrame(samples.front().frame, samples.back().frame)
                                  : ODO_TEXT("workflow.choose_time", "choose a time from %1 to %2")(
                                        quantity(toSeconds(samples.front().time), 3, "s"),
                                        quantity(toSeconds(samples.back().time), 3, "s")));
    if (!nearest->position && request.word != OverrideRequest::Word::Clear)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.not_measured_there", "the robot has no measurement at that time"),
                    ODO_TEXT("workflow.choose_measured_frame", "choose a frame with a measurement"));
    return *nearest;
}

/// The samples that a request means, in order of time.
Result<std::vector<Sample>> chosenSamples(const std::vector<Sample> &samples, const OverrideRequest &request)
{
    std::vector<Sample> chosen;
    for (const std::int64_t frame : request.frames) {
        OverrideRequest one = request;
        one.frame = frame;
        chosen.push_back(ODO_TRY(chosenSample(samples, one)));
    }
    if (request.group) {
        const SampleGroup &group = *request.group;
        std::ranges::copy_if(samples, std::back_inserter(chosen), [&](const Sample &sample) {
            const double timeS = toSeconds(sample.time);
            return timeS >= group.fromS && timeS <= group.toS && isChangedBy(request.word, sample) &&
                   (group.reasons == 0 || (sample.flags & group.reasons) != 0);
        });
        if (chosen.empty())
            return fail(ErrorCode::NotFound, trialSubject(request.trial),
                        ODO_TEXT("workflow.no_sample_in_group", "no sample from %1 to %2 is to be changed")(
                            quantity(group.fromS, 3, "s"), quantity(group.toS, 3, "s")),
                        ODO_TEXT("workflow.choose_other_group", "choose other times or another reason"));
    }
    if (chosen.empty())
        chosen.push_back(ODO_TRY(chosenSample(samples, request)));
    std::ranges::sort(chosen, {}, &Sample::frame);
    return chosen;
}

} // namespace

bool isChangedBy(OverrideRequest::Word word, const Sample &sample)
{
    if (word == OverrideRequest::Word::Clear)
        return hasFlag(sample.flags, SampleFlag::ByHand);
    return sample.position && isRejected(sample.flags) == (word == OverrideRequest::Word::Valid);
}

OverrideJob::OverrideJob(OverrideRequest request) : m_request(std::move(request)) {}

OverrideJob::~OverrideJob() = default;

Result<void> OverrideJob::prepare(Project &project)
{
    const auto trial = ODO_TRY(project.trials().find(m_request.trial));
    const auto analyses = ODO_TRY(project.analyses().current(trial.id));
    const auto analysis = ODO_TRY(chosenAnalysis(analyses, m_request));
    const Profile whole = wholeRun(analysis.profile, analysis.outside);
    const auto samples = ODO_TRY(chosenSamples(whole.samples, m_request));
    m_before = ODO_TRY(project.trials().overrides(trial.id, analysis.robot));
    m_trial = trial.id;
    m_robot = analysis.robot;
    m_outcome.robot = analysis.robotName;
    m_outcome.count = samples.size();
    m_outcome.frame = samples.front().frame;
    m_outcome.time = samples.front().time;
    m_overrides = m_before;
    for (const Sample &sample : samples)
        m_overrides = m_request.word == OverrideRequest::Word::Clear
                          ? withoutOverride(std::move(m_overrides), sample.frame)
                          : withOverride(std::move(m_overrides),
                                         {sample.frame, m_request.word == OverrideRequest::Word::Spike});
    if (m_request.word == OverrideRequest::Word::Clear && m_overrides.size() == m_before.size())
        return fail(ErrorCode::NotFound, sampleSubject(m_request),
                    ODO_TEXT("workflow.nothing_said_there", "that frame has no manual override"),
                    ODO_TEXT("workflow.see_flags_by_hand", "see the flags by_hand in odograph export"));
    TrackSettings settings;
    settings.robots = {m_outcome.robot};
    settings.again = true;
    settings.overrides[m_outcome.robot] = m_overrides;
    m_analysis = std::make_unique<TrackJob>(m_request.trial, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> OverrideJob::run(const JobControl &control)
{
    return m_analysis->run(control);
}

namespace {

Message groupWords(OverrideRequest::Word word, std::size_t count, const MessageArgument &trial)
{
    switch (word) {
    case OverrideRequest::Word::Spike:
        return ODO_TEXT("workflow.mark_spikes", "mark %1 samples of %2 as spikes")(count, trial);
    case OverrideRequest::Word::Valid:
        return ODO_TEXT("workflow.use_frames", "use %1 samples of %2")(count, trial);
    case OverrideRequest::Word::Clear:
        break;
    }
    return ODO_TEXT("workflow.leave_frames", "remove the overrides of %1 samples of %2")(count, trial);
}

} // namespace

Result<void> OverrideJob::commit(Project &project)
{
    const auto words = [this] {
        const MessageArgument trial = Named::trial(m_request.trial);
        if (m_outcome.count > 1)
            return groupWords(m_request.word, m_outcome.count, trial);
        switch (m_request.word) {
        case OverrideRequest::Word::Spike:
            return ODO_TEXT("workflow.mark_spike", "mark frame %1 of %2 as a spike")(m_outcome.frame, trial);
        case OverrideRequest::Word::Valid:
            return ODO_TEXT("workflow.use_frame", "use frame %1 of %2")(m_outcome.frame, trial);
        case OverrideRequest::Word::Clear:
            break;
        }
        return ODO_TEXT("workflow.leave_frame", "remove the override of frame %1 of %2")(m_outcome.frame,
                                                                                         trial);
    };
    auto stored = project.change(words(), [&]() -> Result<void> {
        const auto now = ODO_TRY(project.trials().overrides(m_trial, m_robot));
        if (now != m_before)
            return fail(ErrorCode::InvalidInput, sampleSubject(m_request),
                        ODO_TEXT("workflow.other_sample_judged",
                                 "another sample was overridden while this one was analysed"),
                        ODO_TEXT("workflow.say_it_again", "repeat it for frame %1")(m_outcome.frame));
        ODO_TRY(project.trials().setManualOverrides(m_trial, m_robot, m_overrides));
        return m_analysis->commit(project);
    });
    if (!stored)
        return stored;
    m_outcome.analysis = m_analysis->outcome().robots.front().analysis;
    const AnalysisRecord &made = m_outcome.analysis;
    for (const Profile *part : {&made.outside.before, &made.profile, &made.outside.after})
        for (const Sample &sample : part->samples)
            if (sample.frame == m_outcome.frame)
                m_outcome.flags = sample.flags;
    return {};
}

namespace {

void comparePositions(const Profile &before, const Profile &after, ProfileChange &change)
{
    std::map<std::int64_t, std::size_t> byFrame;
    for (std::size_t i = 0; i < before.samples.size(); ++i)
        byFrame[before.samples[i].frame] = i;
    double squares = 0;
    for (std::size_t i = 0; i < after.samples.size(); ++i) {
        const auto same = byFrame.find(after.samples[i].frame);
        if (same == byFrame.end() || !before.points[same->second].valid || !after.points[i].valid)
            continue;
        const double shiftM = (after.points[i].position - before.points[same->second].position).norm();
        ++change.compared;
        squares += shiftM * shiftM;
        if (shiftM > change.largestShiftM) {
            change.largestShiftM = shiftM;
            change.largestAt = after.samples[i].time;
        }
    }
    if (change.compared > 0)
        change.rmsShiftM = std::sqrt(squares / static_cast<double>(change.compared));
}

void compareMetrics(const Profile &before, const Profile &after, ProfileChange &change)
{
    const auto find = [](const Profile &profile, const std::string &name) {
        const auto found = std::ranges::find(profile.metrics, name, &Metric::name);
        return found == profile.metrics.end() ? nullptr : &*found;
    };
    for (const Metric &metric : before.metrics) {
        const Metric *later = find(after, metric.name);
        change.metrics.push_back({metric.name, metric.unit, metric.value,
                                  later ? std::optional(later->value) : std::nullopt,
                                  later && later->sigma ? later->sigma : metric.sigma});
    }
    for (const Metric &metric : after.metrics)
        if (!find(before, metric.name))
            change.metrics.push_back({metric.name, metric.unit, std::nullopt, metric.value, metric.sigma});
}

Message wordsOf(const ProfileChange &change)
{
    if (change.compared == 0)
        return ODO_TEXT("workflow.no_common_place", "The two analyses have no position in common.");
    const Message shift =
        ODO_TEXT("workflow.positions_change", "Positions change by %1 RMS, at most by %2 (at %3).")(
            quantity(toMillimetres(change.rmsShiftM), 1, "mm"),
            quantity(toMillimetres(change.largestShiftM), 1, "mm"),
            quantity(toSeconds(change.largestAt), 2, "s"));
    if (change.spikesBefore == change.spikesAfter)
        return shift;
    return joined({shift, ODO_TEXT("workflow.spikes_change",
                                   "Spikes: %1 instead of %2.")(change.spikesAfter, change.spikesBefore)},
                  Join::Space);
}

} // namespace

ProfileChange changeBetween(const Profile &before, const Profile &after)
{
    ProfileChange change;
    change.spikesBefore = before.spikes.size();
    change.spikesAfter = after.spikes.size();
    comparePositions(before, after, change);
    compareMetrics(before, after, change);
    change.words = wordsOf(change);
    return change;
}

ReprocessJob::ReprocessJob(std::string trial) : m_trial(std::move(trial)) {}

ReprocessJob::~ReprocessJob() = default;

Result<void> ReprocessJob::prepare(Project &project)
{
    const auto trial = ODO_TRY(project.trials().find(m_trial));
    auto analyses = ODO_TRY(project.analyses().current(trial.id));
    if (analyses.empty())
        return fail(ErrorCode::NotFound, trialSubject(m_trial), nothingToAnalyseAgain(), trackItFirst());
    TrackSettings settings;
    settings.again = true;
    for (AnalysisRecord &analysis : analyses) {
        settings.robots.push_back(analysis.robotName);
        m_before.emplace_back(analysis.robotName, std::move(analysis.profile));
    }
    m_analysis = std::make_unique<TrackJob>(m_trial, std::move(settings));
    return m_analysis->prepare(project);
}

Result<void> ReprocessJob::run(const JobControl &control)
{
    ODO_TRY(m_analysis->run(control));
    if (control.isCancelled())
        return cancelled(trialSubject(m_trial));
    const auto &after = m_analysis->outcome().robots;
    for (std::size_t i = 0; i < m_before.size(); ++i)
        m_robots.push_back({m_before[i].first, changeBetween(m_before[i].second, after[i].analysis.profile)});
    return {};
}

Result<void> ReprocessJob::commit(Project &)
{
    return {};
}

Result<void> ReprocessJob::keep(Project &project)
{
    return m_analysis->commit(project);
}

} // namespace odo
