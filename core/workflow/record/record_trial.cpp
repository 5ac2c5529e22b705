// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/record_trial.h"

#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
#include "core/workflow/record/internal/live_following.h"
#include "core/workflow/record/line_up.h"
#include "core/workflow/record/live_tracking.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

namespace odo {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto checkInterval = 50ms, appendEach = 1000ms, longestStart = 10000ms;
constexpr Nanoseconds startMargin = 3s; // which a gate, and the project, may take to begin a trial

Result<void> checkSettings(Project &project, const RecordSettings &settings)
{
    const Message what = recordingSubject(settings.trial);
    if (settings.cameras.empty())
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.no_camera_given", "no camera was given"),
                    ODO_TEXT("workflow.give_cameras", "give one or more, like --camera A=sim:A"));
    if (!(settings.seconds > 0 && settings.seconds <= longestRecordingS))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.unusual_length", "the duration must be above zero and at most a day"),
                    ODO_TEXT("workflow.give_seconds", "give the seconds, such as 10"));
    if (!(settings.preRollS >= 0 && settings.preRollS <= longestPreRollS))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.unusual_pre_roll", "the pre-roll must be from 0 s to 30 s"),
                    ODO_TEXT("workflow.give_pre_roll", "give a pre-roll of 0 to 30 seconds"));
    if (project.trials().find(settings.trial))
        return trialIsThere(what);
    std::set<std::string> names, addresses;
    for (const auto &[camera, address] : settings.cameras) {
        if (!names.insert(camera).second || !addresses.insert(address).second)
            return fail(
                ErrorCode::InvalidInput, what,
                ODO_TEXT("workflow.camera_given_twice",
                         "camera '%1' or its address '%2' was given twice")(Named::camera(camera), address),
                giveEachViewItsCamera());
    }
    return {};
}

Result<std::vector<std::unique_ptr<CameraSource>>> openCameras(const RecordSettings &settings,
                                                               const std::vector<RobotAppearance> &robots)
{
    std::vector<std::unique_ptr<CameraSource>> cameras;
    for (const auto &[name, address] : settings.cameras) {
        auto source = ODO_TRY(openCamera(address));
        source->showRobots(robots);
        cameras.push_back(std::move(source));
    }
    return cameras;
}

/// The time counts from when all cameras deliver, which may take them a moment.
Result<void> waitForFrames(const CaptureSession &session, const RecordSettings &settings,
                           const JobControl &control)
{
    const auto until = Clock::now() + longestStart;
    for (;;) {
        const std::vector<ViewHealth> views = session.health().views;
        const auto silent = std::ranges::find(views, 0u, &ViewHealth::delivered);
        if (silent == views.end())
            return {};
        if (control.isCancelled())
            return cancelled(recordingSubject(settings.trial));
        if (silent->state == ViewHealth::State::Ended || Clock::now() > until) {
            const std::string &camera =
                settings.cameras[static_cast<std::size_t>(silent - views.begin())].first;
            return fail(ErrorCode::Io, recordingSubject(settings.trial),
                        joined({ODO_TEXT("workflow.camera_gave_no_picture",
                                         "camera '%1' delivered no frame")(Named::camera(camera)),
                                silent->warning ? silent->warning->error.why : Message()},
                               Join::Colon),
                        ODO_TEXT("workflow.check_it_is_connected",
                                 "check that it is connected and not used by another program"));
        }
        std::this_thread::sleep_for(checkInterval);
    }
}

/// The pre-roll.
Result<void> letRun(const RecordSettings &settings, const JobControl &control)
{
    const auto until = Clock::now() + fromSeconds(settings.preRollS);
    while (Clock::now() < until) {
        if (control.isCancelled())
            return cancelled(recordingSubject(settings.trial));
        std::this_thread::sleep_for(std::min<Nanoseconds>(checkInterval, until - Clock::now()));
    }
    return {};
}

/// What is stored in a file that was taken away would go with it.
Result<void> rescueIfLost(const Project &project, LiveTrial &live)
{
    if (project.isInPlace())
        return {};
    const auto rescued = ODO_TRY(rescueProject(project));
    live.addWarning(ODO_TEXT("workflow.project_rescued",
                             "the project file was deleted, renamed or replaced; its contents were saved in "
                             "'%1', the project from now on")(Named::file(rescued)));
    return {};
}

/// A run that starts and ends by the settings' triggers; its seconds are counted besides.
RunControl runOf(const RecordSettings &settings, const std::optional<Task> &task, std::size_t robots)
{
    RunControl run(steadyNow);
    run.prepare({.start = settings.start,
                 .stop = settings.stop,
                 .before = fromSeconds(settings.preRollS),
                 .longest = fromSeconds(longestRecordingS + 2 * longestPreRollS)},
                task, robots);
    return run;
}

Result<std::optional<Task>> taskOf(Project &project, const RecordSettings &settings)
{
    if (settings.task.empty())
        return std::nullopt;
    return ODO_TRY(project.tasks().find(settings.task)).task;
}

