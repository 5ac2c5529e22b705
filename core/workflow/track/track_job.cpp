// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/track_job.h"

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/tracking/colour_tracker.h"
#include "core/trajectory/imported_track.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/internal/robot_pointers.h"
#include "core/workflow/track/registered_scene.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/stored_verdicts.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/track/trial_occlusions.h"
#include "core/workflow/track/view_synchronisation.h"
#include "core/workflow/track/view_tracking.h"
#include "core/workflow/trial_sources.h"
#include "core/workflow/trials/trial_range.h"
#include "core/workflow/turned_recordings.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace odo {

namespace {

constexpr double leastOfFloorColour = 0.25; // of the frames; what is used in fewer may as well be the floor

double usedShare(const Profile &profile)
{
    return double(std::ranges::count_if(profile.samples, isUsed)) /
           double(std::max<std::size_t>(1, profile.samples.size()));
}

} // namespace

struct TrackJob::Impl
{
    std::string trialName;
    TrackSettings settings;

    TrialRecord trial;
    std::optional<TaskRecord> task; ///< of the trial
    std::vector<RobotRecord> robots;
    std::vector<RegisteredView> views;

    std::optional<SyncRequest> sync; ///< where an offset is open

    std::vector<AnalysisOptions> options; ///< one a robot
    std::vector<PointedOutRobot> pointedOut;
    EditedGuidance guidance;
    std::vector<TrackedView> stored;           ///< with `again`
    std::vector<std::vector<Sample>> imported; ///< with `again` of imported tracks, one a robot
    std::vector<ObservationSeries> observations;
    bool isNew = false;                   ///< nothing was ever measured of the trial
    std::vector<RecordingRecord> retimed; ///< recordings whose frame times were corrected
    std::vector<StoredRobot> others;      ///< of the trial, which are not tracked now
    /// of each robot; with `again` those of its newest analysis
    std::vector<std::vector<AmbiguousName>> ambiguities;
    TrackOutcome outcome;

    bool mayRecount() const { return pointedOut.empty() && !haveFrames(guidance.all); } ///< the frames
    Result<void> readOptions(Project &project);
    Result<void> takeImported(Project &project);
    Result<void> prepareSync(Project &project);
    Result<SettledViews> trackAll(const JobControl &control);
    Result<SettledViews> trackSynchronised(const JobControl &control);
    void correctByHand(std::vector<TrackedView> &tracked);
    Result<void> analyseAll(std::vector<TrackedView> &tracked);
    Result<TaskAnalysis> analyseOne(std::vector<TrackedView> &tracked, std::size_t robot,
                                    const std::optional<TimeSpan> &range = {}) const;
    Result<void> keepRegistrations(Project &project);
    void findOcclusionsIn(const std::vector<TrackedView> &tracked);
    Result<void> measureRange(AnalysisRecord &analysis, std::vector<TrackedView> &tracked,
                              std::size_t robot) const;
    Result<void> cutToRange();
    void addOutcome(AnalysisRecord analysis);
    Result<void> storeAnalyses(Project &project);
};

TrackJob::TrackJob(std::string trial, TrackSettings settings) : m_impl(std::make_unique<Impl>())
{
    m_impl->trialName = std::move(trial);
    m_impl->settings = std::move(settings);
}

TrackJob::~TrackJob() = default;

