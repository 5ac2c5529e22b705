// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/record_trial.h"

#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
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
constexpr Nanoseconds startMargin = 2s; // which the project may take to begin a trial

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

/// Sends the robots' positions while it is there.
struct LiveSending
{
    std::unique_ptr<LiveBroadcast> broadcast; // outlives the tracker, which gives it its moments
    std::unique_ptr<LiveTracker> tracker;
};

Result<std::vector<LiveView>> liveViews(Project &project, const RecordSettings &settings)
{
    std::vector<LiveView> views;
    for (const auto &[name, address] : settings.cameras) {
        LiveView view{name, {}};
        if (const auto camera = project.cameras().find(name)) {
            auto floorView = ODO_TRY(floorViewInForce(project, camera->id));
            view.floorView = std::move(floorView);
        }
        views.push_back(std::move(view));
    }
    if (std::ranges::none_of(views, [](const LiveView &view) { return view.floorView.has_value(); }))
        return fail(
            ErrorCode::Undetermined, recordingSubject(settings.trial),
            ODO_TEXT(
                "workflow.no_live_positions",
                "none of its cameras is registered to the floor, so there are no live positions to send"),
            ODO_TEXT("workflow.register_or_do_not_send",
                     "run odograph register for one of them, or leave --ssl-vision out"));
    return views;
}

/// What is to be sent, before a camera is opened.
struct SentRobots
{
    std::vector<LiveView> views;
    std::vector<RobotRecord> robots;
    std::unique_ptr<LiveBroadcast> broadcast;
};

Result<SentRobots> robotsToSend(Project &project, Result<std::vector<RobotRecord>> robots,
                                const RecordSettings &settings)
{
    SentRobots sent;
    if (!settings.broadcast)
        return sent;
    auto views = ODO_TRY(liveViews(project, settings));
    if (!robots)
        return tl::unexpected(robots.error());
    auto broadcast = ODO_TRY(LiveBroadcast::create(*settings.broadcast, *robots));
    sent.views = std::move(views);
    sent.robots = std::move(*robots);
    sent.broadcast = std::move(broadcast);
    return sent;
}

Result<LiveSending> beginSending(SentRobots sent, CaptureSession &session)
{
    LiveSending sending;
    if (!sent.broadcast)
        return sending;
    sending.broadcast = std::move(sent.broadcast);
    std::vector<LiveTracker::Feed> feeds;
    for (std::size_t view = 0; view < sent.views.size(); ++view)
        feeds.push_back(session.subscribeFrames(view, 2));
    auto tracker = LiveTracker::create(
        sent.views, sent.robots, std::move(feeds),
        {{}, [&broadcast = *sending.broadcast](const LiveMoment &moment) { broadcast.take(moment); }});
    if (!tracker)
        return tl::unexpected(tracker.error());
    sending.tracker = std::move(*tracker);
    return sending;
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

/// Until its time is over, or nothing more can be recorded.
Result<void> keepRecording(Project &project, LiveTrial &live, const CaptureSession &session,
                           const RecordSettings &settings, const JobControl &control)
{
    const auto hasEnded = [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; };
    const auto begun = Clock::now();
    auto appended = begun;
    bool wasInPlace = true;
    for (;;) {
        std::this_thread::sleep_for(checkInterval);
        const auto now = Clock::now();
        const double passedS = std::chrono::duration<double>(now - begun).count();
        control.report(std::min(1.0, passedS / settings.seconds),
                       ODO_TEXT("workflow.recording", "recording"));
        if (std::exchange(wasInPlace, project.isInPlace()) && !wasInPlace && settings.warn)
            settings.warn(ODO_TEXT("workflow.project_lost",
                                   "the project file was deleted, renamed or replaced; recording continues, "
                                   "and its contents will be saved at the end"));
        const CaptureHealth health = session.health();
        if (passedS >= settings.seconds || control.isCancelled() || health.disk.ended ||
            std::ranges::any_of(health.views, hasEnded))
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
    auto trial = ODO_TRY(trialOf(project, {.robots = settings.robots, .trial = settings.trial}));
    // none is an error only where they are sent
    const auto robots = robotsToTrack(project, trial, settings.robots);
    auto sent = ODO_TRY(robotsToSend(project, robots, settings));
    auto cameras = ODO_TRY(openCameras(settings, appearancesOf(robots.value_or(std::vector<RobotRecord>()))));
    const Nanoseconds preRoll = fromSeconds(settings.preRollS);
    CaptureSession session(std::move(cameras),
                           {.preRoll = settings.preRollS > 0 ? preRoll + startMargin : 0ns});
    ODO_TRY(waitForFrames(session, settings, control));
    const auto sending = beginSending(std::move(sent), session); // ends before the session does
    if (!sending)
        return tl::unexpected(sending.error());
    ODO_TRY(letRun(settings, control));
    std::vector<std::string> names;
    for (const auto &[name, address] : settings.cameras)
        names.push_back(name);
    project.keepWritingWhenLost(); // it is rescued at the end
    const Nanoseconds at = steadyNow();
    auto live =
        ODO_TRY(LiveTrial::begin(project, std::move(trial), names, session, RunStart{at, at - preRoll}));
    const auto kept = keepRecording(project, *live, session, settings, control);
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