bool hasEnded(const ViewHealth &view)
{
    return view.state == ViewHealth::State::Ended;
}

/// The start: at once, or when what starts it by itself has happened.
Result<RunOrder> awaitStart(RunControl &run, LiveFollowing &following, const CaptureSession &session,
                            const RecordSettings &settings, const JobControl &control)
{
    std::optional<RunOrder> order = run.press();
    while (!order) {
        control.report(0, ODO_TEXT("workflow.waiting_for_start", "waiting for the start"));
        if (control.isCancelled())
            return cancelled(recordingSubject(settings.trial));
        if (std::ranges::any_of(session.health().views, hasEnded))
            return fail(ErrorCode::Io, recordingSubject(settings.trial),
                        ODO_TEXT("workflow.camera_ended_before_start", "a camera ended before the start"),
                        ODO_TEXT("workflow.check_it_is_connected",
                                 "check that it is connected and not used by another program"));
        std::this_thread::sleep_for(checkInterval);
        order = following.advance(run);
    }
    return *order;
}

/// Until its time is over, it ends by itself, or nothing more can be recorded.
Result<void> keepRecording(Project &project, LiveTrial &live, const CaptureSession &session, RunControl &run,
                           LiveFollowing &following, const RecordSettings &settings,
                           const JobControl &control)
{
    const Nanoseconds begun = steadyNow() - run.sinceStart();
    auto appended = Clock::now();
    bool wasInPlace = true;
    for (;;) {
        std::this_thread::sleep_for(checkInterval);
        const auto now = Clock::now();
        const double passedS = toSeconds(steadyNow() - begun);
        control.report(std::min(1.0, passedS / settings.seconds),
                       ODO_TEXT("workflow.recording", "recording"));
        if (std::exchange(wasInPlace, project.isInPlace()) && !wasInPlace && settings.warn)
            settings.warn(ODO_TEXT("workflow.project_lost",
                                   "the project file was deleted, renamed or replaced; recording continues, "
                                   "and its contents will be saved at the end"));
        const CaptureHealth health = session.health();
        if (passedS >= settings.seconds || control.isCancelled() || health.disk.ended ||
            following.advance(run) || std::ranges::any_of(health.views, hasEnded))
            return {};
        if (now - appended < appendEach)
            continue;
        appended = now;
        ODO_TRY(live.append(project));
    }
}

} // namespace

Result<std::shared_ptr<LiveTrial>> recordTrial(Project &project, const RecordSettings &settings,
                                               const JobControl &control)
{
    ODO_TRY(checkSettings(project, settings));
    const auto task = ODO_TRY(taskOf(project, settings));
    auto trial = ODO_TRY(
        trialOf(project, {.task = settings.task, .robots = settings.robots, .trial = settings.trial}));
    // none is an error only where they are followed
    const auto robots = robotsToTrack(project, trial, settings.robots);
    auto followed = ODO_TRY(readFollowed(project, robots, settings));
    RunControl run = runOf(settings, task, followed.robots.size());
    auto cameras = ODO_TRY(openCameras(settings, appearancesOf(robots.value_or(std::vector<RobotRecord>()))));
    const bool isKept = settings.preRollS > 0 || settings.start;
    CaptureSession session(std::move(cameras),
                           {.preRoll = isKept ? fromSeconds(settings.preRollS) + startMargin : 0ns});
    ODO_TRY(waitForFrames(session, settings, control));
    const auto following = ODO_TRY(LiveFollowing::begin(std::move(followed), session)); // ends before it
    ODO_TRY(letRun(settings, control));
    std::vector<std::string> names;
    for (const auto &[name, address] : settings.cameras)
        names.push_back(name);
    const RunOrder start = ODO_TRY(awaitStart(run, *following, session, settings, control));
    project.keepWritingWhenLost(); // it is rescued at the end
    auto live =
        ODO_TRY(LiveTrial::begin(project, std::move(trial), names, session, RunStart{start.at, start.from}));
    const auto kept = keepRecording(project, *live, session, run, *following, settings, control);
    // Whoever stops it keeps what is recorded. Where the project could not be written to, the end tries once
    // more, with all that is missing.
    if (auto ended = runToEnd(*live, project, {{}, control.progress}); !ended)
        return tl::unexpected(kept ? ended.error() : kept.error());
    HashJob hashes; // what is left of them is made the next time
    if (auto done = runToEnd(hashes, project, control); !done && done.error().code != ErrorCode::Cancelled)
        return tl::unexpected(done.error());
    ODO_TRY(rescueIfLost(project, *live));
    return live;
}

std::vector<RobotAppearance> appearancesOf(const std::vector<RobotRecord> &robots)
{
    std::vector<RobotAppearance> appearances;
    for (const RobotRecord &robot : robots)
        appearances.push_back({robot.colour, robot.lengthM, robot.widthM, robot.heightM});
    return appearances;
}

} // namespace odo