Result<void> TrackJob::prepare(Project &project)
{
    Impl &d = *m_impl;
    auto trial = ODO_TRY(project.trials().find(d.trialName));
    d.trial = trial;
    if (d.settings.range)
        d.trial.range = *d.settings.range;
    if (!d.trial.task.empty()) {
        auto task = ODO_TRY(project.tasks().find(d.trial.task));
        d.task = std::move(task);
    }
    auto robots = ODO_TRY(robotsToTrack(project, d.trial, d.settings.robots));
    d.robots = std::move(robots);
    auto views = ODO_TRY(registeredViews(project, d.trial));
    d.views = std::move(views);
    auto guidance = ODO_TRY(editedGuidance(project, d.trial, recordingsOf(d.views), d.settings.guidance));
    d.guidance = std::move(guidance);
    for (RegisteredView &view : d.views)
        view.area = searchedAreaOf(d.guidance.all, view.recording.id);
    if (d.settings.range)
        ODO_TRY(d.keepRegistrations(project));
    ODO_TRY(d.readOptions(project));
    auto pointedOut = ODO_TRY(pointedOutRobots(project, d.trial, d.views, d.robots, d.settings.pointers));
    d.pointedOut = std::move(pointedOut);
    for (RegisteredView &view : d.views)
        view.marks = marksOf(d.pointedOut, view.recording.id);
    const auto imported = ODO_TRY(importedTracksOf(project, d.trial));
    if (!imported.empty())
        return d.takeImported(project);
    auto others = ODO_TRY(otherRobots(project, d.trial.id, d.views, d.robots));
    d.others = std::move(others);
    if (!d.settings.again)
        return d.prepareSync(project);
    auto stored =
        ODO_TRY(storedObservations(project, d.trialName, d.views, d.robots,
                                   d.guidance.isByHandChanged ? StoredAs::Tracked : StoredAs::InForce));
    d.stored = std::move(stored);
    for (std::size_t v = 0; v < d.views.size(); ++v) {
        if (!d.views[v].registration)
            continue;
        const auto shiftPx = notedShift(d.stored[v].series.front(), d.views[v].registration->id);
        if (!shiftPx)
            continue;
        d.views[v].floorView = widenedByShift(*d.views[v].floorView, *shiftPx);
        d.outcome.warnings.push_back(shiftedSentence(d.trialName, d.views[v].recording, *shiftPx));
    }
    return {};
}

/// The views as the newest analyses used them, whatever is in force now.
Result<void> TrackJob::Impl::keepRegistrations(Project &project)
{
    const auto analyses = ODO_TRY(project.analyses().current(trial.id));
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto user = std::ranges::find_if(
            analyses, [&](const AnalysisRecord &one) { return one.registrations.size() == views.size(); });
        if (user == analyses.end())
            return {};
        RegisteredView &view = views[v];
        const RecordId used = user->registrations[v];
        if (used == (view.registration ? view.registration->id : 0))
            continue;
        view.registration.reset();
        view.floorView.reset();
        if (used == 0)
            continue;
        auto registration = ODO_TRY(project.cameras().registration(used));
        view.floorView = ODO_TRY(floorViewAt(project, registration, view.recording));
        view.registration = std::move(registration);
    }
    return {};
}

Result<void> TrackJob::Impl::readOptions(Project &project)
{
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
    isNew = analyses.empty();
    options.clear();
    ambiguities.clear();
    for (const RobotRecord &robot : robots) {
        AnalysisOptions its;
        const auto newest = std::find_if(analyses.begin(), analyses.end(),
                                         [&](const AnalysisRecord &one) { return one.robot == robot.id; });
        if (settings.again && newest != analyses.end())
            its.smoother = newest->options.smoother;
        its.smoother = settings.smoother.value_or(its.smoother);
        auto known =
            ODO_TRY(settings.again && newest != analyses.end() ? project.analyses().ambiguousNames(newest->id)
                                                               : Result<std::vector<AmbiguousName>>());
        ambiguities.push_back(std::move(known));
        const auto given = settings.overrides.find(robot.name);
        auto overrides =
            ODO_TRY(given != settings.overrides.end() ? given->second
                                                      : project.trials().overrides(trial.id, robot.id));
        its.overrides = std::move(overrides);
        options.push_back(std::move(its));
    }
    return {};
}

Result<void> TrackJob::Impl::takeImported(Project &project)
{
    if (!settings.again)
        return fail(ErrorCode::InvalidInput, trialSubject(trialName),
                    ODO_TEXT("workflow.tracks_were_imported",
                             "its tracks were imported, so it has no video to track"),
                    ODO_TEXT("workflow.reanalyse_tracks",
                             "reanalyse them with: odograph track PROJECT TRIAL --again"));
    for (const RobotRecord &robot : robots) {
        auto its = ODO_TRY(project.trials().currentImportedTrack(trial.id, robot.id));
        if (!its)
            return fail(ErrorCode::NotFound, robotInTrialSubject(robot.name, trialName),
                        ODO_TEXT("workflow.no_track_imported", "no track of it was imported"),
                        ODO_TEXT("workflow.choose_robot_of_trial", "choose a robot of the trial"));
        imported.push_back(std::move(its->samples));
    }
    return {};
}

Result<void> TrackJob::Impl::prepareSync(Project &project)
{
    if (std::ranges::none_of(views, isSyncOpen, &RegisteredView::recording))
        return {};
    sync = SyncRequest{trialName, {}};
    for (std::size_t v = 1; v < views.size(); ++v)
        sync->steps.push_back({isSyncOpen(views[v].recording) ? SyncBy::Automatic : SyncBy::Kept});
    sync->robots = robots;
    sync->microphones = ODO_TRY(microphonePositions(project, views));
    sync->mayTakeFields = isNew && mayRecount();
    return {};
}

/// With the frame times as they are found to be.
Result<SettledViews> TrackJob::Impl::trackAll(const JobControl &control)
{
    const auto changes = changesSinceRegistration(views, control.cancel);
    ODO_TRY(checkSameScene(trialName, views, changes));
    outcome.warnings = sceneWarnings(trialName, views, changes);
    const auto isShifted = [&](std::size_t v) {
        return changes[v] && changes[v]->kind == ViewChange::Kind::Shifted;
    };
    for (std::size_t v = 0; v < views.size(); ++v)
        if (isShifted(v) && views[v].floorView)
            views[v].floorView = widenedByShift(*views[v].floorView, changes[v]->shiftPx);
    const std::vector<RegisteredView> before = views;
    constexpr double synchronising = 0.4; // as a part of the work
    if (sync) {
        auto sentences = ODO_TRY(synchroniseViews(views, *sync, trial, partOf(control, 0, synchronising)));
        std::ranges::move(sentences, std::back_inserter(outcome.warnings));
    }
    auto tracked = ODO_TRY(trackSynchronised(sync ? partOf(control, synchronising, 1) : control));
    retimed = retimedRecordings(before, views);
    for (std::size_t v = 0; v < views.size(); ++v)
        if (isShifted(v) && views[v].floorView)
            noteShift(views[v], changes[v]->shiftPx, tracked.views[v].series);
    return tracked;
}

Result<SettledViews> TrackJob::Impl::trackSynchronised(const JobControl &control)
{
    auto tracked = ODO_TRY(trackAndSettle(views, robots, control, pointedOut));
    if (isNew && mayRecount() && !takeFields(views, tracked.views, control.cancel).empty())
        tracked = ODO_TRY(trackAndSettle(views, robots, control, pointedOut));
    ambiguities = ambiguousNamesOf(tracked.ambiguities, robots);
    correctFrameTimes(views, robots, tracked.views);
    return tracked;
}

Result<void> TrackJob::run(const JobControl &control)
{
    Impl &d = *m_impl;
    const auto started = std::chrono::steady_clock::now();
    if (!d.settings.again)
        ODO_TRY(checkRecordings(d.views, control));
    // what is stored is settled
    auto tracked =
        d.settings.again ? Result<SettledViews>(SettledViews{std::move(d.stored), {}}) : d.trackAll(control);
    if (!tracked)
        return tl::unexpected(tracked.error());
    for (Message &warning : stepWarnings(d.trialName, d.views))
        d.outcome.warnings.push_back(std::move(warning));
    for (Message &warning : turnedWarnings(d.trialName, d.views))
        d.outcome.warnings.push_back(std::move(warning));
    for (Message &warning : convertedViewWarnings(d.trialName, d.views))
        d.outcome.warnings.push_back(std::move(warning));
    for (Message &warning : frameStepWarnings(d.trialName, d.views, tracked->views))
        d.outcome.warnings.push_back(std::move(warning));
    for (Message &warning : damageWarnings(d.trialName, d.views, tracked->views))
        d.outcome.warnings.push_back(std::move(warning));
    for (Message &warning : moveWarnings(d.trialName, d.views, tracked->views))
        d.outcome.warnings.push_back(std::move(warning));
    d.correctByHand(tracked->views);
    control.report(0.97, ODO_TEXT("workflow.analysing", "analysing"));
    ODO_TRY(d.analyseAll(tracked->views));

    std::int64_t frames = 0;
    for (TrackedView &view : tracked->views) {
        d.outcome.decodeS += toSeconds(view.decodeCpuTime);
        frames += view.frames;
        if (d.settings.again && !d.guidance.isByHandChanged)
            continue;
        for (ObservationSeries &series : view.series)
            d.observations.push_back(std::move(series));
    }
    d.outcome.trial = d.trialName;
    d.outcome.wallS = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    d.outcome.framesPerSecond = d.outcome.wallS > 0 ? double(frames) / d.outcome.wallS : 0;
    return {};
}

namespace {

/// The observations within a range; of other views than the first those next to it too, for the positions at
/// its ends lie between them.
void keepWithin(const TimeSpan &range, std::vector<ViewTrack> &tracks)
{
    for (std::size_t v = 0; v < tracks.size(); ++v) {
        ViewTrack &track = tracks[v];
        const auto timeOfSeen = [&track](const Observation &one) { return timeOf(track, one); };
        std::vector<Observation> &all = track.observations;
        auto first = std::ranges::lower_bound(all, range.begin, {}, timeOfSeen),
             behind = std::ranges::upper_bound(all, range.end, {}, timeOfSeen);
        if (v > 0 && first != all.begin())
            --first;
        if (v > 0 && behind != all.end())
            ++behind;
        all = std::vector<Observation>(first, behind);
        std::erase_if(track.breaks, [&](Nanoseconds own) {
            const Nanoseconds time = clockOf(track).commonTime(own);
            return time <= range.begin || time > range.end;
        });
    }
}

} // namespace

/// What was just tracked is stored as it is; what is corrected of it is a series of its own.
void TrackJob::Impl::correctByHand(std::vector<TrackedView> &tracked)
{
    if (settings.again && !guidance.isByHandChanged)
        return; // it is already
    for (TrackedView &view : tracked) {
        for (ObservationSeries &series : view.series) {
            auto corrected = correctedByHand(series, guidance.all);
            if (!corrected)
                continue;
            std::swap(series, *corrected);
            if (!settings.again)
                observations.push_back(std::move(*corrected));
        }
    }
}

Result<TaskAnalysis> TrackJob::Impl::analyseOne(std::vector<TrackedView> &tracked, std::size_t robot,
                                                const std::optional<TimeSpan> &range) const
{
    if (!imported.empty()) {
        std::vector<Sample> raw = imported[robot];
        if (range)
            std::erase_if(raw, [&](const Sample &one) { return !range->contains(one.time); });
        return analyseByTask([&](const AnalysisOptions &by) { return analyseImported(raw, by); },
                             optionsForImported(options[robot], raw), task);
    }
    auto tracks = takeViewTracks(views, tracked, robot);
    std::vector<ViewTrack> part = range ? tracks : std::vector<ViewTrack>();
    if (range)
        keepWithin(*range, part);
    const std::vector<ViewTrack> &analysedTracks = range ? part : tracks;
    AnalysisOptions its = options[robot];
    its.overrides = withPointsByHand(std::move(its.overrides), tracks);
    auto analysed = analyseByTask(
        [&](const AnalysisOptions &by) { return analyse(analysedTracks, shapeOf(robots[robot]), by); }, its,
        task);
    returnObservations(std::move(tracks), tracked, robot);
    return analysed;
}

Result<void> TrackJob::Impl::analyseAll(std::vector<TrackedView> &tracked)
{
    for (std::size_t r = 0; r < robots.size(); ++r) {
        const RobotRecord &robot = robots[r];
        const auto floorColour = floorColourOf(robot, trialName, views, tracked, r);
        if (floorColour && floorColour->hardlyEverFound)
            return tl::unexpected(floorColour->error);
        AnalysisRecord analysis = newAnalysis(trial, robot, views, options[r]);
        auto analysed = analyseOne(tracked, r);
        if (!analysed) {
            Error error = analysed.error();
            error.what = robotInTrialSubject(robot.name, trialName);
            bool isAnotherSeen = false;
            for (std::size_t other = 0; imported.empty() && other < robots.size(); ++other)
                isAnotherSeen = isAnotherSeen || isEverSeen(views, tracked, other);
            if (isAnotherSeen && !isEverSeen(views, tracked, r))
                error.advice =
                    ODO_TEXT("workflow.track_those_seen", "track only the robots that are in view (--robot)");
            return tl::unexpected(floorColour ? floorColour->error : error);
        }
        if (floorColour && usedShare(analysed->profile) < leastOfFloorColour)
            return tl::unexpected(floorColour->error);
        analysis.task = task ? task->id : 0;
        analysis.options = std::move(analysed->options);
        analysis.options.overrides = options[r].overrides; // points by hand are none
        analysis.profile = std::move(analysed->profile);
        analysis.ambiguousNames = ambiguities[r];
        if (trial.range)
            ODO_TRY(measureRange(analysis, tracked, r));
        if (!analysed->caveat.isEmpty())
            outcome.warnings.push_back(
                joined({robotInTrialSubject(robot.name, trialName), analysed->caveat}, Join::Colon));
        if (floorColour)
            outcome.warnings.push_back(wholeMessage(floorColour->error));
        for (Message &warning : analysisWarnings(analysis, trialName))
            outcome.warnings.push_back(std::move(warning));
        addOutcome(std::move(analysis));
    }
    if (imported.empty())
        findOcclusionsIn(tracked);
    return cutToRange();
}

/// Of the trial's range, by a new analysis of what is within it: what is outside must not bend its curves or
/// its solid. Where that has too few samples, it is the part of the whole run.
Result<void> TrackJob::Impl::measureRange(AnalysisRecord &analysis, std::vector<TrackedView> &tracked,
                                          std::size_t robot) const
{
    changeRange(analysis, trial.range, task ? &task->task : nullptr);
    if (!hasValidPoint(analysis.profile))
        return nothingMeasuredInRange(analysis.robotName, trialName, *trial.range);
    auto part = analyseOne(tracked, robot, trial.range);
    if (!part || !std::ranges::equal(part->profile.samples, analysis.profile.samples, {}, &Sample::time,
                                     &Sample::time))
        return {};
    analysis.options = std::move(part->options);
    analysis.profile = std::move(part->profile);
    return {};
}

/// Once spikes and occlusions of the whole run are known.
Result<void> TrackJob::Impl::cutToRange()
{
    for (TrackedRobot &robot : outcome.robots) {
        if (robot.analysis.range != trial.range)
            changeRange(robot.analysis, trial.range, task ? &task->task : nullptr);
        const Profile &profile = robot.analysis.profile;
        if (trial.range && !hasValidPoint(profile))
            return nothingMeasuredInRange(robot.name, trialName, *trial.range);
        robot.frames = static_cast<std::int64_t>(profile.samples.size());
        robot.tracked = std::ranges::count_if(
            profile.samples, [](const Sample &sample) { return sample.position.has_value(); });
        if (trial.range)
            std::erase_if(robot.occlusions, [&](const Occlusion &one) {
                return one.span.end < trial.range->begin || one.span.begin > trial.range->end;
            });
        if (robot.ambiguousS)
            robot.ambiguousS = ambiguousSeconds(robot.analysis.ambiguousNames);
    }
    return {};
}

void TrackJob::Impl::findOcclusionsIn(const std::vector<TrackedView> &tracked)
{
    std::vector<const AnalysisRecord *> analyses;
    for (const TrackedRobot &robot : outcome.robots)
        analyses.push_back(&robot.analysis);
    auto occlusions = trackedOcclusions(views, tracked, analyses, others);
    for (std::size_t r = 0; r < occlusions.size(); ++r) {
        removeSpikesOfPassing(occlusions[r], outcome.robots[r].analysis.profile.spikes);
        outcome.robots[r].occlusions = std::move(occlusions[r]);
    }
}

void TrackJob::Impl::addOutcome(AnalysisRecord analysis)
{
    TrackedRobot result;
    result.name = analysis.robotName;
    result.isFoundByColour = std::ranges::any_of(robots, [&](const RobotRecord &robot) {
        return robot.id == analysis.robot && isFoundByColour({robot.name, robot.colour});
    });
    if (!settings.again || !analysis.ambiguousNames.empty())
        result.ambiguousS = ambiguousSeconds(analysis.ambiguousNames);
    result.analysis = std::move(analysis);
    outcome.robots.push_back(std::move(result));
}

/// With the verdict that follows from them.
Result<void> TrackJob::Impl::storeAnalyses(Project &project)
{
    if (settings.range)
        ODO_TRY(project.trials().setRange(trial.id, *settings.range));
    trial.range = ODO_TRY(project.trials().get(trial.id)).range; // as it is now
    ODO_TRY(cutToRange());
    std::vector<AnalysisRecord> made;
    for (TrackedRobot &robot : outcome.robots)
        made.push_back(ODO_TRY(project.analyses().add(std::move(robot.analysis))));
    auto verdict = storeVerdict(project, trial, made);
    for (std::size_t i = 0; i < made.size(); ++i)
        outcome.robots[i].analysis = std::move(made[i]);
    outcome.verdict = ODO_TRY(std::move(verdict));
    return {};
}

Result<void> TrackJob::commit(Project &project)
{
    Impl &d = *m_impl;
    const MessageArgument name = Named::trial(d.trial.name);
    return project.change(
        d.settings.again && d.guidance.isByHandChanged
            ? ODO_TEXT("workflow.correct_by_hand", "correct %1 by hand")(name)
        : d.observations.empty() ? ODO_TEXT("workflow.measure_again", "reanalyse %1")(name)
                                 : ODO_TEXT("workflow.track", "track %1")(name),
        [&]() -> Result<void> {
            if (d.task && !project.tasks().get(d.task->id))
                return fail(ErrorCode::InvalidInput, trialSubject(d.trial.name),
                            ODO_TEXT("workflow.task_was_changed", "its task changed during the analysis"),
                            ODO_TEXT("workflow.measure_it_again", "repeat the analysis"));
            if (d.sync)
                ODO_TRY(project.trials().setSync(d.trial, recordingsOf(d.views)));
            ODO_TRY(project.trials().setFrameTimes(d.retimed));
            for (const ObservationSeries &series : d.observations)
                ODO_TRY(project.trials().addObservations(series));
            if (!d.settings.guidance.isEmpty())
                ODO_TRY(storeGuidance(project, d.guidance));
            if (!d.settings.pointers.empty())
                ODO_TRY(project.trials().setPointedOut(d.trial.id, d.pointedOut));
            ODO_TRY(d.storeAnalyses(project));
            std::vector<RecordId> all = d.trial.robots;
            for (const RobotRecord &robot : d.robots) {
                if (std::find(all.begin(), all.end(), robot.id) == all.end())
                    all.push_back(robot.id);
            }
            return project.trials().setRobots(d.trial.id, all);
        });
}

void TrackJob::synchroniseAs(const std::vector<RecordingRecord> &recordings)
{
    Impl &d = *m_impl;
    for (std::size_t v = 0; v < d.views.size(); ++v) {
        d.views[v].recording = recordings[v];
        for (ObservationSeries &series : d.stored[v].series)
            stampAsRecorded(series.observations, recordings[v].frameTimes);
    }
}

const TrackOutcome &TrackJob::outcome() const
{
    return m_impl->outcome;
}

} // namespace odo
